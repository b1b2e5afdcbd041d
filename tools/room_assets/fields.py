"""Seamless noise as rows of numbers, a whole row at a time, and the PNG files made from it."""
import math, os, sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from make_assets import clamp, hash01, mix, path_of, png_bytes, smoothstep  # noqa: E402,F401


def fade(n, cells):
    """For n points over a period of `cells`: the cell of each, and its smoothed place in it."""
    out = []
    for k in range(n):
        x = (k + 0.5) / n * cells
        i = int(x)
        t = x - i
        out.append((i, t * t * (3 - 2 * t)))
    return out


def noise(w, h, cells_u, cells_v, seed):
    """Value noise in [0,1], h rows of w, seamless; row 0 is the top of the image."""
    columns = fade(w, cells_u)
    lattice = []
    for j in range(cells_v):
        row = [hash01(i, j, seed) for i in range(cells_u)] + [hash01(0, j, seed)]
        lattice.append([row[i] + (row[i + 1] - row[i]) * t for i, t in columns])
    rows = []
    for j, t in fade(h, cells_v):
        low, high = lattice[j], lattice[(j + 1) % cells_v]
        rows.append([a + (b - a) * t for a, b in zip(low, high)])
    return rows


def fractal(w, h, cells_u, cells_v, octaves, seed, gain=0.5):
    """Octaves of noise, in [0,1]."""
    total, weight = None, 0.0
    for k in range(octaves):
        if cells_u << k > w or cells_v << k > h:
            break
        a = gain ** k
        layer = noise(w, h, cells_u << k, cells_v << k, seed + 101 * k)
        weight += a
        if total is None:
            total = layer
        else:
            total = [[p + a * q for p, q in zip(r, s)] for r, s in zip(total, layer)]
    return [[p / weight for p in r] for r in total]


def at(field, u, v):
    """The nearest value of a field at (u, v), v upwards, repeated outside [0,1]."""
    h, w = len(field), len(field[0])
    return field[int((1 - v) % 1 * h) % h][int(u % 1 * w) % w]


def ramp(stops, t):
    """A colour from a list of (place, colour), linear between them."""
    if t <= stops[0][0]:
        return stops[0][1]
    for (a, p), (b, q) in zip(stops, stops[1:]):
        if t <= b:
            return mix(p, q, (t - a) / (b - a))
    return stops[-1][1]


def scaled(colour, s):
    return tuple(c * s for c in colour)


def write(folder, name, w, h, pixel):
    """pixel(x, y) gives the colour (three values) or the height (one number) of the texel in row y, column x."""
    lines = []
    channels = 1
    for y in range(h):
        line = []
        for x in range(w):
            value = pixel(x, y)
            if isinstance(value, tuple):
                channels = 3
                line += [int(clamp(c) * 255 + 0.5) for c in value]
            else:
                line.append(int(clamp(value) * 255 + 0.5))
        lines.append(line)
    with open(path_of(folder, name), "wb") as f:
        f.write(png_bytes(w, h, channels, lines))


def write_normals(name, height, depth):
    """The normal map of a seamless height field in [0,1]; depth: how high 1 is, in units of the tile's width."""
    h, w = len(height), len(height[0])
    scale = depth * w / 2

    def pixel(x, y):
        dx = (height[y][(x + 1) % w] - height[y][x - 1]) * scale
        dy = (height[y - 1][x] - height[(y + 1) % h][x]) * scale
        n = math.sqrt(dx * dx + dy * dy + 1)
        return ((128 - 127 * dx / n) / 255, (128 - 127 * dy / n) / 255, (128 + 127 / n) / 255)

    write("Bump", name, w, h, pixel)
