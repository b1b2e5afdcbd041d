#!/usr/bin/env python3
"""check.py INTERSECT [--dir DIR] [--prim torus,cone] [--time]

Feeds the cases of DIR/*.txt (format: README.md) to `INTERSECT KIND`, without the answers, and holds what it
prints against the certified hits. Prints a table by primitive and class, and exits 1 where the criteria of
README.md are not met. Needs Python 3.8 and nothing else.
"""
import argparse, lzma, math, os, subprocess, sys

U = 2.0 ** -53
NUM = {"sphere": 4, "box": 6, "cylinder": 5, "cone": 5, "torus": 5, "triangle": 9}
SOLIDS = ["quadric", "csg", "height_field", "frustum", "hemisphere", "disc", "rectangle", "plane"]
MAX_E = {"cone": 8.0}          # scaled error of t; all others 4
MAX_N = {"triangle": 8.0, "height_field": 8.0}      # scaled error of the normal; all others 4
STRICT = 64.0                  # dm/(u S) from which hit or miss must agree


def number(token):
    return float.fromhex(token) if "0x" in token else float(token)


def opened(path):
    return open(path) if os.path.exists(path) else lzma.open(path + ".xz", "rt")


def read_solid(path):
    """Questions of any length, a bar, and answers with their own noise scale and radius of curvature"""
    for line in opened(path):
        if line.startswith("#") or not line.strip():
            continue
        question, answers = line.split("|")
        v = [number(x) for x in question.split()[-7:]]
        tok = answers.split()
        hits = [dict(hi=number(h[0]), lo=number(h[1]), cos=number(h[2]), nm=number(h[3]), noise=number(h[4]),
                     rad=number(h[5]), n=[number(x) for x in h[6:9]])
                for h in (tok[3 + 9 * k:12 + 9 * k] for k in range(int(tok[2])))]
        cls = question.split()[0]
        yield dict(cls=cls, question=question.strip(), o=v[:3], d=v[3:6], tmin=v[6], s=number(tok[0]), dm=number(tok[1]),
                   hits=hits, affine=cls == "affine")


def read(path, prim):
    if prim in SOLIDS:
        yield from read_solid(path)
        return
    for line in opened(path):
        if line.startswith("#") or not line.strip():
            continue
        tok = line.split()
        at = 1 + NUM[prim] + (12 if tok[0] == "affine" else 0)
        question = tok[:at + 7]
        v = [number(x) for x in tok[1:at + 7]]
        s, dm, count = number(tok[at + 7]), number(tok[at + 8]), int(tok[at + 9])
        width = 11 if prim == "triangle" else 9
        hits = []
        for k in range(count):
            h = tok[at + 10 + k * width: at + 10 + (k + 1) * width]
            hits.append(dict(hi=number(h[0]), lo=number(h[1]), cos=number(h[2]), nm=number(h[4]),
                             n=[number(x) for x in h[6:9]]))
        yield dict(cls=tok[0], question=" ".join(question), params=v[:NUM[prim]], o=v[-7:-4], d=v[-4:-1],
                   tmin=v[-1], s=s, dm=dm, hits=hits, affine=tok[0] == "affine")


def curvature_radius(prim, case, hit):
    if "rad" in hit:
        return hit["rad"]
    p, t = case["params"], hit["hi"]
    q = [case["o"][i] + t * case["d"][i] - p[i] for i in range(3)]
    if prim == "sphere":
        return p[3]
    if prim == "cylinder":
        return p[4]
    if prim == "cone":
        return math.hypot(q[0], q[2])
    if prim == "torus":
        return min(p[4], math.hypot(q[0], q[1]))
    return min(p[3:6]) if prim == "box" else max(math.dist(p[0:3], p[3:6]), math.dist(p[0:3], p[6:9]))


def judge(prim, case, answer):
    """-> (kind, E, N): kind is ok, miss, false, wrong, nan or free (too ill-conditioned to judge)"""
    tok = answer.split()
    got = None if tok and tok[0] == "miss" else [number(x) for x in tok[:4]]
    if got is not None and (len(got) < 4 or not all(math.isfinite(x) for x in got)):
        return "nan", 0.0, 0.0
    if case["dm"] < STRICT * U * case["s"]:
        return "free", 0.0, 0.0
    true = next((h for h in case["hits"] if h["hi"] > case["tmin"]), None)
    if true is None or got is None:
        return ("ok" if true is None and got is None else "false" if true is None else "miss"), 0.0, 0.0
    length = math.sqrt(sum(x * x for x in case["d"]))
    noise = U * (true.get("noise", case["s"]) + abs(true["hi"]) * length)
    scaled_t = abs(got[0] - true["hi"] - true["lo"]) * length * true["cos"] / noise
    scaled_n = 0.0
    if not case["affine"] and true["nm"] >= 1024 * U * case["s"] and case["cls"] not in ("sliver", "apex"):
        dn = math.sqrt(sum((a - b) ** 2 for a, b in zip(got[1:], true["n"])))
        scaled_n = dn * curvature_radius(prim, case, true) * true["cos"] / noise
    return ("wrong" if scaled_t > 64 else "ok"), scaled_t, scaled_n


def ask(binary, kind, questions, extra=()):
    run = subprocess.run([binary, kind, *extra], input="\n".join(questions) + "\n", text=True, capture_output=True)
    answers = run.stdout.splitlines()
    if run.returncode != 0 or len(answers) != len(questions):
        sys.exit(f"check.py: {binary} {kind}: exit {run.returncode}, {len(answers)} answers to {len(questions)} "
                 f"cases: {run.stderr.strip()[:300]}")
    return answers, run.stderr


def fans(binary, path):
    lines = [l.split() for l in opened(path) if l.strip() and not l.startswith("#")]
    questions = [" ".join(t[:-2]) for t in lines]
    answers, _ = ask(binary, "fan", questions)
    cracks = sum(a.split()[0] == "miss" for a in answers)
    print(f"fan          {len(lines):6d} cases  cracks {cracks}")
    return cracks == 0


def main():
    arg = argparse.ArgumentParser()
    arg.add_argument("intersect")
    arg.add_argument("--dir", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "public"))
    arg.add_argument("--prim", default=",".join(list(NUM) + SOLIDS + ["fan"]))
    arg.add_argument("--time", action="store_true", help="also pass --time and print what the program says on stderr")
    a = arg.parse_args()
    good = True
    print("primitive    class        cases judged  miss false wrong nan   max E   max N")
    for prim in a.prim.split(","):
        path = os.path.join(a.dir, prim + ".txt")
        if prim == "fan":
            good &= fans(a.intersect, path)
            continue
        cases = list(read(path, prim))
        answers, said = ask(a.intersect, prim, [c["question"] for c in cases], ("--time",) if a.time else ())
        rows = {}
        for case, answer in zip(cases, answers):
            kind, e, n = judge(prim, case, answer)
            row = rows.setdefault(case["cls"], dict(all=0, ok=0, miss=0, false=0, wrong=0, nan=0, free=0, e=0.0, n=0.0))
            row["all"] += 1
            row[kind] += 1
            if kind == "ok":
                row["e"], row["n"] = max(row["e"], e), max(row["n"], n)
        for cls, r in rows.items():
            bad = r["miss"] + r["false"] + r["wrong"] + r["nan"]
            ok = bad == 0 and r["e"] <= MAX_E.get(prim, 4.0) and r["n"] <= MAX_N.get(prim, 4.0)
            good &= ok
            print(f"{prim:12s} {cls:10s} {r['all']:6d} {r['all'] - r['free']:6d} {r['miss']:5d} {r['false']:5d} "
                  f"{r['wrong']:5d} {r['nan']:3d} {r['e']:8.2f} {r['n']:7.2f}{'' if ok else '   <-- short'}")
        if a.time and said.strip():
            print(f"{prim:12s} {said.strip().splitlines()[-1]}")
    print("all criteria met" if good else "criteria NOT met")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
