#!/usr/bin/env python3
"""costs.py [--build DIR]: what each primitive costs beside the textbook's code behind the same call, and the bar.

Builds torus_bench, solids_bench and accel_bench as the AVX2 kernel is built, into a folder of its own, and prints
the ratio of the medians of interleaved passes, of processor time. The bar is for the nearest hit with its surface
point (triangles: the hit); of the hit alone the ratio is shown. Needs an ordinary release build in DIR (build/release),
Google Benchmark, Embree 3 and fmt.
"""
import argparse, json, os, re, subprocess, sys, tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FLAGS = ("-std=c++20 -O2 -DNDEBUG -mavx2 -mfma -mbmi -mbmi2 -mlzcnt -ffp-contract=off -DGLM_FORCE_INLINE -pthread "
         "-Iinclude").split()
WRAPPED = ("sin cos tan asin acos atan atan2 exp exp2 log log2 log10 pow sinh cosh tanh cbrt hypot sincos").split()
WRAP = ["-Wl,--wrap=" + name for name in WRAPPED]
PORTABLE = ["src/math/wrap_libm.cpp"] + ["src/math/" + n for n in sorted(os.listdir(os.path.join(TOP, "src/math")))
                                         if n.startswith("portable") and n.endswith(".cpp")]
BARS = {"sphere": 1.3, "box": 1.3, "cylinder": 1.3, "cone": 2.0, "torus": 1.3, "triangle": 1.2}


def build(name, folder, sources, libraries):
    out = os.path.join(folder, name)
    subprocess.run(["g++", *FLAGS, "tests/bench/%s.cpp" % name, *sources, "-o", out, *WRAP, *libraries], cwd=TOP,
                   check=True)
    return out


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, cwd=TOP).stdout


def solids(folder):
    """(name, what, textbook ns, our ns, ratio)"""
    sources = ["src/geometry/%s.cpp" % n for n in ("solid_frame", "sphere", "box", "cylinder", "cone")]
    program = build("solids_bench", folder, PORTABLE + sources, [])
    pattern = r"(\w+) +(hit|\+ surface) +textbook +([\d.]+) ns +here +([\d.]+) ns +ratio ([\d.]+)"
    for name, what, textbook, ours, ratio in re.findall(pattern, output(program, "51")):
        yield name, what, float(textbook), float(ours), float(ratio)


def torus(folder):
    program = build("torus_bench", folder, PORTABLE + ["src/geometry/solid_frame.cpp", "src/geometry/torus.cpp"],
                    ["-lbenchmark"])
    result = json.loads(output(program, "--benchmark_format=json", "--benchmark_enable_random_interleaving=true",
                               "--benchmark_repetitions=9", "--benchmark_min_time=0.03",
                               "--benchmark_report_aggregates_only=true"))
    ns = {b["run_name"]: 1e9 * b["ns_per_ray"] if b["ns_per_ray"] < 1e-3 else b["ns_per_ray"]
          for b in result["benchmarks"] if b["aggregate_name"] == "median"}
    for which in "all", "hits", "misses":
        textbook, ours = ns["ferrari/" + which], ns["torus/" + which]
        yield "torus", which + ", + surface", textbook, ours, ours / textbook


def triangle(folder, libraries):
    archives = ["-Wl,--start-group", *("-l:" + n for n in sorted(os.listdir(libraries)) if n.endswith(".a")),
                "-Wl,--end-group"]
    program = build("accel_bench", folder, [], ["-L" + libraries, *archives, "-l:liblua5.3.a", "-llodepng", "-lz",
                                                "-ldl", "-lembree3", "-lfmt"])
    text = output(program, "--mesh", "20k", "--rounds", "7")
    ours, textbook, ratio = map(float, re.search(
        r"one triangle, scalar: ([\d.]+) ns; Moeller-Trumbore in double ([\d.]+) ns; ratio ([\d.]+)", text).groups())
    yield "triangle", "hit", textbook, ours, ours / textbook


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(TOP, "build", "release"))
    parser.add_argument("--only", default="solids,torus,triangle")
    arguments = parser.parse_args()
    measures = {"solids": solids, "torus": torus, "triangle": lambda f: triangle(f, os.path.abspath(arguments.build))}
    over = 0
    print("primitive  what                 textbook ns   here ns   ratio   bar", flush=True)
    with tempfile.TemporaryDirectory(prefix="costs-") as folder:
        for part in arguments.only.split(","):
            for name, what, textbook, ours, ratio in measures[part](folder):
                bar = BARS[name] if name == "triangle" or "surface" in what else None
                over += bar is not None and ratio > bar
                print("%-10s %-20s %11.1f %9.1f %7.2f %5s%s" % (
                    name, what, textbook, ours, ratio, bar or "", "   <-- over" if bar and ratio > bar else ""),
                      flush=True)
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
