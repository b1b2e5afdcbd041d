"""POV-Ray: its settings, its runs, and its converged pictures."""
import os, re, shutil, tempfile
from collections import namedtuple
import numpy as np
from . import runs

# What it costs and gives; trace: the CPU seconds that it states for tracing alone
Shot = namedtuple("Shot", "picture cpu trace")


def available():
    return shutil.which("povray") is not None


def declare(**values):
    """POV-Ray reads a declared number only with a point or an exponent."""
    return ["Declare=%s=%r" % (k, float(v)) for k, v in values.items()]


def lamp(text):
    """'9/1': 9 x 9, adaptive from level 1; '2/-': not adaptive; 'n' at the end: no jitter"""
    n, level = text.rstrip("n").split("/")
    return declare(AN=int(n), AADAPT=-1 if level == "-" else int(level), AJIT=0 if text.endswith("n") else 1)


OFF = "-A"
AREA = [(OFF, "3/0 5/0 5/1 9/1"), ("+AM1 +R2 +A0.3", "5/0"), ("+AM1 +R3 +A0.3", "5/0 5/1"),
        ("+AM2 +R2 +A0.3", "5/0 5/1"), ("+AM2 +R2 +A0.1", "5/0 9/0"), ("+AM2 +R3 +A0.3", "5/0 5/1"),
        ("+AM2 +R3 +A0.1", "3/0 5/0 5/0n 5/1 9/0 9/0n 9/1"),
        ("+AM2 +R3 +A0.03", "5/0 9/0"), ("+AM2 +R4 +A0.1", "5/0 9/0 9/1"), ("+AM2 +R4 +A0.03", "5/0 9/0 9/0n 9/1 17/2"),
        ("+AM2 +R4 +A0.01", "9/0 9/1")]
POINT = [OFF, "+AM1 +R2 +A0.3", "+AM1 +R3 +A0.3", "+AM1 +R3 +A0.1", "+AM1 +R4 +A0.1", "+AM1 +R5 +A0.1",
         "+AM2 +R2 +A0.3", "+AM2 +R2 +A0.1", "+AM2 +R3 +A0.3", "+AM2 +R3 +A0.1", "+AM2 +R3 +A0.1 -J", "+AM2 +R3 +A0.03", "+AM2 +R4 +A0.1",
         "+AM2 +R4 +A0.1 -J", "+AM2 +R4 +A0.03", "+AM2 +R5 +A0.1", "+AM2 +R5 +A0.03", "+AM2 +R6 +A0.03"]
# most samples, fewest, variance, confidence; lights of 2x2 stay at an RMSE of 0.009 in S3
BLUR = [(10, 0, 1 / 128, 0.9), (20, 0, 1 / 128, 0.9), (50, 0, 1 / 128, 0.9), (50, 0, 1e-3, 0.9), (100, 0, 1e-3, 0.9),
        (100, 0, 1e-4, 0.9), (100, 20, 1e-4, 0.9), (200, 0, 1e-4, 0.9), (200, 0, 1e-5, 0.9), (400, 0, 1e-5, 0.9)]
LENS = [(OFF, "3/0 5/0", BLUR), (OFF, "9/0", BLUR[-3:]), ("+AM2 +R2 +A0.3", "3/0 5/0", BLUR[:3]),
        ("+AM2 +R2 +A0.1", "3/0 5/0", BLUR[:3]), ("+AM1 +R2 +A0.1", "3/0", BLUR[:2])]


def settings(scene):
    """{label: options} worth trying for a scene of scenes.py"""
    area = any(l["radius"] > 0 for l in scene["lights"])
    if scene["camera"]["lens_radius"] > 0:
        return {"%s blur %d/%d/%.3g/%g light %s" % (aa, *blur, l): [
            *aa.split(), *lamp(l), *declare(BS=blur[0], BSMIN=blur[1], BVAR=blur[2], BCONF=blur[3])]
            for aa, lights, blurs in LENS
            for l in lights.split() for blur in blurs}
    if area:
        return {"%s light %s" % (aa, l): [*aa.split(), *lamp(l)] for aa, lights in AREA for l in lights.split()}
    return {aa: aa.split() for aa in POINT}


def shoot(folder, name, size, options, nice=0):
    with tempfile.TemporaryDirectory(prefix="bench-") as out:
        path = os.path.join(out, "p.ppm")
        cpu, said = runs.run(["povray", "+I%s.pov" % name, "+O" + path, "+FP16", "File_Gamma=1.0", "+W%d" % size[0],
                              "+H%d" % size[1], "-D", *options], folder, nice)
        trace = re.search(r"Trace Time:.*\n.*with\s+([\d.]+) CPU-seconds", said)
        return Shot(runs.read_ppm(path), cpu, float(trace.group(1)) if trace else None)


def finest(scene):
    """options of a converged picture; it is rendered larger and averaged over squares of pixels"""
    if scene["camera"]["lens_radius"] > 0:
        return [OFF, *lamp("9/0"), *declare(BS=61, BVAR=0, BCONF=0.9)]
    if any(l["radius"] > 0 for l in scene["lights"]):
        return [*"+AM2 +R3 +A0.01".split(), *lamp("17/2")]
    return "+AM1 +R4 +A0.0".split()


def truth(folder, scene, size, keep, nice=10, fresh=False):
    """-> (converged picture, its error): the mean of two of different sizes, whose jitter is therefore different"""
    options = finest(scene)
    with open(os.path.join(folder, scene["name"] + ".pov")) as f:
        key = runs.digest(f.read(), tuple(size), options)
    path = os.path.join(keep, "povray-%s-%dx%d-%s.npz" % (scene["name"], *size, key))
    if fresh or not os.path.exists(path):
        pair = []
        for times in (4, 3):
            large = shoot(folder, scene["name"], (size[0] * times, size[1] * times), options, nice).picture
            pair.append(large.reshape(size[1], times, size[0], times, 3).mean((1, 3)))
        os.makedirs(keep, exist_ok=True)
        np.savez(path, a=pair[0].astype(np.float32), b=pair[1].astype(np.float32))
    with np.load(path) as kept:
        a, b = kept["a"].astype(float), kept["b"].astype(float)
    # Weights as the numbers of samples
    return (16 * a + 9 * b) / 25, runs.rms(a - b) * 12 / 25
