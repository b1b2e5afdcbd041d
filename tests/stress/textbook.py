#!/usr/bin/env python3
"""textbook.py [--intersect FILE] [--dir DIR] [--picture OUT.png]: the textbooks' formulas beside this program's.

Builds textbook.cpp, puts the certified cases of DIR to both, and prints for each primitive and kind of case

    bad answers (missed, false, wrong, not a number) of a million well-conditioned rays | largest error E of the rest

where E = 1 is what moving the input by one rounding explains. --picture draws what that looks like.
"""
import argparse, os, struct, subprocess, sys, tempfile, zlib

import rays
from rays import check
from solids import *

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GROUPS = [("typical", ["typical", "inside"]), ("origin 1e3 .. 1e9 away", ["far1e3", "far1e6", "far1e9"]),
          ("scale 1e-6 .. 1e6", ["scale0", "scaleoff"]),
          ("grazing, edges, apex", ["graze", "rim", "edge", "exactedge", "parallel", "apex", "generator", "inflect"]),
          ("leaving, entering", ["leave", "enter"]), ("thin, spindle, horn, sliver", ["thin", "spindle", "horn", "sliver", "huge"]),
          ("along axes, special", ["axis", "special", "biquad", "dirscale"]), ("under a map", ["affine"])]
PANEL = (160, 120)


def judged(program, prim, path):
    """{group: (cell of the table)}"""
    cases = list(check.read(path, prim))
    answers, _ = check.ask(program, prim, [c["question"] for c in cases])
    sums = {}
    for case, answer in zip(cases, answers):
        kind, e, _ = check.judge(prim, case, answer)
        group = next(name for name, classes in GROUPS if case["cls"] in classes)
        row = sums.setdefault(group, [0, 0, 0.0])
        row[0] += kind != "free"
        row[1] += kind not in ("ok", "free")
        row[2] = max(row[2], e if kind == "ok" else 0.0)
    return {g: "%d \\| %.1f" % (1e6 * bad / max(1, count), e) for g, (count, bad, e) in sums.items()}


def cracks(program, path):
    questions = [" ".join(line.split()[:-2]) for line in check.opened(path) if line.strip() and line[0] != "#"]
    answers, _ = check.ask(program, "fan", questions)
    return "%d of %d" % (sum(a == "miss" for a in answers), len(questions))


def table(programs, folder):
    print("| | " + " | ".join(name for name, _ in GROUPS) + " |\n|---|" + "---|" * len(GROUPS))
    for prim in rays.PRIMS:
        for name, program in programs:
            cells = judged(program, prim, os.path.join(folder, prim + ".txt"))
            print("| %s, %s | " % (prim, name) + " | ".join(cells.get(g, "") for g, _ in GROUPS) + " |", flush=True)
    for name, program in programs:
        print("rays through the closed fans that are lost, %s: %s" % (name, cracks(program, os.path.join(folder, "fan.txt"))))


def panel(program, kind, parameters, away, width):
    """Grey values: a solid seen from `away`, `width` across, in light from the eye's upper left."""
    eye = [away * x for x in unit([0.35, -0.6, 0.72])] if kind == "torus" else [away * x for x in unit([0.3, 0.45, 0.84])]
    forward = unit([-x for x in eye])
    right = unit(cross(forward, [0, 0, 1] if kind == "torus" else [0, 1, 0]))
    above = cross(right, forward)
    light = unit(add(add([-x for x in forward], right, -0.5), above, 0.7))
    step = width / PANEL[0]
    questions = []
    for y in range(PANEL[1]):
        for x in range(PANEL[0]):
            target = add([(x + 0.5 - PANEL[0] / 2) * step * r for r in right], above, -(y + 0.5 - PANEL[1] / 2) * step)
            d = unit(add(target, eye, -1.0))
            questions.append("x " + " ".join(float(v).hex() for v in parameters + eye + d + [0.0]))
    answers, _ = check.ask(program, kind, questions)
    grey = []
    for answer in answers:
        if answer == "miss":
            grey.append(235)
            continue
        normal = [check.number(t) for t in answer.split()[1:4]]
        cosine = dot(normal, light)
        grey.append(int(30 + 190 * cosine) if cosine > 0 else 30)
    return grey


def write_png(path, rows):
    chunk = lambda tag, data: struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0))
                + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def draw(programs, path):
    """Above the textbooks', below this program's: a torus from 2e4 and from 1e6 away, a cone from 3e8 away."""
    scenes = [("torus", [0, 0, 0, 1, 0.4], 2e4, 3.4), ("torus", [0, 0, 0, 1, 0.4], 1e6, 3.4),
              ("cone", [0, -0.8, 0, 1.6, 0.9], 3e8, 3.0)]
    rows = []
    for _, program in programs:
        panels = [panel(program, kind, [float(p) for p in parameters], *rest) for kind, parameters, *rest in scenes]
        for y in range(PANEL[1]):
            rows.append([v for p in panels for v in p[y * PANEL[0]:(y + 1) * PANEL[0]]])
    write_png(path, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--intersect", default=os.path.join(TOP, "build", "intersect"))
    parser.add_argument("--dir", default=os.path.join(rays.VECTORS, "public"))
    parser.add_argument("--picture")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="textbook-") as folder:
        program = os.path.join(folder, "textbook")
        subprocess.run(["g++", "-std=c++20", "-O2", "-ffp-contract=off", os.path.join(TOP, "tests/stress/textbook.cpp"),
                        "-o", program], check=True)
        programs = [("textbook", program), ("here", arguments.intersect)]
        if arguments.picture:
            draw(programs, arguments.picture)
        else:
            table(programs, arguments.dir)


if __name__ == "__main__":
    sys.exit(main())
