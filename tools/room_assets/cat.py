"""The cat: a distance field of rounded bones, joined smoothly, meshed by surface nets (S. Gibson, Constrained
Elastic Surface Nets, 1998). It sits, 0.37 high, and looks along +z."""
import math

from models import write_obj

TAU = 2 * math.pi
CELL = 0.0039


def ball(c, r):
    """An ellipsoid: centre, radii."""
    cx, cy, cz = c
    rx, ry, rz = r
    least = min(r)

    def f(x, y, z):
        px, py, pz = (x - cx) / rx, (y - cy) / ry, (z - cz) / rz
        k0 = math.sqrt(px * px + py * py + pz * pz)
        k1 = math.sqrt((px / rx) ** 2 + (py / ry) ** 2 + (pz / rz) ** 2)
        return k0 * (k0 - 1) / k1 if k1 > 1e-9 else -least
    return f, tuple(p - q for p, q in zip(c, r)), tuple(p + q for p, q in zip(c, r))


def bone(a, ra, b, rb, flat=1.0):
    """A rod from a to b whose radius goes from ra to rb; flat < 1 makes it thin along z."""
    ax, ay, az = a
    dx, dy, dz = (q - p for p, q in zip(a, b))
    dz /= flat
    d2 = dx * dx + dy * dy + dz * dz

    def f(x, y, z):
        px, py, pz = x - ax, y - ay, (z - az) / flat
        t = min(max((px * dx + py * dy + pz * dz) / d2, 0.0), 1.0)
        px, py, pz = px - t * dx, py - t * dy, pz - t * dz
        return (math.sqrt(px * px + py * py + pz * pz) - ra - (rb - ra) * t) * (1 if flat > 0.7 else 0.7)
    r = max(ra, rb)
    return f, tuple(min(p, q) - r for p, q in zip(a, b)), tuple(max(p, q) + r for p, q in zip(a, b))


def sides(make):
    return [make(-1), make(1)]


def parts():
    """(shape, width of the smooth joint) in the order in which they are joined."""
    tail = [(0.010, 0.030, -0.100), (0.060, 0.022, -0.120), (0.108, 0.020, -0.090), (0.132, 0.019, -0.030), (0.124, 0.019, 0.035),
            (0.092, 0.019, 0.085), (0.050, 0.018, 0.112)]
    shapes = [(ball((0, 0.090, -0.030), (0.078, 0.094, 0.088)), 0), (ball((0, 0.150, -0.012), (0.066, 0.090, 0.066)), 0.04),
              (ball((0, 0.195, 0.018), (0.054, 0.062, 0.050)), 0.04), (ball((0, 0.165, 0.042), (0.044, 0.058, 0.034)), 0.03),
              (bone((0, 0.205, 0.015), 0.044, (0, 0.252, 0.030), 0.042), 0.03)]
    for s in (-1, 1):
        shapes += [(ball((0.060 * s, 0.062, 0.000), (0.036, 0.060, 0.070)), 0.025),
                   (bone((0.066 * s, 0.016, -0.020), 0.018, (0.070 * s, 0.015, 0.070), 0.015), 0.015),
                   (ball((0.070 * s, 0.014, 0.076), (0.019, 0.014, 0.022)), 0.010),
                   (bone((0.030 * s, 0.165, 0.040), 0.027, (0.026 * s, 0.070, 0.066), 0.018), 0.025),
                   (bone((0.026 * s, 0.075, 0.066), 0.018, (0.024 * s, 0.022, 0.070), 0.0145), 0.012),
                   (ball((0.024 * s, 0.014, 0.082), (0.019, 0.014, 0.025)), 0.010)]
    shapes += [(ball((0, 0.283, 0.040), (0.058, 0.050, 0.050)), 0.020)]
    for s in (-1, 1):
        shapes += [(ball((0.032 * s, 0.268, 0.056), (0.032, 0.027, 0.030)), 0.020),
                   (bone((0.036 * s, 0.314, 0.032), 0.023, (0.050 * s, 0.364, 0.030), 0.0035, 0.60), 0.012)]
    for s in (-1, 1):
        shapes.append((ball((0.011 * s, 0.2655, 0.088), (0.0145, 0.0115, 0.012)), 0.008))
    shapes += [(ball((0, 0.2790, 0.083), (0.013, 0.017, 0.014)), 0.012), (ball((0, 0.254, 0.080), (0.011, 0.009, 0.011)), 0.008)]
    for k in range(len(tail) - 1):
        shapes.append((bone(tail[k], 0.0175 - 0.0004 * k, tail[k + 1], 0.0171 - 0.0004 * k), 0.012))
    hollows = []
    for s in (-1, 1):
        hollows += [(bone((0.0375 * s, 0.318, 0.049), 0.0145, (0.0495 * s, 0.353, 0.040), 0.002, 0.62), 0.004),
                    (ball((0.0235 * s, 0.2905, 0.0925), (0.0125, 0.0115, 0.0135)), 0.006)]
    return shapes, hollows


def join(a, b, k):
    if k == 0 or abs(a - b) >= k:
        return min(a, b)
    h = (k - abs(a - b)) / k
    return min(a, b) - h * h * k * 0.25


def field(box_low, size):
    """Distances on the lattice; a part is looked at only where it can change the result."""
    nx, ny, nz = size
    far = 0.03
    values = [far] * (nx * ny * nz)
    shapes, hollows = parts()
    for sign, group in ((1, shapes), (-1, hollows)):
        for (f, low, high), k in group:
            reach = max(k, 0.006) + 0.004 if sign == 1 else 0.012
            span = [range(max(0, int((lo - reach - b) / CELL)), min(n, int((hi + reach - b) / CELL) + 2))
                    for lo, hi, b, n in zip(low, high, box_low, size)]
            for i in span[0]:
                x = box_low[0] + i * CELL
                for j in span[1]:
                    y = box_low[1] + j * CELL
                    row = (i * ny + j) * nz
                    for m in span[2]:
                        d = f(x, y, box_low[2] + m * CELL)
                        old = values[row + m]
                        values[row + m] = join(old, d, k) if sign == 1 else -join(-old, d, k)
    return values


def surface(values, box_low, size):
    """One point in each cell that the surface crosses, the mean of its edges' crossings; a quad for each crossed edge."""
    nx, ny, nz = size
    steps = (ny * nz, nz, 1)
    corners = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
    edges = [(p, q) for p in range(8) for q in range(p + 1, 8) if sum(abs(s - t) for s, t in zip(corners[p], corners[q])) == 1]
    offsets = [sum(s * t for s, t in zip(c, steps)) for c in corners]
    index, points = {}, []
    for i in range(nx - 1):
        for j in range(ny - 1):
            for k in range(nz - 1):
                at = i * steps[0] + j * steps[1] + k
                d = [values[at + o] for o in offsets]
                if min(d) >= 0 or max(d) < 0:
                    continue
                total, count = [0.0, 0.0, 0.0], 0
                for p, q in edges:
                    if (d[p] < 0) != (d[q] < 0):
                        t = d[p] / (d[p] - d[q])
                        for axis in range(3):
                            total[axis] += corners[p][axis] + (corners[q][axis] - corners[p][axis]) * t
                        count += 1
                index[at] = len(points)
                points.append(tuple(b + (n + s / count) * CELL for b, n, s in zip(box_low, (i, j, k), total)))
    quads = []
    for at in index:
        for axis in range(3):
            s, t = steps[(axis + 1) % 3], steps[(axis + 2) % 3]
            inside = values[at] < 0
            if at + steps[axis] < len(values) and inside != (values[at + steps[axis]] < 0):
                quad = [at - s - t, at - t, at, at - s]
                if all(q in index for q in quad):
                    quad = [index[q] for q in quad]
                    quads.append(quad if inside else quad[::-1])
    return points, quads


def relaxed(points, quads, rounds):
    """Taubin's smoothing (A Signal Processing Approach to Fair Surface Design, 1995)."""
    near = [set() for _ in points]
    for q in quads:
        for k in range(4):
            near[q[k]].add(q[(k + 1) % 4])
            near[q[(k + 1) % 4]].add(q[k])
    near = [sorted(n) for n in near]
    for step in range(2 * rounds):
        weight = 0.5 if step % 2 == 0 else -0.52
        points = [tuple(p[a] + weight * (sum(points[m][a] for m in n) / len(n) - p[a]) for a in range(3)) if n else p
                  for p, n in zip(points, near)]
    return points


def make_cat():
    low, high = (-0.115, -0.012, -0.155), (0.165, 0.385, 0.145)
    size = tuple(int((h - b) / CELL) + 2 for b, h in zip(low, high))
    points, quads = surface(field(low, size), low, size)
    points = relaxed(points, quads, 3)
    uvs, faces = [], []
    base = []
    for x, y, z in points:
        axis = -0.02 + 0.055 * min(max((y - 0.19) / 0.05, 0.0), 1.0)
        base.append((math.atan2(x, z - axis) / TAU + 0.5, y / 0.4))
    uvs = list(base)
    moved = {}
    for q in quads:
        us = [base[p][0] for p in q]
        face = []
        for p, u in zip(q, us):
            if max(us) - u > 0.5:
                if p not in moved:
                    moved[p] = len(uvs)
                    uvs.append((u + 1, base[p][1]))
                face.append((p, moved[p]))
            else:
                face.append((p, p))
        faces.append(face)
    write_obj("room_cat.obj", "a cat", points, faces, uvs)


ALL = (make_cat,)
