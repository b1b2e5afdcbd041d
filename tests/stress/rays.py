"""Certified ray cases of fresh seeds, through every build and instruction set of the intersect tool."""
import os, subprocess, sys

HERE = os.path.dirname(os.path.abspath(__file__))
VECTORS = os.path.join(HERE, "..", "vectors")
sys.path.insert(0, VECTORS)
import check  # noqa: E402

PRIMS = list(check.NUM) + check.SOLIDS


def have_flint():
    try:
        import flint  # noqa: F401
        return True
    except ImportError:
        return False


def ask(way, kind, questions):
    """-> a line for each question"""
    name, command, env = way
    done = subprocess.run(command[:1] + [kind] + command[1:], input="\n".join(questions) + "\n", text=True,
                          capture_output=True, env=env)
    answers = done.stdout.splitlines()
    if done.returncode or len(answers) != len(questions):
        raise RuntimeError("intersect %s (%s): exit %d, %d answers to %d questions: %s" % (
            kind, name, done.returncode, len(answers), len(questions), done.stderr[:300]))
    return answers


def same_everywhere(ways, kind, questions, report, repeat):
    """-> the answers of the first way, which all others must give to the bit"""
    first = ask(ways[0], kind, questions)
    for way in ways[1:]:
        other = ask(way, kind, questions)
        bad = [i for i, (a, b) in enumerate(zip(first, other)) if a != b]
        where = "%s: '%s' against '%s': %s" % (repeat, first[bad[0]], other[bad[0]], questions[bad[0]]) if bad else ""
        report.law("same bits", "rays, %s as %s" % (way[0], ways[0][0]), len(questions), 0, bad=len(bad), repeat=where)
    return first


def judge_file(ways, prim, path, report, repeat):
    cases = list(check.read(path, prim))
    answers = same_everywhere(ways, prim, [c["question"] for c in cases], report, repeat)
    for case, answer in zip(cases, answers):
        kind, e, n = check.judge(prim, case, answer)
        report.ray(prim, case["cls"], kind, e, n, check.MAX_E.get(prim, 4.0), check.MAX_N.get(prim, 4.0),
                   "%s: '%s' answered to: %s" % (repeat, answer, case["question"]))


def judge_fans(ways, path, report, repeat):
    lines = [line.split() for line in check.opened(path) if line.strip() and not line.startswith("#")]
    questions = [" ".join(tokens[:-2]) for tokens in lines]
    for question, answer in zip(questions, same_everywhere(ways, "fan", questions, report, repeat)):
        kind = "miss" if answer == "miss" else "nan" if "nan" in answer or "inf" in answer else "ok"
        report.ray("fan", "crack", kind, 0.0, 0.0, 1.0, 1.0, "%s: %s" % (repeat, question))


def judge_public(ways, report):
    folder = os.path.join(VECTORS, "public")
    for prim in PRIMS:
        judge_file(ways, prim, os.path.join(folder, prim + ".txt"), report, "public cases")
    judge_fans(ways, os.path.join(folder, "fan.txt"), report, "public cases")


def fresh(ways, prim, seed, count, folder, report):
    """`count` cases of each class of one primitive; fans come with the triangles."""
    repeat = "gen.py --prim %s --seed %d --n %d" % (prim, seed, count)
    done = subprocess.run([sys.executable, os.path.join(VECTORS, "gen.py"), "--seed", str(seed), "--n", str(count),
                           "--prim", prim, "--out", folder], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(repeat + ": " + done.stderr[-500:])
    judge_file(ways, prim, os.path.join(folder, prim + ".txt"), report, repeat)
    if prim == "triangle":
        judge_fans(ways, os.path.join(folder, "fan.txt"), report, repeat)
