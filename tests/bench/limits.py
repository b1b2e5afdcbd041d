#!/usr/bin/env python3
"""limits.py: what limits each benchmark scene: rays of each kind, nanoseconds a ray, seconds before rendering, and
shares of the time by kind of work (perf, by symbol, where it is installed).

One thread. --write puts the tables between the markers of Documentation/performance.md.
Needs python3-numpy; linux-perf for the shares.
"""
import argparse, os, re, shutil, subprocess, sys, tempfile
from pictures import runs, scenes, stage
from pictures.report import put

# The first that matches a symbol takes it.
WORK = [("start, system", r"^\[k\]|ld-linux|_dl_|do_lookup|__mem|malloc|_int_free|cfree|clear_page"),
        ("reading, building", r"lua|[Oo]bj[A-Z:(]|parse|compile|Compil|[Bb]uild|strto|from_chars|weld|MeshTopology"
                              r"|Normals|[Ss]plit|divideRun"),
        ("picking samples", r"Sampler|[Ss]obol|PixelFilter|concentricDisc|hash|[Ss]cramble"),
        ("error, passes", r"squaredErrors|nextSamples|[Aa]daptive|[Cc]lassif|[Tt]ile|Film|Batch|Run::|[Ff]lag|edge"),
        ("intersection", r"traverse|[Ii]ntersect|[Cc]losestHit|BoxRay|nearestOn|inObjectSpace|toObject|meet|torus::"
                         r"|MeshTree|WideTree|anyHit|[Oo]ccluded|nextHit|beyondHit"),
        ("surface", r"::surface|surfaceAt|triangleSurface|ToWorld|viewOf|coincidence"),
        ("light, shading", r"shade|phong|[Ll]ight|visib|coneDirection|powUnit|orthonormal|sincos|[Pp]enumbra"
                           r"|Background|[Tt]exture|Bump|texel"),
        ("paths", r"Tracer|Medium|Camera|fresnel|refract|reflect|cutSmall")]


def shares(project, script, size, options):
    """{kind of work: share}, and the largest symbols that no kind takes"""
    with tempfile.TemporaryDirectory(prefix="bench-") as out:
        data = os.path.join(out, "perf.data")
        subprocess.run(["perf", "record", "-q", "-F", "999", "-o", data, project, os.path.basename(script), "-q",
                        "-j", "1", "--size", "%dx%d" % size, "-o", os.path.join(out, "p.pfm"), *options], check=True,
                       cwd=os.path.dirname(script), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        said = subprocess.run(["perf", "report", "-i", data, "--stdio", "--no-children", "-F", "overhead,symbol"],
                              check=True, capture_output=True, text=True).stdout
    found, rest = {}, []
    for share, symbol in re.findall(r"^\s+([\d.]+)%\s+(\[.\] .*)$", said, re.M):
        kind = next((k for k, pattern in WORK if re.search(pattern, symbol)), None)
        found[kind or "other"] = found.get(kind or "other", 0.0) + float(share)
        if kind is None:
            rest.append("%s %% %s" % (share, symbol[4:60].strip()))
    return found, rest[:3]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    runs.add_arguments(parser)
    parser.add_argument("--scenes", default=",".join(scenes.SCENES))
    parser.add_argument("--options", default="--error 0.002")
    parser.add_argument("--write", action="store_true", help="update Documentation/performance.md")
    arguments = parser.parse_args()
    arguments.project = os.path.abspath(arguments.project)
    kinds = [k for k, _ in WORK] + ["other"]
    work, where = [], []
    perf = shutil.which("perf") is not None
    for name in arguments.scenes.split(","):
        script = stage.put(os.path.join(arguments.cache, "scenes"), name)
        size = scenes.SCENES[name]()["size"]
        done = runs.render(arguments.project, script, size, "-j", "1", *arguments.options.split())
        s = done.stats
        rays = s["rays"]
        total = sum(rays.values())
        counts = " | ".join("%.2f" % (rays[k] / 1e6) for k in ("camera", "shadow", "reflection", "refraction"))
        work.append("| %s | %.1f | %s | %.0f | %.0f | %.3f | %.3f |" % (
            name, s["spp_mean"], counts, 1e9 * s["cpu_seconds"] / max(total, 1),
            1e9 * s["cpu_seconds"] / (size[0] * size[1]), done.cpu - s["cpu_seconds"], s["cpu_seconds"]))
        print(work[-1], flush=True)
        if perf:
            found, rest = shares(arguments.project, script, size, arguments.options.split())
            where.append("| %s | %s |" % (name, " | ".join("%.0f" % found.get(k, 0) for k in kinds)))
            print(where[-1], "   others: " + "; ".join(rest) if rest else "", flush=True)
    tables = ["| scene | samples a pixel | rays, 10^6: camera | shadow | reflection | refraction | ns a ray "
              "| ns a pixel | before rendering, s | rendering, s |", "| --- |" + " --: |" * 9, *work]
    if perf:
        tables += ["", "| % of the time | " + " | ".join(kinds) + " |", "| --- |" + " --: |" * len(kinds), *where]
    if arguments.write:
        put(os.path.join(runs.TOP, "Documentation", "performance.md"), "profile", "\n".join(tables))
    else:
        print("\n".join(tables))
    return 0


if __name__ == "__main__":
    sys.exit(main())
