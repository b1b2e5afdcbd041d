#!/usr/bin/env python3
"""caustics.py [--project ./Project] [--size WxH] [--markdown] [--scene FILE...]: whether pictures with caustics are as
near to the truth as they say, and what noise and bias photons leave, by error target.

The truth is --reference with another seed, so that it shares no photon, and its own photons are off by a few times
less. Each row is the mean over three seeds, of root mean squares over clipped channels; times are processor time.
"""
import argparse, json, os, struct, subprocess, tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SEEDS = "012"


def pfm(path):
    with open(path, "rb") as file:
        file.readline()
        width, height = map(int, file.readline().split())
        file.readline()
        return [min(max(value, 0.0), 1.0) for value in struct.unpack("<%df" % (3 * width * height), file.read())]


def render(project, scene, folder, *options):
    """(what --stats says, the picture)"""
    stats, output = os.path.join(folder, "stats.json"), os.path.join(folder, "picture.pfm")
    subprocess.run([project, scene, "-q", "--stats", stats, "-o", output, *options], check=True, cwd=TOP,
                   stderr=subprocess.DEVNULL)
    with open(stats) as file:
        return json.load(file)["renders"][0], pfm(output)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--project", default=os.path.join(TOP, "Project"))
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--markdown", action="store_true")
    parser.add_argument("--errors", default="0.02,0.01,0.005")
    parser.add_argument("--scene", nargs="*", default=["Documentation/examples/caustics.lua", "scenes/caustic_lens.lua",
                                                       "scenes/caustic_ring.lua"])
    arguments = parser.parse_args()
    row = "| %s | %s | %s | %s | %s | %s | %s | %s |" if arguments.markdown else "%-24s %8s %9s %9s %9s %9s %12s %8s"
    print(row % ("scene", "target", "actual", "estimate", "noise", "bias", "photons kept", "CPU s"))
    if arguments.markdown:
        print("| --- |" + " --: |" * 7)
    with tempfile.TemporaryDirectory(prefix="caustics-") as folder:
        for scene in arguments.scene:
            size = ("--size", arguments.size)
            truth, right = render(arguments.project, scene, folder, *size, "--reference", "--spp", "64", "--seed", "77")
            name = os.path.splitext(os.path.basename(scene))[0]
            own = truth["caustics"]
            print(row % (name, "truth", "", "", "%.5f" % own["noise"], "%.5f" % own["bias"], own["photons_kept"],
                         "%.1f" % truth["cpu_seconds"]), flush=True)
            for error in arguments.errors.split(","):
                sums = [0.0] * 6
                for seed in SEEDS:
                    stats, found = render(arguments.project, scene, folder, *size, "--error", error, "--seed", seed)
                    off = sum((a - b) ** 2 for a, b in zip(found, right)) / len(right)
                    photons = stats["caustics"]
                    for i, value in enumerate((off ** 0.5, stats["error_estimate"], photons["noise"], photons["bias"],
                                               photons["photons_kept"], stats["cpu_seconds"])):
                        sums[i] += value / len(SEEDS)
                print(row % (name, error, *("%.5f" % value for value in sums[:4]), "%d" % sums[4], "%.1f" % sums[5]),
                      flush=True)


if __name__ == "__main__":
    main()
