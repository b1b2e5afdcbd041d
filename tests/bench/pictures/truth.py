"""Converged pictures of the program, and how exact they are.

Two renderings with --reference and different seeds, A and B, of the same number of samples: their errors are
independent, so the mean of the two has an error whose mean square is that of (A - B) / 2. The picture is cut into
blocks; samples go where this says that they help most, until the error of the whole is as small as asked.
"""
import os
import numpy as np
from . import runs

SEEDS = (900001, 900002)
FIRST = 64             # samples a pixel of every block at first
MOST = 1 << 20
GROWTH = 8             # at most this much more at a time: a block that looks quiet is looked at again
ORDER = 1.3            # the mean square falls about as samples^-ORDER


def edges(length, parts):
    return [length * i // parts for i in range(parts + 1)]


class Truth:
    """The converged picture of one script at one size, kept in the folder `keep`."""

    def __init__(self, project, script, size, keep, blocks=(8, 4), nice=10, fresh=False, options=()):
        self.project, self.script, self.size, self.nice, self.options = project, script, size, nice, tuple(options)
        with open(script) as f:
            name = os.path.splitext(os.path.basename(script))[0]
            key = runs.digest(f.read(), tuple(size), blocks, self.options)
        self.path = os.path.join(keep, "%s-%dx%d-%s.npz" % (name, *size, key))
        xs, ys = edges(size[0], blocks[0]), edges(size[1], blocks[1])
        self.boxes = [(x0, y0, x1, y1) for y0, y1 in zip(ys, ys[1:]) for x0, x1 in zip(xs, xs[1:])]
        self.pair = None
        if os.path.exists(self.path) and not fresh:
            with np.load(self.path) as kept:
                self.pair, self.spp = [kept["a"].astype(float), kept["b"].astype(float)], kept["spp"]

    def shoot(self, spp, seed, box=None):
        crop = ["--crop", "%d,%d,%d,%d" % box] if box else []
        return runs.render(self.project, self.script, self.size, "--reference", "--spp", str(spp), "--seed", str(seed),
                           *crop, *self.options, nice=self.nice).picture

    @property
    def picture(self):
        return (self.pair[0] + self.pair[1]) / 2

    def squares(self):
        """the mean square error of the mean, of each block"""
        d = (self.pair[0] - self.pair[1]) / 2 / np.maximum(1.0, np.abs(self.picture))
        return np.array([np.mean(np.square(d[y0:y1, x0:x1])) for x0, y0, x1, y1 in self.boxes])

    def weights(self):
        area = np.array([(x1 - x0) * (y1 - y0) for x0, y0, x1, y1 in self.boxes], float)
        return area / area.sum()

    @property
    def error(self):
        return float(np.sqrt(np.sum(self.squares() * self.weights())))

    def plan(self, wanted):
        """samples for each block that should bring the whole to `wanted`, for the least of them"""
        scale = np.maximum(self.squares(), 1e-16) * self.spp ** ORDER
        best = scale ** (1 / (1 + ORDER))
        low, high = 1e-6, 1e12
        for _ in range(100):
            middle = np.sqrt(low * high)
            n = np.maximum(self.spp, best * middle)
            if np.sum(self.weights() * scale * n ** -ORDER) > wanted ** 2:
                low = middle
            else:
                high = middle
        n = 2.0 ** np.ceil(np.log2(np.maximum(self.spp, best * high)) - 1e-9)
        return np.minimum(n, np.minimum(self.spp * GROWTH, MOST)).astype(int)

    def refine(self, wanted):
        """-> self, with an error of at most `wanted`"""
        if self.pair is None:
            self.pair = [self.shoot(FIRST, seed).copy() for seed in SEEDS]
            self.spp = np.full(len(self.boxes), FIRST)
        while self.error > wanted:
            # A little below, so that the blocks' own scatter does not call for one more small round.
            n = self.plan(0.9 * wanted)
            grown = np.nonzero(n > self.spp)[0]
            if len(grown) == 0:
                raise RuntimeError("%s does not converge: %g at %d samples" % (self.script, self.error, MOST))
            for i in grown:
                x0, y0, x1, y1 = self.boxes[i]
                for picture, seed in zip(self.pair, SEEDS):
                    picture[y0:y1, x0:x1] = self.shoot(n[i], seed, self.boxes[i])
                self.spp[i] = n[i]
            self.save()
        return self

    def save(self):
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        with open(self.path + ".part", "wb") as f:
            np.savez(f, a=self.pair[0].astype(np.float32), b=self.pair[1].astype(np.float32), spp=self.spp)
        os.replace(self.path + ".part", self.path)
