#!/usr/bin/env python3
"""run.py PROJECT [--update]: renders every scene in this folder and holds it against its image.

Each scene says in its first comment why its image is right. An image may differ from another compiler's
or processor's by roundings alone, so it is compared by RMSE; --update writes an image only after two equal
renders.
"""
import os, subprocess, sys, tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
TOLERANCE = "0.0005"  # an eighth of one step of an 8-bit image


def render(project, scene, output, threads):
    done = subprocess.run([project, scene, "-q", "--spp", "16", "-j", threads, "-o", output], capture_output=True,
                          text=True)
    if done.returncode != 0:
        print(done.stderr)
    return done.returncode == 0


def check(project, name, update):
    scene, reference = os.path.join(HERE, name + ".lua"), os.path.join(HERE, name + ".png")
    with tempfile.TemporaryDirectory() as folder:
        one, two = os.path.join(folder, "1.png"), os.path.join(folder, "2.png")
        if not (render(project, scene, one, "1") and render(project, scene, two, "3")):
            return "does not render"
        bytes_one, bytes_two = open(one, "rb").read(), open(two, "rb").read()
        if bytes_one != bytes_two:
            return "1 and 3 threads differ"
        if update:
            with open(reference, "wb") as f:
                f.write(bytes_one)
            return ""
        if not os.path.exists(reference):
            return "has no reference image (--update makes one)"
        done = subprocess.run([project, "compare", one, reference, "--tolerance", TOLERANCE], capture_output=True,
                              text=True)
        return "" if done.returncode == 0 else (done.stdout + done.stderr).strip()


def main():
    project = os.path.abspath(sys.argv[1])
    names = sorted(f[:-4] for f in os.listdir(HERE) if f.endswith(".lua"))
    failures = 0
    for name in names:
        problem = check(project, name, "--update" in sys.argv)
        print("%s %s%s" % ("FAIL" if problem else "ok  ", name, ": " + problem if problem else ""))
        failures += bool(problem)
    print("%d passed, %d failed" % (len(names) - failures, failures))
    return 1 if failures or not names else 0


if __name__ == "__main__":
    sys.exit(main())
