#!/usr/bin/env python3
"""startup.py PROJECT [OTHER...]: what starting costs: instructions (valgrind's callgrind counts them exactly)
of --version and of a scene of 8x8 pixels, and shared objects; then the scene's time and memory without and with each
option that a plain render does without.

Prints two markdown tables: a column for each program, and of the first one a row for each option.
"""
import os, re, statistics, subprocess, sys, tempfile, time

SCENE = """
gr.param('n', 1)
local root = gr.node('root')
root:add_child(gr.sphere('ball'), gr.material({0.8, 0.4, 0.2}, {0.3, 0.3, 0.3}, 20))
gr.render(root, 'ball.png', 8, 8, {0, 1, 5}, {0, -0.2, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {0.8, 0.8, 0.8}, {1, 0, 0})})
"""
TINY = ["scene.lua", "-q", "--spp", "1", "-j", "1", "--isa", "baseline"]


def run(folder, *command):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=300)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout + done.stderr


def instructions(folder, *command):
    said = run(folder, "valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command)
    return int(re.search(r"Collected : (\d+)", said)[1])


def opened(folder, project):
    """Shared objects that the tiny scene opens."""
    said = run(folder, "env", "LD_DEBUG=files", project, *TINY)
    return len(set(re.findall(r"calling init: (\S+)", said)))


def measured(folder, project):
    return {
        "instructions of `--version`, millions": "%.2f" % (instructions(folder, project, "--version") / 1e6),
        "instructions of 8x8 pixels, millions": "%.2f" % (instructions(folder, project, *TINY) / 1e6),
        "shared objects linked (`ldd`)": len(run(folder, "ldd", project).strip().splitlines()),
        "shared objects opened for 8x8 pixels": opened(folder, project),
    }


# What may be asked for beside an image.
BESIDE = [[], ["-D", "n=2"], ["--param-file", "n.params"], ["--check"], ["--explain"], ["--stats", "s.json"],
          ["--deps", "d"], ["--frames", "1"], ["--crop", "0,0,8,8"], ["--pixel", "4,4"], ["--resume"], ["--shard", "1/1"],
          ["--aov", "depth,id"], ["-o", "x.exr"], ["-o", "x.tif"]]
TURNS = 41


def shot(folder, project, more):
    """-> (wall milliseconds, most resident MB) of one run"""
    began = time.monotonic()
    process = subprocess.Popen([project, *TINY, *more], cwd=folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = status
    assert status == 0, more
    return (time.monotonic() - began) * 1e3, usage.ru_maxrss / 1024


def print_options(folder, project):
    """in turns, so that a busy moment meets all of them"""
    shots = [[] for _ in BESIDE]
    for _ in range(TURNS):
        for taken, more in zip(shots, BESIDE):
            taken.append(shot(folder, project, more))
    print("\n| 8x8 pixels with | ms, median of %d | least | MB | instructions, millions |\n"
          "| --- | --: | --: | --: | --: |" % TURNS)
    for taken, more in zip(shots, BESIDE):
        ms, mb = zip(*taken)
        count = instructions(folder, project, *TINY, *more) / 1e6
        print("| %s | %.2f | %.2f | %.1f | %.2f |" % ("`%s`" % " ".join(more) if more else "nothing more",
                                                   statistics.median(ms), min(ms), statistics.median(mb), count))


def main():
    if sys.argv[1:2] in ([], ["--help"]):
        sys.exit(__doc__)
    projects = [os.path.abspath(name) for name in sys.argv[1:]]
    with tempfile.TemporaryDirectory() as folder:
        for name, text in ("scene.lua", SCENE), ("n.params", "n = 2\n"):
            with open(os.path.join(folder, name), "w") as f:
                f.write(text)
        columns = [measured(folder, project) for project in projects]
        print("| | %s |\n| --- |%s" % (" | ".join(sys.argv[1:]), " --: |" * len(columns)))
        for name in columns[0]:
            print("| %s | %s |" % (name, " | ".join(str(column[name]) for column in columns)))
        print_options(folder, projects[0])


if __name__ == "__main__":
    main()
