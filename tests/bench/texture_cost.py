#!/usr/bin/env python3
"""texture_cost.py PROJECT [--rounds N] [--bumps]: what textures cost a sample, and what averaging them gains;
with --bumps how errors of bump-mapped floors to the horizon fall (minutes).

Times are user CPU time; each round runs all cases once, so that they share the machine's moods, and the median
of their ratios to the first case of the group is shown.
"""
import json, os, statistics, subprocess, sys, tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

FLOOR = """
local root = gr.node('root')
local floor = gr.mesh('floor', 'ground.obj')
floor:scale(%s, %s, %s)
floor:rotate('y', 24)
root:add_child(floor, %s)
gr.background({0.8, 0.8, 0.8})
gr.render(root, 'out.pfm', 320, 240, {0, 2, 8}, {0, -0.3, -1}, {0, 1, 0}, 40, {0.4, 0.4, 0.4},
          {gr.light({-5, 9, 7}, {0.6, 0.6, 0.6}, {1, 0, 0})})
"""
MATERIAL = "gr.material({0.5, 0.5, 0.5}, {0.05, 0.05, 0.05}, 20)"
TEXTURE = "nil, gr.texture('checker.png', {0.05, 0.05, 0.05}, 20)"


BUMPS = """
local root = gr.node('root')
local floor = gr.mesh('floor', 'ground.obj')
floor:scale(320, 320, 320)
floor:rotate('y', 24)
root:add_child(floor, gr.material({0.7, 0.7, 0.7}, {0.4, 0.4, 0.4}, 40), nil, gr.bumpmap('%s'))
gr.background({0.8, 0.85, 0.9}, {0.4, 0.55, 0.8})
gr.render(root, 'out.pfm', 160, 90, {0, 1.7, 7.5}, {-0.02, -0.07, -1}, {0, 1, 0}, 38, {0.2, 0.2, 0.2},
          {gr.light({-5, 9, -7}, {0.6, 0.6, 0.6}, {1, 0, 0})})
"""


def rmse(project, one, two):
    done = subprocess.run([project, "compare", one, two], capture_output=True, text=True)
    return float(done.stdout.split()[1])


def bumps(project, folder):
    out, truth = os.path.join(folder, "out.pfm"), os.path.join(folder, "truth.pfm")
    for name in "studs_normal.png", "ripples_height.png":
        run(project, folder, BUMPS % name, "--reference", "--spp", "4096", "--seed", "9")
        os.replace(out, truth)
        for spp in "16", "64", "256", "1024":
            run(project, folder, BUMPS % name, "--spp", spp)
            print("%-20s %5s samples: RMSE %.4f" % (name, spp, rmse(project, out, truth)))
        render = run(project, folder, BUMPS % name)
        print("%-20s %5.0f samples, default error: RMSE %.4f, estimate %.4f" %
              (name, render["spp_mean"], rmse(project, out, truth), render["error_estimate"]))


def run(project, folder, scene, *options):
    path = os.path.join(folder, "scene.lua")
    with open(path, "w") as f:
        f.write(scene)
    stats = os.path.join(folder, "stats.json")
    subprocess.run([project, path, "-q", "-j", "1", "--stats", stats, "-o", os.path.join(folder, "out.pfm"), *options],
                   check=True, cwd=ROOT)
    with open(stats) as f:
        return json.load(f)["renders"][0]


def cost(render):
    return render["cpu_seconds"] / render["rays"]["camera"] * 1e9


def main():
    if sys.argv[1:2] in ([], ["--help"]):
        sys.exit(__doc__)
    project = os.path.abspath(sys.argv[1])
    rounds = int(sys.argv[sys.argv.index("--rounds") + 1]) if "--rounds" in sys.argv else 5
    near, far = FLOOR % (2000, 2000, 2000, "%s"), FLOOR % (20, 20, 20, "%s")
    # The near floor's texels are larger than a sample's share of a pixel, most of the far one's are smaller.
    cases = [
        ("no texture", far % MATERIAL, ["--spp", "64"]),
        ("near, full resolution", near % TEXTURE, ["--spp", "64", "--reference"]),
        ("near, averaged", near % TEXTURE, ["--spp", "64"]),
        ("far, full resolution", far % TEXTURE, ["--spp", "64", "--reference"]),
        ("far, averaged", far % TEXTURE, ["--spp", "64"]),
    ]
    times = {name: [] for name, _, _ in cases}
    with tempfile.TemporaryDirectory() as folder:
        if "--bumps" in sys.argv:
            return bumps(project, folder)
        for _ in range(rounds):
            for name, scene, options in cases:
                times[name].append(cost(run(project, folder, scene, *options)))
        print("%-24s %12s %10s" % ("64 samples", "ns a sample", "ratio"))
        for name, _, _ in cases:
            ratios = [t / b for t, b in zip(times[name], times["no texture"])]
            print("%-24s %12.0f %10.2f" % (name, min(times[name]), statistics.median(ratios)))
        for error in "0.01", "0.003", "0.001":
            render = run(project, folder, far % TEXTURE, "--error", error)
            print("far, averaged, --error %-6s %6.1f samples a pixel, %.2f s" %
                  (error, render["spp_mean"], render["cpu_seconds"]))


if __name__ == "__main__":
    main()
