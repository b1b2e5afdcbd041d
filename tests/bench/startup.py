#!/usr/bin/env python3
"""startup.py PROJECT [OTHER...]: what starting costs: instructions (valgrind's callgrind counts them exactly)
of --version and of a scene of 8x8 pixels, and shared objects.

Prints a markdown table, a column for each program.
"""
import os, re, subprocess, sys, tempfile

SCENE = """
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


def main():
    projects = [os.path.abspath(name) for name in sys.argv[1:]]
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "scene.lua"), "w") as f:
            f.write(SCENE)
        columns = [measured(folder, project) for project in projects]
    for name in columns[0]:
        print("| %s | %s |" % (name, " | ".join(str(column[name]) for column in columns)))


if __name__ == "__main__":
    main()
