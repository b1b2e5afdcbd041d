#!/usr/bin/env python3
"""make_assets.py: writes Assets/Model, Assets/Texture and Assets/Bump.

Everything is computed here, from integer hashes and closed formulas, so the same files result on every run.
"""
import math, os, struct, zlib

ASSETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Assets")


# ---- numbers -------------------------------------------------------------------------------------------------

def hash01(x, y, seed):
    """A number in [0,1) from three integers (the finaliser of MurmurHash3, Appleby 2011)."""
    h = (x * 0x9E3779B1 ^ y * 0x85EBCA77 ^ seed * 0xC2B2AE3D) & 0xFFFFFFFF
    h = ((h ^ h >> 16) * 0x85EBCA6B) & 0xFFFFFFFF
    h = ((h ^ h >> 13) * 0xC2B2AE35) & 0xFFFFFFFF
    return (h ^ h >> 16) / 4294967296.0


def noise(x, y, period_x, period_y, seed):
    """Value noise in [0,1], repeating after the two whole periods."""
    i, j = math.floor(x), math.floor(y)
    fx, fy = x - i, y - j
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
    i0, i1, j0, j1 = i % period_x, (i + 1) % period_x, j % period_y, (j + 1) % period_y
    low = hash01(i0, j0, seed) * (1 - fx) + hash01(i1, j0, seed) * fx
    high = hash01(i0, j1, seed) * (1 - fx) + hash01(i1, j1, seed) * fx
    return low * (1 - fy) + high * fy


def fractal(u, v, cells_u, cells_v, octaves, seed):
    """Octaves of noise over the unit square, in [0,1], seamless at its edges."""
    total, weight = 0.0, 0.0
    for k in range(octaves):
        n, a = 1 << k, 0.5 ** k
        total += a * noise(u * cells_u * n, v * cells_v * n, cells_u * n, cells_v * n, seed + k)
        weight += a
    return total / weight


def clamp(x, low=0.0, high=1.0):
    return min(max(x, low), high)


def smoothstep(a, b, x):
    t = clamp((x - a) / (b - a))
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


# ---- files ---------------------------------------------------------------------------------------------------

def path_of(folder, name):
    os.makedirs(os.path.join(ASSETS, folder), exist_ok=True)
    return os.path.join(ASSETS, folder, name)


def png_bytes(width, height, channels, lines):
    """A PNG of 8 bits a channel; every line is stored as differences to the pixel on its left (filter 1)."""
    def chunk(tag, data):
        return struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))

    packed = bytearray()
    for line in lines:
        packed.append(1)
        packed += bytes((c - (line[k - channels] if k >= channels else 0)) & 255 for k, c in enumerate(line))
    header = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(packed), 9)) +
            chunk(b"IEND", b""))


def write_png(folder, name, width, height, pixel):
    """pixel(u, v) gives a tuple of one or three values in [0,1]; v goes upwards."""
    lines = []
    for y in range(height):
        values = (pixel((x + 0.5) / width, 1 - (y + 0.5) / height) for x in range(width))
        lines.append([int(clamp(c) * 255 + 0.5) for value in values for c in value])
    data = png_bytes(width, height, len(lines[0]) // width, lines)
    with open(path_of(folder, name), "wb") as f:
        f.write(data)


def write_normal_map(folder, name, size, height, depth):
    """height(u, v) in [0,1], seamless; depth: how high 1 is, in units of the tile's side."""
    h = [[height((x + 0.5) / size, (y + 0.5) / size) for x in range(size)] for y in range(size)]

    def pixel(u, v):
        x, y = int(u * size), int(v * size)
        dx = (h[y][(x + 1) % size] - h[y][x - 1]) * depth * size / 2
        dy = (h[(y + 1) % size][x] - h[y - 1][x]) * depth * size / 2
        length = math.sqrt(dx * dx + dy * dy + 1)
        return tuple((128 + 127 * c / length) / 255 for c in (-dx, -dy, 1))

    write_png(folder, name, size, size, pixel)


def number(x):
    text = "%.4f" % x
    return "0" if float(text) == 0 else text.rstrip("0").rstrip(".")


def write_obj(name, comment, points, faces, uvs=(), normals=()):
    """faces: lists of corners (point, uv or None, normal or None), counted from 0."""
    def corner(p, t, n):
        text = "%d" % (p + 1)
        if t is not None or n is not None:
            text += "/" + ("%d" % (t + 1) if t is not None else "")
        return text + ("/%d" % (n + 1) if n is not None else "")

    with open(path_of("Model", name), "w") as f:
        f.write("# %s\n" % comment)
        for tag, rows in (("v", points), ("vt", uvs), ("vn", normals)):
            for row in rows:
                f.write("%s %s\n" % (tag, " ".join(number(c) for c in row)))
        for face in faces:
            f.write("f %s\n" % " ".join(corner(*c) for c in face))


# ---- models --------------------------------------------------------------------------------------------------

def lathe(name, comment, profile, segments):
    """A closed solid: the profile (radius, height), whose ends lie on the axis, turned about y."""
    inner = profile[1:-1]
    points = [(0, profile[0][1], 0)]
    for r, y in inner:
        for k in range(segments):
            a = 2 * math.pi * k / segments
            points.append((r * math.cos(a), y, -r * math.sin(a)))
    points.append((0, profile[-1][1], 0))
    rows = len(profile)
    uvs = [(k / segments, j / (rows - 1)) for j in range(rows) for k in range(segments + 1)]

    def corner(j, k):
        point = 0 if j == 0 else len(points) - 1 if j == rows - 1 else 1 + (j - 1) * segments + k % segments
        return (point, j * (segments + 1) + k, None)

    faces = []
    for j in range(rows - 1):
        for k in range(segments):
            quad = [corner(j, k), corner(j, k + 1), corner(j + 1, k + 1), corner(j + 1, k)]
            faces.append(drop_repeated(quad))
    write_obj(name, comment, points, faces, uvs)


def drop_repeated(face):
    """A quad at the axis has one point twice: it is a triangle."""
    kept = []
    for c in face:
        if c[0] not in [other[0] for other in kept]:
            kept.append(c)
    return kept


def spline(knots, steps):
    """A Catmull-Rom curve through the knots (Catmull and Rom 1974); a repeated knot makes a corner."""
    curve = [knots[0]]
    for i in range(len(knots) - 1):
        p0, p1, p2, p3 = knots[max(i - 1, 0)], knots[i], knots[i + 1], knots[min(i + 2, len(knots) - 1)]
        if p1 == p2:
            continue
        for k in range(1, steps + 1):
            t = k / steps
            curve.append(tuple(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                                      (3 * b - a - 3 * c + d) * t ** 3) for a, b, c, d in zip(p0, p1, p2, p3)))
    return curve


def make_vase():
    outside = spline([(0.42, 0), (0.42, 0), (0.46, 0.05), (0.60, 0.35), (0.72, 0.80), (0.66, 1.20), (0.42, 1.60),
                      (0.30, 1.90), (0.34, 2.15), (0.50, 2.34)], 5)
    inside = spline([(0.50, 2.34), (0.48, 2.37), (0.45, 2.34), (0.29, 2.14), (0.25, 1.90), (0.37, 1.60), (0.61, 1.20),
                     (0.67, 0.80), (0.55, 0.36), (0.34, 0.10)], 5)
    lathe("vase.obj", "a vase with a wall, closed, 2.37 high, stands on y = 0",
          [(0, 0)] + outside + inside[1:] + [(0, 0.08)], 48)


def make_glass():
    """A tumbler and the water in it; the water reaches 0.02 into the glass, so that no air is between."""
    bend = [(0.06 * math.sin(a), 0.06 * (1 - math.cos(a))) for a in (i * math.pi / 12 for i in range(7))]
    outside = [(0.49 + x, y) for x, y in bend] + [(0.55 + 0.0115 * i, 0.06 + 0.144 * i) for i in range(1, 11)]
    rim = [(0.640 + 0.025 * math.cos(a), 1.500 + 0.025 * math.sin(a)) for a in (i * math.pi / 8 for i in range(1, 9))]
    inside = [(0.615 - 0.012 * i, 1.50 - 0.131 * i) for i in range(1, 11)]
    floor = [(0.435 + 0.06 * math.cos(a), 0.19 - 0.06 * math.sin(a)) for a in (i * math.pi / 12 for i in range(1, 7))]
    lathe("tumbler.obj", "a drinking glass, closed, 1.525 high, stands on y = 0",
          [(0, 0)] + outside + rim + inside + floor + [(0, 0.13)], 64)
    wall = [(0.495 + 0.012 / 0.131 * (y - 0.19) + 0.02, y) for y in (0.20, 0.5, 0.8, 1.1)]
    lathe("water.obj", "the water in tumbler.obj; it reaches 0.02 into the glass", [(0, 0.11), (0.44, 0.11)] + wall +
          [(0, 1.1)], 64)


def make_cup():
    outside = spline([(0.36, 0), (0.36, 0), (0.38, 0.03), (0.36, 0.08), (0.50, 0.16), (0.68, 0.36), (0.80, 0.66),
                      (0.84, 0.92)], 5)
    inside = spline([(0.84, 0.92), (0.82, 0.945), (0.79, 0.92), (0.75, 0.66), (0.63, 0.39), (0.46, 0.22),
                     (0.2, 0.15)], 5)
    lathe("cup.obj", "a cup with a wall, closed, 0.945 high, stands on y = 0", [(0, 0)] + outside + inside[1:] +
          [(0, 0.14)], 48)
    tea = [(0.63 + 0.12 * (y - 0.39) / 0.27 + 0.02, y) for y in (0.40, 0.5, 0.6, 0.7)]
    lathe("tea.obj", "the liquid in cup.obj; it reaches into the wall of the cup", [(0, 0.3), (0.5, 0.3)] + tea +
          [(0, 0.7)], 48)
    arc = spline([(0.74, 0.76), (0.94, 0.80), (1.14, 0.70), (1.17, 0.50), (1.04, 0.33), (0.82, 0.27), (0.63, 0.27)], 5)
    make_tube("cup_handle.obj", "the handle of cup.obj; its ends lie inside the wall", arc, 0.055, 0.075, 12)


def make_tube(name, comment, path, half_width, half_depth, segments):
    """A closed tube of elliptic section along a curve (x, y) in the plane z = 0."""
    points, faces = [], []
    for i, (x, y) in enumerate(path):
        a, b = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(dx, dy)
        for k in range(segments):
            c, s = math.cos(2 * math.pi * k / segments), math.sin(2 * math.pi * k / segments)
            points.append((x - dy / length * half_width * c, y + dx / length * half_width * c, half_depth * s))
    for i in range(len(path) - 1):
        for k in range(segments):
            n = (k + 1) % segments
            quad = (i * segments + k, i * segments + n, (i + 1) * segments + n, (i + 1) * segments + k)
            faces.append([(p, None, None) for p in reversed(quad)])
    last = (len(path) - 1) * segments
    faces.append([(k, None, None) for k in range(segments)])
    faces.append([(last + k, None, None) for k in reversed(range(segments))])
    write_obj(name, comment, points, faces)


def icosphere(levels):
    g = (1 + math.sqrt(5)) / 2
    raw = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
           (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    points = [unit(p) for p in raw]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
             (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
             (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middles, split = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit(tuple((p + q) / 2 for p, q in zip(points[a], points[b]))))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = split
    return points, faces


def unit(p):
    length = math.sqrt(sum(c * c for c in p))
    return tuple(c / length for c in p)


def make_spheres():
    points, faces = icosphere(1)
    write_obj("ball80.obj", "80 triangles with the normals of the unit sphere", points,
              [[(p, None, p) for p in face] for face in faces], (), points)
    write_obj("ball80_plain.obj", "80 triangles inscribed in the unit sphere, without normals", points,
              [[(p, None, None) for p in face] for face in faces])
    points, faces = icosphere(5)

    def bump(p):
        x, y, z = p
        swell = 0.16 * math.sin(3.1 * x + 1.0) * math.sin(3.7 * y + 0.4) * math.sin(3.3 * z + 2.0)
        ripple = 0.035 * math.sin(11 * x + 4 * math.sin(3 * y)) * math.sin(12 * z + 3 * math.sin(4 * x) + 1.3)
        return tuple(c * (1 + swell + ripple) for c in p)

    write_obj("blob.obj", "a displaced sphere of 20480 triangles", [bump(p) for p in points],
              [[(p, None, None) for p in face] for face in faces])


def make_gem():
    """The dodecahedron: corners (+-1, +-1, +-1) and the cyclic (0, +-1/g, +-g), scaled to radius 1."""
    g = (1 + math.sqrt(5)) / 2
    points = [unit((x, y, z)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    for s in (-1, 1):
        for t in (-1, 1):
            points += [unit((0, s / g, t * g)), unit((s / g, t * g, 0)), unit((t * g, 0, s / g))]
    axes = [unit(p) for s in (-1, 1) for t in (-1, 1) for p in ((s, 0, t * g), (0, t * g, s), (t * g, s, 0))]
    faces = []
    for axis in axes:
        ring = sorted(range(20), key=lambda i: -sum(a * b for a, b in zip(axis, points[i])))[:5]
        start = points[ring[0]]
        along = sum(a * b for a, b in zip(axis, start))
        e1 = unit(tuple(s - along * a for s, a in zip(start, axis)))
        e2 = (axis[1] * e1[2] - axis[2] * e1[1], axis[2] * e1[0] - axis[0] * e1[2], axis[0] * e1[1] - axis[1] * e1[0])
        ring.sort(key=lambda i: math.atan2(sum(a * b for a, b in zip(e2, points[i])),
                                           sum(a * b for a, b in zip(e1, points[i]))) % (2 * math.pi - 1e-9))
        faces.append([(i, None, None) for i in ring])
    write_obj("dodecahedron.obj", "12 pentagons, corners on the unit sphere", points, faces)


def make_ground():
    write_obj("ground.obj", "the square -1..1 at y = 0, textures repeat 64 times along it",
              [(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)], [[(k, k, None) for k in range(4)]],
              [(0, 0), (64, 0), (64, 64), (0, 64)])


# ---- textures ------------------------------------------------------------------------------------------------

def checker(u, v):
    dark = (int(u * 8) + int(v * 8)) % 2
    return (0.20, 0.23, 0.29) if dark else (0.86, 0.84, 0.78)


def uv_grid(u, v):
    """Red grows with u, green with v; lines at tenths, strong ones at the edges and the middle."""
    colour = (0.15 + 0.8 * u, 0.15 + 0.8 * v, 0.35)
    near = min(abs((10 * c + 0.5) % 1 - 0.5) / 10 for c in (u, v))
    if near < 0.006:
        colour = mix(colour, (0.95, 0.95, 0.95), 0.7)
    strong = min(min(c, 1 - c, abs(c - 0.5)) for c in (u, v))
    return (0.98, 0.98, 0.95) if strong < 0.009 else colour


def planks(u, v):
    row = int(v * 4)
    across = v * 4 - row
    shift = hash01(row, 1, 7)
    board = int((u + shift) * 2) % 2
    end = abs(((u + shift) * 2) % 1 - 0.5)
    tone = 0.75 + 0.35 * hash01(row, board, 11)
    grain = fractal(u, (v + 0.01 * fractal(u, v, 3, 8, 2, 5)) % 1, 3, 60, 3, 20 + 3 * row + board)
    rings = 0.5 + 0.5 * math.sin(2 * math.pi * (6 * fractal(u, v, 2, 8, 2, 40 + row)))
    wood = mix((0.42, 0.27, 0.15), (0.66, 0.46, 0.28), 0.65 * grain + 0.35 * rings)
    gap = min(smoothstep(0, 0.03, min(across, 1 - across)), smoothstep(0, 0.008, 0.5 - end))
    return tuple(clamp(c * tone * (0.25 + 0.75 * gap)) for c in wood)


def plaster(u, v):
    t = fractal(u, v, 4, 4, 5, 70)
    fine = fractal(u, v, 48, 48, 2, 80)
    return tuple(c * (0.88 + 0.16 * t + 0.06 * (fine - 0.5)) for c in (0.86, 0.82, 0.74))


def brick_at(u, v):
    """The brick's column and row, and the distance to its joint in units of the tile's side."""
    row = int(v * 8)
    along = u * 4 + 0.5 * (row % 2)
    column = int(along) % 4
    du, dv = along - int(along), v * 8 - row
    return column, row, min(min(du, 1 - du) / 4, min(dv, 1 - dv) / 8)


def brick_colour(u, v):
    column, row, joint = brick_at(u, v)
    speck = fractal(u, v, 32, 32, 3, 90)
    face = mix((0.50, 0.20, 0.13), (0.70, 0.36, 0.24), hash01(column, row, 3))
    face = tuple(c * (0.8 + 0.4 * speck) for c in face)
    return mix(tuple(c * (0.85 + 0.2 * speck) for c in (0.70, 0.67, 0.62)), face, smoothstep(0.006, 0.012, joint))


def brick_height(u, v):
    column, row, joint = brick_at(u, v)
    return smoothstep(0.004, 0.016, joint) * (0.85 + 0.1 * hash01(column, row, 4)) + 0.15 * fractal(u, v, 24, 24, 3, 95)


def sky(u, v):
    """Longitude/latitude; a sun at longitude 0.12, 24 degrees high, and clouds on a flat layer."""
    longitude, latitude = 2 * math.pi * (u - 0.5), math.pi * (v - 0.5)
    d = (math.sin(longitude) * math.cos(latitude), math.sin(latitude), -math.cos(longitude) * math.cos(latitude))
    a, h = 2 * math.pi * 0.12, math.radians(24)
    sun = (math.sin(a) * math.cos(h), math.sin(h), -math.cos(a) * math.cos(h))
    towards = max(sum(p * q for p, q in zip(d, sun)), 0.0)
    if d[1] < 0:
        return mix((0.66, 0.75, 0.83), (0.22, 0.34, 0.40), smoothstep(0, 0.45, -d[1]))
    colour = mix((0.74, 0.82, 0.90), (0.16, 0.34, 0.68), smoothstep(-0.05, 0.75, d[1]))
    colour = tuple(c + g * towards ** 40 for c, g in zip(colour, (0.35, 0.28, 0.16)))
    reach = 1.0 / (d[1] + 0.12)
    x, z = (d[0] * reach / 24 + 0.5) % 1, (d[2] * reach / 24 + 0.5) % 1
    cover = smoothstep(0.50, 0.68, fractal(x, z, 16, 16, 5, 200)) * smoothstep(0.02, 0.20, d[1])
    colour = mix(colour, (0.95, 0.95, 0.96), 0.85 * cover)
    return mix(colour, (1.0, 0.98, 0.90), smoothstep(0.9988, 0.9994, towards))


def ripples(u, v):
    """A single-channel height: three rings of waves that fit the tile's edges."""
    total = 0.0
    for k, (cu, cv, waves) in enumerate(((3, 1, 1.0), (-2, 3, 0.8), (1, 5, 0.5), (6, -2, 0.3))):
        total += waves * math.sin(2 * math.pi * (cu * u + cv * v + hash01(k, 0, 9)))
    return (0.5 + total / 5.2,)


def stud_height(u, v):
    """A round stud in every cell of an 8 by 8 grid."""
    x, y = (u * 8) % 1 - 0.5, (v * 8) % 1 - 0.5
    return math.sqrt(max(0.16 - x * x - y * y, 0.0)) * 2.5


def main():
    make_vase()
    make_glass()
    make_cup()
    make_spheres()
    make_gem()
    make_ground()
    write_png("Texture", "checker.png", 256, 256, checker)
    write_png("Texture", "uv_grid.png", 256, 256, uv_grid)
    write_png("Texture", "planks.png", 512, 512, planks)
    write_png("Texture", "plaster.png", 256, 256, plaster)
    write_png("Texture", "bricks.png", 512, 512, brick_colour)
    write_png("Texture", "sky.png", 1024, 512, sky)
    write_normal_map("Bump", "bricks_normal.png", 512, brick_height, 0.012)
    write_normal_map("Bump", "studs_normal.png", 256, stud_height, 0.03)
    write_png("Bump", "ripples_height.png", 256, 256, ripples)


if __name__ == "__main__":
    main()
