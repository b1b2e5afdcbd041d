#!/usr/bin/env python3
"""soak.py [--scenes N] [--seed N] [--project PATH] [--threads 1,2,7]: random valid scenes, all byte-equal.

Renders N scenes (1000; random_scene.py) with each number of threads: all must end with exit code 0 and leave the
same files with the same bytes. With build/sanitize/Project as the project, any leak, overrun or undefined behaviour
fails, too. Prints each failure with what repeats it, `--seed S --scenes 1`, and a sum; exit 1 where there was one.
"""
import argparse, hashlib, os, random, subprocess, sys, tempfile, time

from random_scene import RandomScene

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(10 ** 9),
                        help="of the first scene; the next count on from it")
    parser.add_argument("--threads", default="1,2,7")
    parser.add_argument("--project", default=os.path.join(TOP, "Project"))
    return parser.parse_args()


def render(project, folder, scene, threads):
    """-> (what is wrong or None, {file: hash})"""
    out = os.path.join(folder, threads)
    os.mkdir(out)
    with open(os.path.join(out, "scene.lua"), "w") as f:
        f.write(scene.script)
    environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=1:intercept_tls_get_addr=0", TSAN_OPTIONS="halt_on_error=1")
    try:
        done = subprocess.run([project, "scene.lua", "-q", "--trust", "-j", threads, *scene.options], cwd=out, timeout=300,
                              capture_output=True, text=True, env=environment)
    except subprocess.TimeoutExpired:
        return "does not end in 300 s", {}
    if done.returncode or "error:" in done.stderr:
        return "exit code %d: %s" % (done.returncode, done.stderr[-2000:]), {}
    files = {}
    for name in sorted(os.listdir(out)):
        with open(os.path.join(out, name), "rb") as f:
            files[name] = hashlib.sha256(f.read()).hexdigest()
    return (None if len(files) > 1 else "no image"), files


def soak(project, seed, threads):
    """-> complaints about the scene of this seed"""
    scene = RandomScene(random.Random(seed), os.path.join(TOP, "Assets"))
    with tempfile.TemporaryDirectory() as folder:
        first = None
        for count in threads:
            wrong, files = render(project, folder, scene, count)
            if wrong:
                return ["%s threads: %s" % (count, wrong)]
            first = first or files
            if files != first:
                return ["%s and %s threads: other files or bytes: %s" % (
                    threads[0], count, [name for name in {**first, **files} if first.get(name) != files.get(name)])]
    return []


def main():
    arguments = parse()
    project, threads = os.path.abspath(arguments.project), arguments.threads.split(",")
    began, failed = time.monotonic(), 0
    for seed in range(arguments.seed, arguments.seed + arguments.scenes):
        complaints = soak(project, seed, threads)
        failed += bool(complaints)
        for complaint in complaints:
            print("--seed %d --scenes 1: %s" % (seed, complaint), flush=True)
    print("%d scenes at %s threads, %d failed, in %.0f s (--seed %d)" % (
        arguments.scenes, arguments.threads, failed, time.monotonic() - began, arguments.seed))
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
