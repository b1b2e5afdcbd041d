"""Pictures: rendering scripts, reading PFM, comparing."""
import os, struct, subprocess


class Picture:
    """width, height, and pixels row by row from the top, each (r, g, b)"""

    def __init__(self, path):
        with open(path, "rb") as f:
            if f.readline().strip() != b"PF":
                raise ValueError(path + " is no colour PFM")
            self.width, self.height = map(int, f.readline().split())
            order = "<" if float(f.readline()) < 0 else ">"
            values = struct.unpack("%s%df" % (order, 3 * self.width * self.height), f.read())
        rows = [[values[3 * (self.width * y + x):][:3] for x in range(self.width)] for y in range(self.height)]
        self.pixels = [pixel for row in reversed(rows) for pixel in row]


def difference(a, b):
    """Largest over the channels; infinity where one is no number."""
    worst = max(abs(x - y) for x, y in zip(a, b))
    return worst if worst == worst else float("inf")


class Studio:
    """Renders scripts with one program in one folder."""

    def __init__(self, project, folder, args=(), env=None):
        self.project, self.folder, self.args, self.env = project, folder, list(args), env

    def run(self, script, *args):
        path = os.path.join(self.folder, "scene.lua")
        with open(path, "w") as f:
            f.write(script)
        done = subprocess.run([self.project, "scene.lua", "-q", *self.args, *args], cwd=self.folder,
                              capture_output=True, text=True, env=self.env)
        if done.returncode:
            keep = os.path.join(self.folder, "failed.lua")
            os.replace(path, keep)
            raise RuntimeError("%s: exit %d: %s" % (keep, done.returncode, done.stderr[-1000:]))

    def shoot(self, script, names, *args):
        """One sample in the middle of each pixel. -> the pictures that the script calls `names`"""
        self.run(script, "--spp", "1", "--sampler", "grid", *args)
        return [Picture(os.path.join(self.folder, name + ".pfm")) for name in names]

    def bytes_of(self, script, name, *args):
        self.run(script, *args, "-o", name)
        with open(os.path.join(self.folder, name), "rb") as f:
            return f.read()
