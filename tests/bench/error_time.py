#!/usr/bin/env python3
"""error_time.py: RMSE against CPU seconds, of this program, of its baselines, and of POV-Ray where it is installed.

Renders the benchmark scenes at several --error targets, with --sampler jitter, grid and random at several --spp, and
their POV-Ray twins at many settings, of which those near the front of (error, seconds) are measured several
times. Each renderer is held against its own converged picture; the error of that is measured and taken off, in
squares. RMSE is over all channels of linear values clipped to [0, 1]; seconds are user + system time of the whole
process (`tracing`: without start, reading, parsing and building). Runs are interleaved; the median counts; runs over
--once seconds are made once. POV-Ray's results are kept in CACHE/povray.json until --povray again.

--write puts tables between the markers of Documentation/performance.md, and plots into Documentation/images/.
Needs python3-numpy; python3-matplotlib for the plots; povray for the comparison.
"""
import argparse, os, statistics, sys
from pictures import front, povray, runs, scenes, stage, truth
from pictures.report import Report

BLOCKS = {"S5": (4, 2)}    # its mesh is read again for every block
JUDGED = (0.005, 0.002)


class Series:
    """What one renderer gave with one setting"""

    def __init__(self, label):
        self.label, self.error, self.cpu, self.trace, self.more = label, None, [], [], {}

    def add(self, error, cpu, trace, **more):
        self.error, self.more = error, more
        self.cpu.append(cpu)
        self.trace.append(trace)

    def row(self):
        return dict(label=self.label, rmse=self.error, cpu=statistics.median(self.cpu), runs=len(self.cpu),
                    trace=statistics.median(self.trace), **self.more)


def less(measured, own):
    """the error without that of the picture it was held against"""
    return max(measured ** 2 - own ** 2, 0.01 * measured ** 2) ** 0.5


class Here:
    def __init__(self, arguments, name, size):
        self.arguments, self.size = arguments, size
        self.script = os.path.join(arguments.cache, "scenes", name + ".lua")
        self.right = truth.Truth(arguments.project, self.script, size, os.path.join(arguments.cache, "refs"),
                                 BLOCKS.get(name, (8, 4)), arguments.nice, arguments.fresh)
        self.right.refine(arguments.reference)

    def measure(self, series, options):
        done = runs.render(self.arguments.project, self.script, self.size, *options)
        s = done.stats
        series.add(less(runs.clipped_error(done.picture, self.right.picture), self.right.error), done.cpu,
                   s["cpu_seconds"], spp=s["spp_mean"], estimate=s["error_estimate"], build=s["build_seconds"],
                   rays=s["rays"])

    def settings(self):
        for target in self.arguments.targets:
            yield "joint", "--error %g" % target, ["--error", "%g" % target, *self.arguments.options.split()]
        for sampler in filter(None, self.arguments.samplers.split(",")):
            for spp in self.arguments.spp:
                yield sampler, "--spp %d" % spp, ["--sampler", sampler, "--spp", "%d" % spp]


class Peer:
    """POV-Ray on one scene, and what is kept of it"""

    def __init__(self, arguments, scene, size):
        self.arguments, self.scene, self.size = arguments, scene, size
        self.folder = os.path.join(arguments.cache, "scenes")
        self.kept = os.path.join(arguments.cache, "povray.json")
        with open(os.path.join(self.folder, scene["name"] + ".pov")) as f:
            self.key = "%s-%dx%d-%s" % (scene["name"], *size, runs.digest(f.read(), povray.settings(scene)))
        self.rows = None if arguments.povray == "again" else runs.read_json(self.kept, {}).get(self.key)
        self.series = {}
        if self.rows is None:
            self.right, self.error = povray.truth(self.folder, scene, size, os.path.join(arguments.cache, "refs"),
                                                  arguments.nice, arguments.fresh)
            print("%s: POV-Ray's converged picture has an error of %.5f" % (scene["name"], self.error), flush=True)

    def candidates(self, first):
        """all settings at first; later those near the front that are quick enough to repeat"""
        every = povray.settings(self.scene)
        if first:
            return every
        edge = front.pareto([(s.error, s.cpu[0]) for s in self.series.values()])

        def near(s):
            cost, _ = front.cost_at(edge, s.error)
            return cost is not None and s.cpu[0] <= 1.25 * cost and s.cpu[0] <= self.arguments.once
        return {label: every[label] for label, s in self.series.items() if near(s)}

    def measure(self, label, options):
        shot = povray.shoot(self.folder, self.scene["name"], self.size, options)
        self.series.setdefault(label, Series(label)).add(
            less(runs.clipped_error(shot.picture, self.right), self.error), shot.cpu, shot.trace or shot.cpu)

    def keep(self):
        if self.series:
            self.rows = [s.row() for s in self.series.values()]
            every = runs.read_json(self.kept, {})
            every[self.key] = self.rows
            runs.write_json(self.kept, every)
        return self.rows


def measure(arguments, name):
    """-> one scene's results"""
    stage.put(os.path.join(arguments.cache, "scenes"), name)
    scene = scenes.SCENES[name]()
    size = arguments.size or scene["size"]
    here = Here(arguments, name, size)
    peer = Peer(arguments, scene, size) if arguments.povray != "no" and povray.available() else None
    print("%s: converged picture here has an error of %.5f" % (name, here.right.error), flush=True)
    mine = {}
    for turn in range(arguments.rounds):
        work = []
        for sampler, label, options in here.settings():
            series = mine.setdefault((sampler, label), Series(label))
            if turn == 0 or series.cpu[0] <= arguments.once:
                work.append(lambda s=series, o=options: here.measure(s, o))
        if peer and peer.rows is None:
            other = [lambda l=label, o=options: peer.measure(l, o)
                     for label, options in peer.candidates(turn == 0).items()]
            work = interleave(work, other)
        for do in work:
            do()
    result = dict(scene=name, title=scene["title"], size=list(size), reference=here.right.error, here={})
    for (sampler, _), series in mine.items():
        result["here"].setdefault(sampler, []).append(series.row())
    result["povray"] = peer.keep() if peer else None
    return result


def interleave(a, b):
    """both in order, spread over each other"""
    placed = [((i + 0.5) / len(a), x) for i, x in enumerate(a)] + [((i + 0.5) / len(b), x) for i, x in enumerate(b)]
    return [x for _, x in sorted(placed, key=lambda p: p[0])]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    runs.add_arguments(parser)
    parser.add_argument("--scenes", default=",".join(scenes.SCENES), help="'' only reports what is kept")
    parser.add_argument("--targets", default="0.02,0.01,0.007,0.005,0.003,0.002,0.0015,0.001")
    parser.add_argument("--samplers", default="jitter,grid,random", help="baselines; '' for none")
    parser.add_argument("--spp", default="1,4,16,64,256", help="of the baselines")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--once", type=float, default=6.0, help="what takes more CPU seconds is measured once")
    parser.add_argument("--size", help="WxH instead of each scene's own")
    parser.add_argument("--reference", type=float, default=0.0004, help="largest error of the converged pictures here")
    parser.add_argument("--povray", choices=("kept", "again", "no"), default="kept")
    parser.add_argument("--options", default="", help="more options for the program, in one string")
    parser.add_argument("--json", help="where results are kept, scene by scene; CACHE/error_time.json")
    parser.add_argument("--write", action="store_true", help="update Documentation/performance.md and its plots")
    arguments = parser.parse_args()
    arguments.project = os.path.abspath(arguments.project)
    arguments.targets = [float(t) for t in arguments.targets.split(",")]
    arguments.spp = [int(n) for n in arguments.spp.split(",")]
    arguments.size = tuple(int(n) for n in arguments.size.split("x")) if arguments.size else None
    arguments.cache = os.path.abspath(arguments.cache)
    kept = arguments.json or os.path.join(arguments.cache, "error_time.json")
    report = Report(JUDGED, runs.read_json(kept, []))
    for name in filter(None, arguments.scenes.split(",")):
        result = measure(arguments, name)
        report.add(result)
        runs.write_json(kept, report.results)
        print(report.points(result), flush=True)
    print(report.summary())
    if arguments.write:
        report.write(runs.TOP)
    return 0


if __name__ == "__main__":
    sys.exit(main())
