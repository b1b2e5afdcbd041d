#!/usr/bin/env python3
"""allocations.py PROJECT [--step N]: every N-th allocation of small renders fails, once, or from there on for good.

Each must end with exit code 0, when somebody could do without, or 4; in time; and the older image or the
newer one is whole. Builds allocations.cpp, which is preloaded, with g++.
"""
import concurrent.futures, os, subprocess, sys, tempfile

import harness
from harness import BALL, OLD, png, shot

HERE = os.path.dirname(os.path.abspath(__file__))
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1 2 3 4\n"
EVERYTHING = shot("""
local glass = gr.sphere('s') glass:set_refraction(1.5, 0.1) glass:set_reflection(0.5) root:add_child(glass, white)
root:add_child(gr.mesh('m', 'm.obj'), nil, gr.texture('t.png', {0,0,0}, 0), gr.bumpmap('t.png'))
root:add_child(gr.torus('t', 1, 0.2), gr.material({0.5,0.4,0.3}, {1,1,1}, 9)) gr.background('t.png')
for k, v in pairs{a = 1, b = 2} do print(k, tostring({}), pcall(error, k)) end
""")
# name, script, arguments
RENDERS = [("a ball", BALL, ["--spp", "1"]),
           ("everything", EVERYTHING, ["--error", "0.2", "--max-spp", "8", "--stats", "s.json"])]


class Trial:
    def __init__(self, project, library, folder, arguments):
        self.project, self.library, self.folder, self.arguments = project, library, folder, arguments

    def run(self, output, environment):
        command = [self.project, "scene.lua", "-q", "-j", "2", "-o", output, *self.arguments]
        return subprocess.run(command, cwd=self.folder, capture_output=True, timeout=60,
                              env={"PATH": os.environ["PATH"], "LD_PRELOAD": self.library, **environment})

    def count(self):
        self.run("x.png", {"RT_COUNT_TO": "count"})
        with open(os.path.join(self.folder, "count")) as f:
            return int(f.read())

    def failure(self, at, stays):
        """-> exit code, complaint or """""
        output = os.path.join(self.folder, "x%d.png" % at)
        with open(output, "wb") as f:
            f.write(OLD)
        try:
            done = self.run(output, {"RT_FAIL_AT": str(at), **({"RT_FAIL_STAYS": "1"} if stays else {})})
        except subprocess.TimeoutExpired:
            return None, "does not end"
        with open(output, "rb") as f:
            image = f.read()
        os.remove(output)
        words = done.stderr.decode(errors="replace")
        if done.returncode not in (0, 4):
            return done.returncode, "exit code %d: %s" % (done.returncode, words[-300:])
        if "error: " not in words and done.returncode == 4:
            return 4, "no message"
        # What fails after the image is written, the statistics, does not take it back.
        if not harness.whole_image(image) and (image != OLD or done.returncode == 0):
            return done.returncode, "half an image, or none"
        return done.returncode, ""


def main():
    if sys.argv[1:2] in ([], ["--help"]):
        sys.exit(__doc__)
    project = os.path.abspath(sys.argv[1])
    step = int(sys.argv[sys.argv.index("--step") + 1]) if "--step" in sys.argv else 1
    failures, tried, ended = 0, 0, {0: 0, 4: 0}
    with tempfile.TemporaryDirectory(prefix="rt-allocations-") as outside:
        library = os.path.join(outside, "allocations.so")
        subprocess.run(["g++", "-std=c++20", "-O1", "-shared", "-fPIC", "-o", library,
                        os.path.join(HERE, "allocations.cpp"), "-ldl"], check=True)
        for name, script, arguments in RENDERS:
            folder = os.path.join(outside, name.replace(" ", "_"))
            os.mkdir(folder)
            for path, content in (("scene.lua", script), ("m.obj", OBJ), ("t.png", png(4, 4))):
                harness.put(folder, path, content)
            trial = Trial(project, library, folder, arguments)
            total = trial.count()
            for stays in False, True:
                with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                    numbers = range(1, total + 1, step)
                    for at, (code, complaint) in zip(numbers, pool.map(lambda n: trial.failure(n, stays), numbers)):
                        tried += 1
                        if complaint:
                            failures += 1
                            print("FAILED: %s, allocation %d of %d%s: %s" % (name, at, total, " and all after" if stays else "", complaint))
                        else:
                            ended[code] += 1
            if harness.leftovers(folder):
                failures += 1
                print("FAILED: %s: left behind %s" % (name, harness.leftovers(folder)))
    print("%d failing allocations: %d ended well, %d with exit code 4, %d failed" % (tried, ended[0], ended[4], failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
