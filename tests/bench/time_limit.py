#!/usr/bin/env python3
"""time_limit.py: is --time S kept? Bar: the median of render_seconds within 2 % of S or 20 ms, whichever is more.

On a machine that has other work, single runs are late where all threads wait for a processor. Also shows what --time
buys: the error estimate falls with S. Exit code 1 where the bar is missed. Needs python3-numpy.
"""
import argparse, os, statistics, sys
from pictures import runs, stage


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    runs.add_arguments(parser)
    parser.add_argument("--scenes", default="S1,S2,S5,foliage")
    parser.add_argument("--seconds", default="0.1,0.5,2")
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--repeat", type=int, default=5)
    arguments = parser.parse_args()
    arguments.project = os.path.abspath(arguments.project)
    size = tuple(int(n) for n in arguments.size.split("x"))
    missed = 0
    print("scene          S   render_seconds: median   least    most   over S, ms   estimate  samples")
    for name in arguments.scenes.split(","):
        script = stage.put(os.path.join(arguments.cache, "scenes"), name)
        for wanted in map(float, arguments.seconds.split(",")):
            stats = [runs.render(arguments.project, script, size, "--time", "%g" % wanted).stats
                     for _ in range(arguments.repeat)]
            took = [s["render_seconds"] for s in stats]
            late = statistics.median(took) - wanted
            bad = abs(late) > max(0.02 * wanted, 0.02)
            missed += bad
            estimate = stats[-1]["error_estimate"]
            print("%-10s %5g %23.3f %7.3f %7.3f %12.1f %10s %8.1f%s" % (
                name, wanted, statistics.median(took), min(took), max(took), 1000 * late,
                "-" if estimate is None else "%.5f" % estimate, stats[-1]["spp_mean"], "   <-- missed" if bad else ""),
                flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
