#!/usr/bin/env python3
"""run.py [--seconds S] [--seed N]: the stress suite. Exit 1 where anything does not hold.

Until the time is up, in rounds of fresh seeds:

    rays      certified cases of every class of every primitive through build/intersect (../vectors/README.md);
              fresh ones need python-flint, the public ones do not
    same bits the same answers, and the same bytes of images, from every instruction set, from a processor with
              AVX2 and FMA masked, and from every build in build/ that there is
    laws      rendered scenes at any scale, place and map against pictures or formulas (laws.py)

Every failure is printed with what repeats it: `--seed N --only NAME --rounds 1` for a law.
"""
import argparse, os, random, sys, tempfile, time

import laws, rays, variants
from picture import Studio
from report import Report
from solids import KINDS, Solid

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, help="of the first round; the next rounds count on from it")
    parser.add_argument("--rounds", type=int, help="so many rounds, whatever the time")
    parser.add_argument("--cases", type=int, default=8, help="fresh cases of each class in a round")
    parser.add_argument("--only", default="", help="laws and parts whose name contains this")
    parser.add_argument("--project", default=os.path.join(TOP, "Project"))
    parser.add_argument("--intersect", default=os.path.join(TOP, "build", "intersect"))
    arguments = parser.parse_args()
    if arguments.seed is None:
        arguments.seed = random.SystemRandom().randrange(10 ** 9)
    for program in arguments.project, arguments.intersect:
        if not os.access(program, os.X_OK):
            parser.error(program + " is not built")
    return arguments


def image_bytes(ways, folder, seed, report):
    """One scene of everything, in each format, from each way to run the program."""
    rng = random.Random("%d/image_bytes" % seed)
    script = variants.EVERYTHING % ", ".join(Solid(kind, rng).lua() for kind in KINDS)
    for ending in "png", "pfm", "exr":
        first = None
        for name, command, env in ways:
            if ending == "exr" and not variants.has_plugin(command[0]):
                continue
            data = Studio(command[0], folder, command[1:], env).bytes_of(script, "out." + ending, "--spp", "4")
            first = first or data
            report.law("same bits", "%s, %s" % (ending, name), 1, 0, bad=int(data != first),
                       repeat="--seed %d --only image_bytes" % seed)


def parts(arguments, seed, folder, report):
    """(name, what to do) in an order that gives each kind of work its share of a short run."""
    ray_ways = variants.ways(arguments.intersect, TOP, "intersect", ["sphere"])
    image_ways = variants.ways(arguments.project, TOP, "Project", ["-", "--check", "-q"])
    studio = Studio(arguments.project, folder)
    fresh = [("rays/" + prim, lambda p=prim: rays.fresh(ray_ways, p, seed, arguments.cases, folder, report))
             for prim in rays.PRIMS] if rays.have_flint() else []
    scenes = []
    for name, law in laws.all_laws():
        repeat = "--seed %d --only %s --rounds 1" % (seed, name)
        scenes.append((name, lambda l=law, n=name, r=repeat: l(random.Random("%d/%s" % (seed, n)), studio, report, r)))
    scenes.append(("image_bytes", lambda: image_bytes(image_ways, folder, seed, report)))
    if seed == arguments.seed:
        scenes.append(("public rays", lambda: rays.judge_public(ray_ways, report)))
    every = max(1, len(scenes) // max(1, len(fresh)))
    for i, scene in enumerate(scenes):
        yield scene
        if i % every == every - 1 and fresh:
            yield fresh.pop(0)
    yield from fresh


def main():
    arguments = parse()
    print("stress: --seed %d, %g seconds" % (arguments.seed, arguments.seconds), flush=True)
    if not rays.have_flint():
        print("python-flint is missing (pip install python-flint): NO FRESH RAY CASES, the public ones only",
              flush=True)
    report = Report()
    start = time.monotonic()
    rounds = 0
    more = lambda: (rounds < arguments.rounds if arguments.rounds else
                    rounds == 0 or time.monotonic() - start < arguments.seconds)
    with tempfile.TemporaryDirectory(prefix="stress-") as folder:
        while more():
            for name, work in parts(arguments, arguments.seed + rounds, folder, report):
                # The first round is always run to its end, so that no class goes untried.
                if arguments.only in name and (rounds == 0 or more()):
                    try:
                        work()
                    except (RuntimeError, OSError, ValueError) as error:
                        report.fail("%s: --seed %d: %s" % (name, arguments.seed + rounds, error))
            rounds += 1
    report.show()
    print("%d rounds from seed %d in %.0f s" % (rounds, arguments.seed, time.monotonic() - start))
    return 1 if report.failures else 0


if __name__ == "__main__":
    sys.exit(main())
