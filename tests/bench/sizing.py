#!/usr/bin/env python3
"""sizing.py PROJECT: what a machine needs for a scene: memory a pixel, a triangle and an object, how the time grows
with pixels and with the error, and what shards gain. Prints markdown tables; takes about two minutes."""
import argparse, json, math, os, subprocess, tempfile, time

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENE = os.path.join(TOP, "scenes", "soft_shadow.lua")
VIEW = "{0, 3, 6}, {0, -0.4, -1}, {0, 1, 0}, 45, {0.3, 0.3, 0.3}, {gr.light({5, 8, 5}, {0.7, 0.7, 0.7}, {1, 0, 0})})"
GREY = "gr.material({0.6, 0.6, 0.6}, {0, 0, 0}, 0)"
MESH = ("local r = gr.node('r') r:add_child(gr.mesh('m', 'grid.obj'), %s)\n"
        "gr.render(r, 'x.png', 64, 36, %s" % (GREY, VIEW))
OBJECTS = ("local r, grey, n = gr.node('r'), %s, gr.param('n', 1)\nlocal ball = gr.nh_sphere('ball', {0, 0, 0}, 0.1)\n"
           "for i = 1, n do local p = gr.node('p' .. i) p:translate(i %% 1000 * 0.01 - 5, 0, -(i // 1000) * 0.01)\n"
           "p:add_child(ball, grey) r:add_child(p) end\ngr.render(r, 'x.png', 64, 36, %s" % (GREY, VIEW))


# The least of so many counts: others may use the machine.
TRIES = 3


class Bench:
    def __init__(self, project, folder):
        self.project, self.folder = project, folder

    def command(self, scene, *words):
        return [self.project, scene, "-q", "--stats", "s.json", "-o", "x.png", *words]

    def run(self, scene, *words):
        """-> (wall seconds, the statistics)"""
        began = time.monotonic()
        subprocess.run(self.command(scene, *words), cwd=self.folder, check=True)
        seconds = time.monotonic() - began
        with open(os.path.join(self.folder, "s.json")) as f:
            return seconds, json.load(f)["renders"][0]

    def put(self, name, text):
        with open(os.path.join(self.folder, name), "w") as f:
            f.write(text)


def grid(triangles):
    """a height field as OBJ"""
    n = int((triangles / 2) ** 0.5)
    lines = ["v %g %g %g" % (10 * x / n - 5, 0.3 * ((x * y) % 7) / 7, -10 * y / n) for y in range(n + 1) for x in range(n + 1)]
    for y in range(n):
        for x in range(n):
            a = y * (n + 1) + x + 1
            lines.append("f %d %d %d %d" % (a, a + 1, a + n + 2, a + n + 1))
    return "\n".join(lines) + "\n"


def memory(bench):
    print("| of | from | to | bytes each at the peak | seconds for a million: script | loading, building |\n"
          "| --- | --: | --: | --: | --: | --: |")

    def row(what, ends, shots):
        (_, a), (wall, b) = shots
        each = (b["peak_rss_bytes"] - a["peak_rss_bytes"]) / (ends[1] - ends[0])
        build = b["build_seconds"] * 1e6 / ends[1]
        script = (wall - b["build_seconds"] - b["render_seconds"]) * 1e6 / ends[1]
        print("| %s | %s | %s | %.0f | %.2f | %.2f |" % (what, *("{:,}".format(e) for e in ends), each, script, build))

    for name, words in ("pixel, `--spp`", ("--spp", "1")), ("pixel, `--error`", ("--error", "0.05")):
        sizes = ("640x360", "3840x2160")
        a, b = (bench.run(SCENE, "--size", s, *words)[1]["peak_rss_bytes"] for s in sizes)
        print("| %s | %s | %s | %.0f | - | - |" % (name, *sizes, (b - a) / (3840 * 2160 - 640 * 360)))
    bench.put("mesh.lua", MESH)
    ends, shots = [], []
    for triangles in 200_000, 2_000_000:
        bench.put("grid.obj", grid(triangles))
        shots.append(bench.run("mesh.lua", "--spp", "1"))
        ends.append(shots[-1][1]["triangles"])
    row("triangle of an OBJ file", ends, shots)
    bench.put("objects.lua", OBJECTS)
    ends = [20_000, 400_000]
    row("object placed", ends, [bench.run("objects.lua", "--spp", "1", "-D", "n=%d" % n) for n in ends])


def growth(bench):
    print("\n| soft_shadow.lua | render, CPU seconds | samples a pixel | microseconds a pixel |\n| --- | --: | --: | --: |")
    for size, words in [("320x180", ("--error", "0.003")), ("640x360", ("--error", "0.003")), ("1280x720", ("--error", "0.003")),
                        ("640x360", ("--error", "0.006")), ("640x360", ("--error", "0.0015")),
                        ("640x360", ("--spp", "4")), ("640x360", ("--spp", "16"))]:
        _, s = bench.run(SCENE, "--size", size, *words)
        print("| %s `%s` | %.2f | %.1f | %.1f |" % (size, " ".join(words), s["cpu_seconds"], s["spp_mean"],
                                               s["cpu_seconds"] * 1e6 / (s["width"] * s["height"])))


def shard(bench, spp, i, n):
    began = time.monotonic()
    command = bench.command(SCENE, "--size", "320x180", "--spp", str(spp), "-j", "1", "--shard", "%d/%d" % (i, n))
    command[command.index("s.json")] = "s%d.json" % i
    return began, subprocess.Popen(command, cwd=bench.folder)


def at_once(bench, spp):
    """seconds of two shards at the same time"""
    last = 0.0
    for began, process in [shard(bench, spp, i, 2) for i in (1, 2)]:
        assert process.wait() == 0
        last = max(last, time.monotonic() - began)
    return last


def stats_of(bench, i):
    with open(os.path.join(bench.folder, "s%d.json" % i)) as f:
        return json.load(f)["renders"][0]


def shards(bench, spp):
    """two at once are measured; of more, what the slowest of them took alone"""
    words = ("--size", "320x180", "--spp", str(spp), "-j", "1")
    whole, stats = min((bench.run(SCENE, *words) for _ in range(TRIES)), key=lambda shot: shot[0])
    fixed = whole - stats["render_seconds"]
    print("\nsoft_shadow.lua, 320x180, `--spp %d`, one thread: %.2f s, of it %.2f s for start, script, loading and writing.\n" %
          (spp, whole, fixed))
    print("| shards | seconds to the last | `merge` | slowest / mean rendering | speed-up | model |\n"
          "| --: | --: | --: | --: | --: | --: |")
    for n in 2, 4, 8, 16, 32:
        last = min(at_once(bench, spp) for _ in range(TRIES)) if n == 2 else 0.0
        renders = []
        for i in range(1, n + 1):
            seconds = math.inf
            for _ in range(TRIES if n > 2 else 0):
                began, process = shard(bench, spp, i, n)
                assert process.wait() == 0
                seconds = min(seconds, time.monotonic() - began)
            if n > 2:
                last = max(last, seconds)
            renders.append(stats_of(bench, i)["cpu_seconds"])
        began = time.monotonic()
        subprocess.run([bench.project, "merge", "m.png", *["x.%d-of-%d.part" % (i, n) for i in range(1, n + 1)]],
                       cwd=bench.folder, check=True, capture_output=True)
        merge = time.monotonic() - began
        model = whole / (fixed + stats["render_seconds"] / n + merge)
        print("| %d%s | %.2f | %.2f | %.2f | %.1f | %.1f |" % (n, "" if n == 2 else " *", last, merge,
                                                         max(renders) * n / sum(renders), whole / (last + merge), model))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("project")
    parser.add_argument("--spp", type=int, default=64, help="samples of the sharded picture")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(os.path.abspath(options.project), folder)
        memory(bench)
        growth(bench)
        shards(bench, options.spp)


if __name__ == "__main__":
    main()
