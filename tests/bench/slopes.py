#!/usr/bin/env python3
"""slopes.py: how the RMSE falls with --spp, for each effect alone and for all together, with each --sampler.

Pictures of 64x36 against converged ones, whose own error is measured and taken off in squares. The slope is the
exponent of the number of samples by least squares over 16 to 1024. --write puts the table between the markers of
Documentation/sampling.md and the plot into Documentation/images/. Needs python3-numpy; python3-matplotlib for --write.
"""
import argparse, os, sys
import numpy as np
from pictures import runs, truth
from pictures.effects import EFFECTS
from pictures.report import COLORS, put

SAMPLERS = ("joint", "jitter", "grid", "random")
COUNTS = [1 << i for i in range(11)]
SIZE = (64, 36)


def measure(arguments, name):
    """-> {sampler: [RMSE for each of COUNTS]}"""
    make, options = EFFECTS[name]
    folder = os.path.join(arguments.cache, "effects")
    os.makedirs(folder, exist_ok=True)
    script = os.path.join(folder, make.__name__ + ".lua")
    runs.write_if_changed(script, make(folder))
    right = truth.Truth(arguments.project, script, SIZE, os.path.join(arguments.cache, "refs"), (4, 2), arguments.nice,
                        arguments.fresh, options)

    def shoot(sampler, spp):
        return runs.render(arguments.project, script, SIZE, "--sampler", sampler, "--spp", str(spp), "--seed", "1",
                           *options, nice=arguments.nice).picture
    pictures = {s: [shoot(s, n) for n in COUNTS] for s in SAMPLERS}
    right.refine(0.0005)
    least = min(runs.float_error(row[-1], right.picture) for row in pictures.values())
    right.refine(min(right.error, max(least / 3, 4e-5)))
    return {s: [max(runs.float_error(p, right.picture) ** 2 - right.error ** 2, 1e-12) ** 0.5 for p in row]
            for s, row in pictures.items()}


def slope(errors):
    kept = [(n, e) for n, e in zip(COUNTS, errors) if n >= 16]
    return np.polyfit(np.log([n for n, _ in kept]), np.log([e for _, e in kept]), 1)[0]


def table(results):
    lines = ["| effect | slope: joint | jitter | grid | random | RMSE at 64: joint | jitter | grid | random |",
             "| --- | --: | --: | --: | --: | --: | --: | --: | --: |"]
    at = COUNTS.index(64)
    for name, rows in results.items():
        lines.append("| %s | %s | %s |" % (name, " | ".join("%.2f" % slope(rows[s]) for s in SAMPLERS),
                                           " | ".join("%.4f" % rows[s][at] for s in SAMPLERS)))
    return "\n".join(lines)


def plot(results, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots((len(results) + 3) // 4, 4, figsize=(13, 6), squeeze=False, sharex=True)
    for axis, (name, rows) in zip(axes.flat, results.items()):
        for sampler in SAMPLERS:
            axis.plot(COUNTS, rows[sampler], "o-", color=COLORS[sampler], markersize=3, linewidth=1.2, label=sampler)
        axis.set(xscale="log", yscale="log", title=name)
        axis.grid(True, which="major", alpha=0.4)
    axes.flat[0].legend(fontsize=8)
    for axis in axes[-1]:
        axis.set_xlabel("samples a pixel")
    for axis in axes[:, 0]:
        axis.set_ylabel("RMSE")
    figure.tight_layout()
    figure.savefig(path, dpi=80)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    runs.add_arguments(parser)
    parser.add_argument("--json", help="where the results go; CACHE/slopes.json")
    parser.add_argument("--write", action="store_true", help="update Documentation/sampling.md and its plot")
    arguments = parser.parse_args()
    arguments.project, arguments.cache = os.path.abspath(arguments.project), os.path.abspath(arguments.cache)
    results = {}
    for name in EFFECTS:
        results[name] = measure(arguments, name)
        print(name + ":", *("%s %.2f" % (s, slope(e)) for s, e in results[name].items()), flush=True)
    runs.write_json(arguments.json or os.path.join(arguments.cache, "slopes.json"), results)
    print(table(results))
    if arguments.write:
        images = os.path.join(runs.TOP, "Documentation", "images")
        plot(results, os.path.join(images, "convergence.png"))
        picture = "\n\n![RMSE against samples a pixel, by effect and sampler](images/convergence.png)"
        put(os.path.join(runs.TOP, "Documentation", "sampling.md"), "slopes", table(results) + picture)
    return 0


if __name__ == "__main__":
    sys.exit(main())
