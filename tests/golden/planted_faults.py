#!/usr/bin/env python3
"""planted_faults.py PROJECT: small faults in the golden scenes, and which tier of `golden` sees them.

A copy of every scene begins with a few lines that a parameter switches: a light moved by 1 % of its distance
from the origin, an index of refraction raised by 0.01, one vertex normal of a mesh turned around. References
are made without a fault. A fault must fail where it changes the picture, and nothing else may.
"""
import os, shutil, subprocess, sys, tempfile

HERE = os.path.dirname(os.path.abspath(__file__))

FAULTS = """
do
    local fault = gr.param('fault', 'none')
    local light, set_refraction, mesh = gr.light, gr.set_refraction, gr.mesh
    if fault == 'light' then
        function gr.light(at, ...)
            local step = 0.01 * (at[1] ^ 2 + at[2] ^ 2 + at[3] ^ 2) ^ 0.5
            return light({at[1] + 0.60 * step, at[2] + 0.64 * step, at[3] + 0.48 * step}, ...)
        end
    elseif fault == 'index' then
        function gr.set_refraction(node, index, f) return set_refraction(node, index + 0.01, f) end
    elseif fault == 'normal' then
        function gr.mesh(name, file, ...)
            return mesh(name, file == 'ball80.obj' and 'one_normal_turned.obj' or file, ...)
        end
    end
end
"""

# Scenes that a fault changes; the others must not fail.
UNLIT = {"background", "lens"}
TOUCHED = {
    "light": lambda scene: scene not in UNLIT,
    "index": lambda scene: scene == "glass",
    "normal": lambda scene: scene == "mesh_normals",
}
# name, options
TIERS = [("exact", ["--tier", "exact"]), ("portable", ["--tier", "portable"]),
         ("statistical", ["--tier", "statistical", "--spp", "64", "--bits", "16"])]


def plant(folder):
    # A scene with a time limit of its own is compared by its statistics in every tier: once is enough.
    shutil.copytree(HERE, folder, ignore=shutil.ignore_patterns("timed.*"))
    for name in os.listdir(folder):
        path = os.path.join(folder, name)
        if name.endswith(".png"):
            os.remove(path)
        if name.endswith(".lua"):
            with open(path) as f:
                script = f.read()
            with open(path, "w") as f:
                f.write(FAULTS + script)
    with open(os.path.join(folder, "Model", "ball80.obj")) as f:
        lines = f.read().splitlines()
    turned = [i for i, line in enumerate(lines) if line.startswith("vn ")][4]
    lines[turned] = "vn " + " ".join(str(-float(x)) for x in lines[turned].split()[1:])
    with open(os.path.join(folder, "Model", "one_normal_turned.obj"), "w") as f:
        f.write("\n".join(lines) + "\n")


def golden(project, folder, *options):
    """-> exit code, {scene: passed}"""
    done = subprocess.run([project, "golden", folder, "-j", "2", "--report", folder + "_report",
                           *options], capture_output=True,
                          text=True)
    lines = [line for line in done.stdout.splitlines() if line.startswith(("ok  ", "FAIL"))]
    return done.returncode, {line[5:].split(".")[0]: line.startswith("ok") for line in lines}


def check(project, folder, tier, options):
    code, made = golden(project, folder, "--update", *options)
    if code != 0 or not all(made.values()):
        return ["%s: the references cannot be made" % tier]
    problems = []
    for fault in ["none", *TOUCHED]:
        code, passed = golden(project, folder, "-D", "fault=" + fault, *options)
        touched = {s for s in passed if fault != "none" and TOUCHED[fault](s)}
        failed = {s for s in passed if not passed[s]}
        print("%-12s %-7s fails %2d of the %2d scenes that it changes%s" %
              (tier, fault, len(failed & touched), len(touched),
               ": not " + ", ".join(sorted(touched - failed)) if touched - failed and failed else ""))
        if failed - touched:
            problems.append("%s, fault %s: %s should pass" % (tier, fault, ", ".join(sorted(failed - touched))))
        if touched - failed:
            problems.append("%s, fault %s: %s should fail" % (tier, fault, ", ".join(sorted(touched - failed))))
        if len(passed) < 10 or code != (10 if failed else 0):
            problems.append("%s, fault %s: exit code %d, %d scenes" % (tier, fault, code, len(passed)))
    return problems


def main():
    if sys.argv[1:2] in ([], ["--help"]):
        sys.exit(__doc__)
    project = os.path.abspath(sys.argv[1])
    problems = []
    with tempfile.TemporaryDirectory() as outside:
        for tier, options in TIERS:
            folder = os.path.join(outside, tier)
            plant(folder)
            problems += check(project, folder, tier, options)
    for problem in problems:
        print("FAIL " + problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
