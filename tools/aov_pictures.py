#!/usr/bin/python3
"""aov_pictures.py PROJECT FOLDER: aov_NAME.png of scenes/room.lua for each name of --aov. Needs numpy and matplotlib."""
import os, subprocess, sys, tempfile

import matplotlib.image
import numpy as np

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
NAMES = "depth normal albedo position id uv samples error".split()


def plane(path):
    with open(path, "rb") as f:
        channels = {b"PF": 3, b"Pf": 1}[f.readline().strip()]
        width, height = map(int, f.readline().split())
        f.readline()
        return np.frombuffer(f.read(), "<f4").reshape(height, width, channels)[::-1]


def of_ids(values):
    """A colour for each number: the fractions of its multiples are spread evenly (Weyl, 1916)."""
    return np.where(values > 0, np.modf(values * np.array([0.6180340, 0.7548777, 0.5698403]))[0], 0)


SHOWN = {
    "depth": lambda v: (6 - v) / 5,
    "normal": lambda v: 0.5 + 0.5 * v,
    "albedo": lambda v: v,
    "position": lambda v: 0.5 + v / 12,
    "id": of_ids,
    "uv": lambda v: v,
    "samples": lambda v: np.log2(v) / 8,
    "error": lambda v: v / 0.05,
}


def main():
    project, folder = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    with tempfile.TemporaryDirectory() as work:
        subprocess.run([project, os.path.join(TOP, "scenes/room.lua"), "-q", "--size", "320x180", "--error", "0.01",
                        "--aov", ",".join(NAMES), "-o", "room.png"], cwd=work, check=True)
        for name in NAMES:
            values = plane(os.path.join(work, "room.%s.pfm" % name))
            shown = np.clip(SHOWN[name](values), 0, 1)
            shown = np.repeat(shown, 3, axis=2) if shown.shape[2] == 1 else shown
            matplotlib.image.imsave(os.path.join(folder, "aov_%s.png" % name), shown,
                                    metadata={"Software": None})


if __name__ == "__main__":
    main()
