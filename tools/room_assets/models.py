"""Turned, swept and folded things of the room. Metres; everything stands on y = 0 unless it says otherwise."""
import math

from fields import path_of
from make_assets import spline

TAU = 2 * math.pi


def number(x):
    text = "%.5f" % x
    return "0" if float(text) == 0 else text.rstrip("0").rstrip(".")


def write_obj(name, comment, points, faces, uvs=()):
    """faces: lists of corners (point, uv or None), counted from 0."""
    with open(path_of("Model", name), "w") as f:
        f.write("# %s\n" % comment)
        for tag, rows in (("v", points), ("vt", uvs)):
            for row in rows:
                f.write("%s %s\n" % (tag, " ".join(number(c) for c in row)))
        for face in faces:
            f.write("f %s\n" % " ".join("%d" % (p + 1) if t is None else "%d/%d" % (p + 1, t + 1) for p, t in face))


def grid_faces(rows, columns, wrap):
    """Quads of a grid of points, `columns` to a row; uvs have one column more where the grid wraps."""
    faces, across = [], columns + 1 if wrap else columns
    for j in range(rows - 1):
        for i in range(columns if wrap else columns - 1):
            n = (i + 1) % columns
            faces.append([(j * columns + i, j * across + i), (j * columns + n, j * across + i + 1),
                          ((j + 1) * columns + n, (j + 1) * across + i + 1), ((j + 1) * columns + i, (j + 1) * across + i)])
    return faces


def lathe(name, comment, profile, segments, v_by_height=True):
    """A closed solid: the profile (radius, height) from axis to axis, turned about y; u starts at -z, v goes up."""
    inner = profile[1:-1]
    rows = len(inner)
    points = [(-r * math.sin(TAU * k / segments), y, -r * math.cos(TAU * k / segments)) for r, y in inner for k in range(segments)]
    low, high = min(y for _, y in profile), max(y for _, y in profile)
    uvs = []
    for j, (_, y) in enumerate(inner):
        v = (y - low) / (high - low) if v_by_height else j / (rows - 1)
        uvs += [(k / segments, v) for k in range(segments + 1)]
    faces = [list(reversed(face)) for face in grid_faces(rows, segments, True)]
    first, last = len(points), len(points) + 1
    points += [(0, profile[0][1], 0), (0, profile[-1][1], 0)]
    uvs += [(0.5, uvs[0][1]), (0.5, uvs[-1][1])]
    top, across = (rows - 1) * segments, segments + 1
    for k in range(segments):
        n = (k + 1) % segments
        faces.append([(k, k), (n, k + 1), (first, len(uvs) - 2)])
        faces.append([(top + n, (rows - 1) * across + k + 1), (top + k, (rows - 1) * across + k), (last, len(uvs) - 1)])
    write_obj(name, comment, points, [list(reversed(f)) for f in faces], uvs)


def arc(cx, cy, r, a, b, steps):
    """Points of a circle from angle a to b in degrees."""
    return [(cx + r * math.cos(math.radians(a + (b - a) * k / steps)), cy + r * math.sin(math.radians(a + (b - a) * k / steps)))
            for k in range(steps + 1)]


def line(a, b, steps):
    return [tuple(p + (q - p) * k / steps for p, q in zip(a, b)) for k in range(steps + 1)]


def tumbler():
    """A drinking glass 0.115 high with a thick base, and water to 0.078 that reaches 0.4 mm into its wall."""
    outside = arc(0.0285, 0.004, 0.004, -90, -8, 8) + line((0.0326, 0.006), (0.0385, 0.1120), 18)
    rim = arc(0.03735, 0.1134, 0.00115, 0, 180, 10)
    inside = line((0.0362, 0.1120), (0.0312, 0.0190), 18) + arc(0.0272, 0.0165, 0.0040, 0, -90, 8)
    lathe("room_tumbler.obj", "a drinking glass, closed", [(0, 0)] + outside + rim + inside + [(0, 0.0118)], 120)
    wall = [(0.0312 + (y - 0.0190) * 0.0050 / 0.0930 + 0.0004, y) for y in (0.0190, 0.034, 0.049, 0.064, 0.0768)]
    meniscus = [(wall[-1][0], 0.0780), (wall[-1][0] - 0.0010, 0.0772), (wall[-1][0] - 0.0030, 0.07685)]
    bowl = [(r + 0.0004 * (r > 0.0275), y - 0.0004 * (y < 0.0135)) for r, y in reversed(arc(0.0272, 0.0165, 0.0040, 0, -90, 8))]
    lathe("room_water.obj", "the water in room_tumbler.obj", [(0, 0.0114)] + bowl + wall + meniscus + [(0, 0.0768)], 96)


def chime():
    """A wind chime's bell of thin glass, open below, hung by its top at y = 0."""
    outside = [(0.034 * math.cos(t), -0.036 + 0.036 * math.sin(t)) for t in (math.radians(a) for a in range(-38, 90, 8))]
    inside = [(r - 0.0016 * math.cos(math.atan2(y + 0.036, r)), y - 0.0016 * math.sin(math.atan2(y + 0.036, r))) for r, y in reversed(outside)]
    lathe("room_chime.obj", "a glass bell", [(0, -0.0018)] + inside + outside + [(0, 0.0)], 96)


def bowls():
    outside = spline([(0.030, 0), (0.030, 0), (0.031, 0.008), (0.029, 0.010), (0.045, 0.018), (0.062, 0.036), (0.071, 0.062)], 6)
    inside = spline([(0.0685, 0.062), (0.0595, 0.037), (0.043, 0.0215), (0.020, 0.016)], 6)
    lathe("room_bowl.obj", "a rice bowl, whose rim is a torus of radius 0.06975 at y = 0.062", [(0, 0)] + outside + inside + [(0, 0.0150)], 72)
    outside = spline([(0.024, 0), (0.024, 0), (0.026, 0.004), (0.034, 0.012), (0.039, 0.030), (0.040, 0.062), (0.0405, 0.074)], 6)
    inside = spline([(0.0405, 0.074), (0.0395, 0.0755), (0.0380, 0.074), (0.0365, 0.055), (0.0355, 0.030), (0.028, 0.014), (0.014, 0.010)], 6)
    lathe("room_teacup.obj", "a tea cup without a handle", [(0, 0)] + outside + inside[1:] + [(0, 0.0095)], 72)
    outside = spline([(0.060, 0), (0.060, 0), (0.066, 0.006), (0.095, 0.014), (0.125, 0.024)], 6)
    inside = spline([(0.125, 0.024), (0.124, 0.0262), (0.121, 0.0255), (0.090, 0.016), (0.05, 0.0105)], 6)
    lathe("room_plate.obj", "a plate", [(0, 0)] + outside + inside[1:] + [(0, 0.0095)], 72)


def kettle():
    body = spline([(0.050, 0), (0.050, 0), (0.075, 0.008), (0.094, 0.045), (0.092, 0.078), (0.072, 0.106), (0.046, 0.116)], 8)
    neck = spline([(0.046, 0.116), (0.043, 0.117), (0.042, 0.121), (0.0385, 0.121)], 4)
    lathe("room_kettle.obj", "an iron kettle's body", [(0, 0)] + body + neck[1:] + [(0, 0.120)], 96)
    lid = spline([(0.040, 0.121), (0.041, 0.123), (0.034, 0.128), (0.014, 0.132), (0.007, 0.134), (0.005, 0.139), (0.010, 0.144), (0.009, 0.150)], 5)
    lathe("room_kettle_lid.obj", "the kettle's lid", [(0, 0.1205)] + lid + [(0, 0.153)], 60)
    spout = spline([(0.070, 0.058), (0.102, 0.070), (0.118, 0.092), (0.138, 0.112)], 8)
    tube("room_kettle_spout.obj", "the kettle's spout", [(x, y, 0) for x, y in spout], lambda t: 0.019 - 0.009 * t, 24)
    hoop = [(0.078 * math.cos(a), 0.098 + 0.105 * math.sin(a), 0) for a in (math.radians(d) for d in range(0, 181, 5))]
    tube("room_kettle_handle.obj", "the kettle's handle", hoop, lambda t: 0.0042 + 0.0022 * math.sin(math.pi * t), 16)


def tube(name, comment, path, radius, segments):
    """A closed tube along a curve, its section carried along without twist."""
    points, frame = [], None
    for i, p in enumerate(path):
        a, b = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        d = normal(tuple(q - r for q, r in zip(b, a)))
        n = frame or (normal(cross(d, (0, 0, 1))) if abs(d[2]) < 0.9 else normal(cross(d, (1, 0, 0))))
        along = sum(x * y for x, y in zip(n, d))
        n = normal(tuple(x - along * y for x, y in zip(n, d)))
        frame, m, r = n, cross(d, n), radius(i / (len(path) - 1))
        for k in range(segments):
            c, s = math.cos(TAU * k / segments) * r, math.sin(TAU * k / segments) * r
            points.append(tuple(q + c * x + s * y for q, x, y in zip(p, n, m)))
    uvs = [(k / segments, j / (len(path) - 1)) for j in range(len(path)) for k in range(segments + 1)]
    faces = grid_faces(len(path), segments, True)
    last = (len(path) - 1) * segments
    faces.append([(k, k) for k in reversed(range(segments))])
    faces.append([(last + k, k) for k in range(segments)])
    write_obj(name, comment, points, faces, uvs)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal(a):
    s = math.sqrt(sum(c * c for c in a))
    return tuple(c / s for c in a)


def cushion():
    """A square seat cushion, 1 x 1 and 0.2 thick about y = 0: full in the middle, thin seams, tufted, creased."""
    n = 60
    points, uvs, faces = [], [], []
    for side in (1, -1):
        base, uv_base = len(points), len(uvs)
        for j in range(n + 1):
            for i in range(n + 1):
                s, t = 2 * i / n - 1, 2 * j / n - 1
                pull = 0.06 * (1 - s * s) * (1 - t * t) + 0.07 * (s * s + t * t - s * s * t * t - 0.6) * 0.5
                edge_x, edge_z = s * (1 - 0.055 * (1 - t * t)), t * (1 - 0.055 * (1 - s * s))
                full = max(0.0, (1 - s ** 4) * (1 - t ** 4)) ** 0.55
                tuft = math.exp(-(s * s + t * t) / 0.010)
                dimple = math.exp(-(s * s + t * t) / 0.09)
                angle = math.atan2(t, s)
                crease = 0.006 * math.sin(7 * angle + 0.8) * dimple + 0.004 * math.sin(19 * s + 3 * t) * (1 - full) * full * 4
                y = side * 0.105 * full * (1 - 0.30 * dimple - 0.45 * tuft) + side * crease * full + 0.0 * pull
                if side == -1:
                    y *= 0.75
                points.append((0.5 * edge_x, y, 0.5 * edge_z))
                uvs.append(((s + 1) / 2, (1 - t) / 2))
        for j in range(n):
            for i in range(n):
                q = [j * (n + 1) + i, (j + 1) * (n + 1) + i, (j + 1) * (n + 1) + i + 1, j * (n + 1) + i + 1]
                faces.append([(base + k, uv_base + k) for k in (q if side == 1 else reversed(q))])
    write_obj("room_cushion.obj", "a seat cushion", points, faces, uvs)


def leaf():
    """A maple leaf of seven lobes with toothed edges, 1 long along +y from its stem at the origin, a little cupped."""
    lobes = [(-128, 0.42), (-84, 0.66), (-42, 0.86), (0, 1.0), (42, 0.86), (84, 0.66), (128, 0.42)]
    rim = []
    for i, (a, r) in enumerate(lobes):
        rim += [(a - 9, r * 0.62), (a - 5.5, r * 0.80), (a, r), (a + 5.5, r * 0.80), (a + 9, r * 0.62)]
        if i + 1 < len(lobes):
            rim.append(((a + lobes[i + 1][0]) / 2, 0.30 * (r + lobes[i + 1][1]) / 2 + 0.03))
    centre = (0.0, 0.18)

    def bend(x, y):
        return (x, y, -0.16 * x * x - 0.10 * (y - 0.2) ** 2 + 0.05 * math.cos(6 * math.atan2(x, y - 0.18)) * math.hypot(x, y - 0.18))

    points = [bend(*centre)]
    for a, r in [(-180, 0.17)] + rim:
        points.append(bend(math.sin(math.radians(a)) * r * 0.82, centre[1] + math.cos(math.radians(a)) * r * 0.82))
    n = len(points) - 1
    faces = [[(0, None), (1 + (k + 1) % n, None), (1 + k, None)] for k in range(n)]
    stem = len(points)
    points += [(-0.008, 0.03, 0), (0.008, 0.03, 0), (0.006, -0.30, 0.03), (-0.006, -0.30, 0.03)]
    faces.append([(stem, None), (stem + 3, None), (stem + 2, None), (stem + 1, None)])
    write_obj("room_leaf.obj", "a maple leaf", points, faces)


def petal():
    """One petal of a bellflower: five of them, turned by 72 degrees, make a star; its tip points along +y."""
    n, points, uvs = 10, [], []
    for j in range(n + 1):
        t = j / n
        half = 0.36 * math.sin(math.pi * min(1.0, 0.18 + 0.82 * t)) ** 0.8 * (1 - 0.12 * t) + 0.01
        if j == n:
            half = 0.012
        for i in range(7):
            s = i / 3 - 1
            points.append((half * s, 0.16 + t * 0.84, 0.30 * t * t - 0.30 * t + 0.10 * s * s - 0.05 * (1 - abs(s)) * math.sin(math.pi * t)))
            uvs.append(((s + 1) / 2, t))
    write_obj("room_petal.obj", "a bellflower's petal", points, grid_faces(n + 1, 7, False), uvs)


def doll():
    body = spline([(0.026, 0), (0.026, 0), (0.0275, 0.003), (0.0255, 0.03), (0.0235, 0.062), (0.021, 0.080), (0.012, 0.086), (0.009, 0.090)], 6)
    lathe("room_doll.obj", "a turned doll's body", [(0, 0)] + body + [(0, 0.090)], 72)


def boards():
    """Boxes 1 x 1 x 1 about the origin, grain along y; the texture is repeated k times along, once across a side."""
    for k in (1, 3, 8):
        points = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
        sides = [((0, 1, 3, 2), 0.00), ((5, 4, 6, 7), 0.37), ((1, 5, 7, 3), 0.61), ((4, 0, 2, 6), 0.19)]
        faces, uvs = [], []
        for quad, shift in sides:
            n = len(uvs)
            uvs += [(shift, shift), (shift + 0.55, shift), (shift + 0.55, shift + k), (shift, shift + k)]
            faces.append([(quad[0], n), (quad[1], n + 1), (quad[2], n + 2), (quad[3], n + 3)])
        for quad in ((0, 4, 5, 1), (2, 3, 7, 6)):
            n = len(uvs)
            uvs += [(0.1, 0.1), (0.3, 0.1), (0.3, 0.2), (0.1, 0.2)]
            faces.append([(q, n + i) for i, q in enumerate(quad)])
        write_obj("room_board_%d.obj" % k, "a board, the texture %d times along it" % k, points, faces, uvs)


def sheets():
    """Squares -0.5..0.5 in the plane z = 0 that face +z, the texture repeated a by b times."""
    for a, b in ((1, 1), (2, 4), (4, 3), (5, 4)):
        points = [(-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0)]
        write_obj("room_sheet_%dx%d.obj" % (a, b), "a square with %d by %d textures" % (a, b), points,
                  [[(k, k) for k in range(4)]], [(0, 0), (a, 0), (a, b), (0, b)])


def round_window():
    """A wall in the plane z = 0, x from -2.4 to 2, y from 0 to 2.6, with a round hole of radius 0.52 about (0, 0),
    which lies at x = 0, y = 1.18 of that wall; the hole's edge is 0.12 deep. Textures repeat every 1.1."""
    n, r, depth = 160, 0.52, 0.12
    x0, x1, y0, y1 = -3.4, 1.2, -1.18, 1.42
    points, uvs, faces = [], [], []

    def add(x, y, z, u, v):
        points.append((x, y, z))
        uvs.append((u / 1.1, v / 1.1))

    for k in range(n):
        a = TAU * (k + 0.5) / n
        c, s = math.cos(a), math.sin(a)
        t = min((x1 if c > 0 else x0) / c, (y1 if s > 0 else y0) / s)
        add(c * r, s * r, 0, c * r, s * r)
        add(c * t, s * t, 0, c * t, s * t)
        add(c * r, s * r, -depth, c * r, s * r - depth)
    for k in range(n):
        i, j = 3 * k, 3 * ((k + 1) % n)
        faces.append([(p, p) for p in (i, i + 1, j + 1, j)])
        faces.append([(p, p) for p in (i + 2, i, j, j + 2)])
    corners = [(x1, y1), (x0, y1), (x0, y0), (x1, y0)]
    for cx, cy in corners:
        nearest = sorted(range(n), key=lambda k: (points[3 * k + 1][0] - cx) ** 2 + (points[3 * k + 1][1] - cy) ** 2)
        on_x = next(k for k in nearest if abs(points[3 * k + 1][0] - cx) < 1e-9)
        on_y = next(k for k in nearest if abs(points[3 * k + 1][1] - cy) < 1e-9)
        add(cx, cy, 0, cx, cy)
        a, b = 3 * on_x + 1, 3 * on_y + 1
        new = len(points) - 1
        faces.append([(p, p) for p in ((a, new, b) if cx * cy > 0 else (b, new, a))])
    write_obj("room_round_window.obj", "a wall with a round hole", points, faces, uvs)


ALL = (tumbler, chime, bowls, kettle, cushion, leaf, petal, doll, boards, sheets, round_window)
