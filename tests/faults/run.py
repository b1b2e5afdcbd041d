#!/usr/bin/env python3
"""run.py PROJECT [ID...] [-v]: bad input and faults, by the tables beside this file.

Every id of the contract is covered by a case here, held by a named test elsewhere, or listed as absent
with its reason; the last line counts them. IDs pick cases; -v shows what the program said.
"""
import concurrent.futures, os, re, sys, time

import arguments, command_line, graph, harness, images, loading, meshes, numerics, output, resume, sandbox, shards, signals
from elsewhere import ABSENT, ELSEWHERE

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SECTIONS = [command_line, loading, sandbox, arguments, graph, meshes, images, numerics, output, signals, shards, resume]
ROWS = {"A": 16, "B": 12, "C": 28, "D": 27, "E": 10, "F": 19, "G": 14, "H": 13, "I": 18, "J": 15, "K": 12}
ALL = ["%s%d" % (letter, i + 1) for letter, count in ROWS.items() for i in range(count)]


def coverage(cases):
    """-> complaints about ids that nobody holds, or that are held and absent"""
    covered = {one for case in cases for one in case.ids}
    wrong = ["%s is in no table" % one for one in ALL if one not in covered | ELSEWHERE.keys() | ABSENT.keys()]
    wrong += ["%s is no case of the contract" % one for one in covered | ELSEWHERE.keys() | ABSENT.keys()
              if one not in ALL]
    wrong += ["%s is covered and absent" % one for one in ABSENT if one in covered or one in ELSEWHERE]
    for one, (path, title) in ELSEWHERE.items():
        with open(os.path.join(TOP, path)) as f:
            # A long title is broken over lines.
            text = re.sub(r'"\s*\n\s*"', "", f.read())
        if title not in text:
            wrong.append("%s: %s has no %r" % (one, path, title))
    return wrong, covered


def attempt(project, case, sanitized):
    if case.heavy and sanitized:
        return case, [], None, "memory limits mean something else under sanitizers"
    try:
        wrong, run = harness.complaints(project, case)
        return case, wrong, run, None
    except harness.Skip as why:
        return case, [], None, str(why)


def main():
    if sys.argv[1:2] in ([], ["--help"]):
        sys.exit(__doc__)
    words = [word for word in sys.argv[1:] if word != "-v"]
    verbose = "-v" in sys.argv
    project, wanted = os.path.abspath(words[0]), set(words[1:])
    every = [case for section in SECTIONS for case in section.CASES]
    wrong, covered = coverage(every)
    cases = [case for case in every if not wanted or wanted & set(case.ids)]
    sanitized = harness.is_sanitized(project)
    failures, skipped, began = 0, 0, time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for case, bad, run, why in pool.map(lambda one: attempt(project, one, sanitized), cases):
            title = "%s, %s" % (" ".join(case.ids), case.name)
            if why:
                skipped += 1
                print("skipped: %s: %s" % (title, why))
            failures += bool(bad)
            for complaint in bad:
                print("FAILED: %s: %s" % (title, complaint))
            if run and (bad or verbose):
                print("    [%s, %.2f s] %s" % (run.code, run.seconds, run.errors[-1500:].replace("\n", "\n    ")))
    for complaint in wrong:
        print("FAILED: " + complaint)
    print("%d runs, %d failed, %d skipped in %.0f s; %d ids: %d by runs here, %d by tests elsewhere, %d absent" %
          (len(cases), failures, skipped, time.monotonic() - began, len(ALL), len(covered),
           len(ELSEWHERE.keys() - covered), len(ABSENT)))
    return 1 if failures or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
