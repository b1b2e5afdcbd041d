"""Certified oracle for solids of several parts. Needs python-flint, as oracle.py, whose exact numbers it uses.

A solid is an expression (and, or, not) of atoms. An atom is a set of points that is decided exactly: a polynomial
inequality of degree 2 (or of 4, for a torus), or "not above these heights". Along a line the atoms' boundaries are
roots that are isolated with proof. Between two neighbouring roots one rational point is asked of every atom, exactly,
and the expression is evaluated; the solid's surface is where its value changes. No crossing is ever counted, and
nothing is known of what leaf a root belongs to: coincident faces need no rule.

  trace(solid, o, d) -> Result: hits of the whole line, ascending; lengths in the space of the solid.

For every hit: t (oracle.Root), n (outward), cos, nm (shift of the line after which the normal may be another), rad (the
least radius of curvature, or the size of what is flat) and noise: S, or more where the coefficients of a quadric, each
moved by one rounding, move the surface by more. margin: the smallest shift of the line that changes the set of hits, in
units of S.
"""
from flint import fmpq, arb
import math
import oracle as O

FAR = 2.0 ** -26
SAME = 2.5 * 4096 * O.EPS        # surfaces closer than 4096 roundings of the coordinates count as one, by design


def root_sum(v):
    return math.sqrt(sum(x * x for x in v))


def number(x):
    return O.fl(O.A(x)) if isinstance(x, fmpq) else O.fl(x)


class Cut:
    """An atom's boundary on the line."""
    __slots__ = ("t", "n", "cos", "noise", "rad", "nm", "atom")


class Line:
    """The ray in the space of a leaf. S: the noise scale there; scale: lengths in the whole's space for those here."""

    def __init__(self, place, o, d, S):
        self.scale, self.inv = 1.0, None
        self.o, self.d = o, d
        if place is not None:
            self.o, self.d, S, self.inv = O.ray_to_object(place, o, d)
            det = O.vdot(self.inv[0], O.cross(self.inv[1], self.inv[2]))
            self.scale = abs(O.rnd(det)) ** (-1 / 3)
        self.S = max([S] + [abs(O.rnd(x)) for x in self.o])

    def normal(self, n):
        if self.inv is None:
            return n
        return [sum((O.A(self.inv[k][i]) * n[k] for k in range(3)), arb(0)) for i in range(3)]

    def at(self, t):
        return O.at(self.o, self.d, t)

    def foot(self, c):
        return O.vdot(O.vsub(c, self.o), self.d) / O.vdot(self.d, self.d)

    def speed(self):
        return number(O.A(O.vdot(self.d, self.d)).sqrt())


def cut_at(line, atom, t, n, S, rad, nm=math.inf, noise=0.0):
    cut = Cut()
    cut.t, cut.atom, cut.nm, cut.rad = t, atom, nm * line.scale, rad * line.scale
    length = O.vdot(n, n)
    d = [O.A(x) for x in line.d]
    if length.contains(0):
        cut.cos, cut.n = 0.0, [arb(0)] * 3
    else:
        cut.cos = abs(O.fl(O.vdot(n, d) / (length * O.vdot(d, d)).sqrt()))
        n = line.normal(n)
        size = O.vdot(n, n).sqrt()
        cut.n = [x / size for x in n]
    cut.noise = line.scale * max(S, noise)
    return cut


class Quad:
    """p.M p + l.p + c <= 0. `rad`: radius of curvature, a number or a function of a hit; size: of the leaf."""

    def __init__(self, M, l, c, size, rad=None, given=False):
        self.M, self.l, self.c, self.size, self.given = M, l, c, size, given
        self.rad = size if rad is None else rad
        self.bend = 2 * root_sum([O.rnd(x) for row in M for x in row])

    def times(self, v):
        return [O.vdot(row, v) for row in self.M]

    def along(self, line):
        Md = self.times(line.d)
        return [O.vdot(self.times(line.o), line.o) + O.vdot(self.l, line.o) + self.c,
                2 * O.vdot(Md, line.o) + O.vdot(self.l, line.d), O.vdot(Md, line.d)]

    def magnitude(self, p):
        p = [abs(O.fl(x)) for x in p]
        return (sum(abs(O.rnd(self.M[i][j])) * p[i] * p[j] for i in range(3) for j in range(3))
                + sum(abs(O.rnd(self.l[i])) * p[i] for i in range(3)) + abs(O.rnd(self.c)))

    def slope(self, p):
        return [2 * sum((O.A(self.M[i][j]) * p[j] for j in range(3)), arb(0)) + O.A(self.l[i]) for i in range(3)]

    def meet(self, line):
        """-> cuts, margin in units of S, whether inside at a rational t; None where the line lies in the surface"""
        f = self.along(line)
        roots = O.real_roots(f)
        if roots is None:
            return None
        S = max(line.S, self.size)
        cuts = []
        for t in roots:
            p = line.at(t)
            n = self.slope(p)
            g = root_sum([O.fl(x) for x in n])
            noise = self.magnitude(p) / g if self.given and g > 0 else 0.0
            rad = self.rad(p) if callable(self.rad) else self.rad
            cuts.append(cut_at(line, self, t, n, S, rad, noise=noise))
        return cuts, self.margin(line, f, S), lambda t: f[0] + t * (f[1] + t * f[2]) <= 0

    def margin(self, line, f, S):
        if f[2] == 0 and f[1] != 0:
            return math.inf
        tm = -f[1] / (2 * f[2]) if f[2] != 0 else line.foot([fmpq(0)] * 3)
        p = line.at(O.Root(O.A(tm), tm))
        value = abs(O.rnd(f[0] + tm * (f[1] + tm * f[2])))
        g = root_sum([O.fl(x) for x in self.slope(p)])
        # No nearer than where the slope and the bend at most can bring the value to 0.
        distance = 2 * value / (g + math.sqrt(g * g + 2 * self.bend * value)) if value else 0.0
        if not self.given or value == 0:
            return distance / S
        return min(distance / S, value / self.magnitude(p))


class Torus:
    def __init__(self, params):
        self.params = params
        self.c, self.R, self.r = [O.Q(x) for x in params[:3]], O.Q(params[3]), O.Q(params[4])

    def meet(self, line):
        found = O.intersect("torus", self.params, line.o, line.d)
        S = max(line.S, max(abs(x) for x in self.params[:3]) + self.params[3] + self.params[4])
        cuts = []
        for hit in found.hits:
            q = [hit.p[i] - O.A(self.c[i]) for i in range(2)]
            rad = min(self.params[4], math.hypot(O.fl(q[0]), O.fl(q[1])))
            cuts.append(cut_at(line, self, hit.t, hit.n, S, rad))

        def inside(t):
            p = [line.o[i] + t * line.d[i] - self.c[i] for i in range(3)]
            across = p[0] * p[0] + p[1] * p[1]
            g = across + p[2] * p[2] + self.R * self.R - self.r * self.r
            return g * g <= 4 * self.R * self.R * across
        return cuts, found.dm / S, inside


class Heights:
    """Not above heights over the unit square, and beside it not above its border. Only what lies over the square is met.
    sheet: the border is one of the surface, which bounds nothing."""

    def __init__(self, columns, rows, heights, sheet):
        self.nx, self.nz = columns - 1, rows - 1
        self.h = [[O.Q(heights[j * columns + i]) for i in range(columns)] for j in range(rows)]
        self.sheet = sheet
        self.size = max([1.0] + [abs(x) for x in heights])

    def corner(self, i, j):
        return [fmpq(i, self.nx), self.h[j][i], fmpq(j, self.nz)]

    def falling(self, i, j):
        """Whether the cell's diagonal runs from its corner of least x and z."""
        h = self.h
        return abs(h[j][i] - h[j + 1][i + 1]) <= abs(h[j][i + 1] - h[j + 1][i])

    def facets(self, i, j):
        """(three corners, >= 0 on their side of the diagonal) in the cell's coordinates a, b"""
        c = [self.corner(i, j), self.corner(i + 1, j), self.corner(i + 1, j + 1), self.corner(i, j + 1)]
        if self.falling(i, j):         # a >= b, a <= b
            return [((c[0], c[1], c[2]), lambda a, b: a - b), ((c[0], c[2], c[3]), lambda a, b: b - a)]
        return [((c[0], c[1], c[3]), lambda a, b: 1 - a - b), ((c[1], c[2], c[3]), lambda a, b: a + b - 1)]

    def plane(self, corners):
        """y = u + v x + w z through three corners -> (u, v, w)"""
        n = O.cross(O.vsub(corners[1], corners[0]), O.vsub(corners[2], corners[0]))
        return O.vdot(n, corners[0]) / n[1], -n[0] / n[1], -n[2] / n[1]

    def height(self, x, z):
        i = min(int((x * self.nx).floor()), self.nx - 1)
        j = min(int((z * self.nz).floor()), self.nz - 1)
        a, b = x * self.nx - i, z * self.nz - j
        for corners, side in self.facets(i, j):
            if side(a, b) >= 0:
                u, v, w = self.plane(corners)
                return u + v * x + w * z

    def cell_cuts(self, line, i, j, S, found):
        """False where the line lies in a facet's plane."""
        o, d = line.o, line.d
        for corners, side in self.facets(i, j):
            u, v, w = self.plane(corners)
            rate = d[1] - v * d[0] - w * d[2]
            value = o[1] - u - v * o[0] - w * o[2]
            if rate == 0:
                if value == 0:
                    return False
                continue
            t = -value / rate
            x, z = o[0] + t * d[0], o[2] + t * d[2]
            a, b = x * self.nx - i, z * self.nz - j
            within = min(a, 1 - a, b, 1 - b, side(a, b))
            if within < 0 or t in found:
                continue
            n = [-O.A(v), arb(1), -O.A(w)]
            nm = O.rnd(within) / (2 * max(self.nx, self.nz))
            found[t] = cut_at(line, self, O.Root(O.A(t), t), n, S, altitude(corners), nm=nm)
        return True

    def meet(self, line):
        S = max(line.S, self.size)
        found = {}
        for j in range(self.nz):
            for i in range(self.nx):
                if not self.cell_cuts(line, i, j, S, found):
                    return None

        def inside(t):
            x, y, z = [line.o[i] + t * line.d[i] for i in range(3)]
            return y <= self.height(*(max(fmpq(0), min(fmpq(1), v)) for v in (x, z)))
        return list(found.values()), self.margin(line) / S, inside

    def margin(self, line):
        """Distance of the line to the nearest edge at which the surface turns from it or ends."""
        faces = {}
        for j in range(self.nz):
            for i in range(self.nx):
                for corners, _ in self.facets(i, j):
                    u, v, w = self.plane(corners)
                    rate = line.d[1] - v * line.d[0] - w * line.d[2]
                    for k in range(3):
                        a, b = corners[k], corners[(k + 1) % 3]
                        key = tuple(sorted((tuple(map(str, a)), tuple(map(str, b)))))
                        faces.setdefault(key, (a, b, []))[2].append(rate)
        least = math.inf
        for a, b, rates in faces.values():
            turns = self.sheet if len(rates) == 1 else rates[0] * rates[1] <= 0
            if turns:
                least = min(least, segment_distance(line, a, b))
        return least


def segment_distance(line, a, b):
    e, w, d = O.vsub(b, a), O.vsub(a, line.o), line.d
    dd, de, ee = O.vdot(d, d), O.vdot(d, e), O.vdot(e, e)
    det = dd * ee - de * de
    s = fmpq(0) if det == 0 else (O.vdot(d, w) * de - O.vdot(e, w) * dd) / det
    s = max(fmpq(0), min(fmpq(1), s))
    p = [w[i] + s * e[i] for i in range(3)]
    c = O.cross(p, d)
    return number((O.A(O.vdot(c, c)) / O.A(dd)).sqrt())


def altitude(corners):
    """The least of a triangle's."""
    p = [[O.rnd(x) for x in c] for c in corners]
    sides = [math.dist(p[i], p[(i + 1) % 3]) for i in range(3)]
    n = O.cross(O.vsub(p[1], p[0]), O.vsub(p[2], p[0]))
    return root_sum(n) / max(sides)


# --- leaves: parameters as the program takes them -> expression

ZERO = [[fmpq(0)] * 3 for _ in range(3)]


def half_space(n, k, size):
    """n.p <= k"""
    return Quad(ZERO, [O.Q(x) for x in n], -O.Q(k), size)


def about(c, weights, constant, size, rad):
    """sum of weights (p - c)^2 + constant <= 0"""
    M = [[weights[i] if i == j else fmpq(0) for j in range(3)] for i in range(3)]
    l = [-2 * weights[i] * c[i] for i in range(3)]
    return Quad(M, l, sum((weights[i] * c[i] * c[i] for i in range(3)), constant), size, rad)


def size_of(anchor, *lengths):
    return max(abs(float(x)) for x in anchor) + sum(abs(float(x)) for x in lengths)


def axis_plane(axis, sign, at, size):
    n = [0, 0, 0]
    n[axis] = sign
    return half_space(n, at * sign, size)


def slabs(lo, hi, size):
    return [axis_plane(i, sign, at, size) for i in range(3) for sign, at in ((-1, lo[i]), (1, hi[i]))]


def sphere(P):
    c, r = [O.Q(x) for x in P[:3]], O.Q(P[3])
    return about(c, [fmpq(1)] * 3, -r * r, size_of(P[:3], P[3]), P[3])


def box(P):
    lo = [O.Q(x) for x in P[:3]]
    return ("and", slabs(lo, [lo[i] + O.Q(P[3 + i]) for i in range(3)], max(abs(x) for x in P[:3]) + max(P[3:])))


def cylinder(P):
    c, h, r = [O.Q(x) for x in P[:3]], O.Q(P[3]), O.Q(P[4])
    size = size_of(P[:3], P[3], P[4])
    return ("and", [about(c, [fmpq(1), fmpq(0), fmpq(1)], -r * r, size, P[4]),
                    axis_plane(1, -1, c[1], size), axis_plane(1, 1, c[1] + h, size)])


def frustum_side(c, r0, k, size):
    """(x-cx)^2 + (z-cz)^2 <= (r0 + k (y-cy))^2"""
    M = [[fmpq(1), fmpq(0), fmpq(0)], [fmpq(0), -k * k, fmpq(0)], [fmpq(0), fmpq(0), fmpq(1)]]
    at0 = r0 - k * c[1]
    l = [-2 * c[0], -2 * k * at0, -2 * c[2]]
    return Quad(M, l, c[0] * c[0] + c[2] * c[2] - at0 * at0, size,
                lambda p: math.hypot(O.fl(p[0] - O.A(c[0])), O.fl(p[2] - O.A(c[2]))))


def cone(P):
    c, h, r = [O.Q(x) for x in P[:3]], O.Q(P[3]), O.Q(P[4])
    size = size_of(P[:3], P[3], P[4])
    return ("and", [frustum_side(c, fmpq(0), r / h, size),
                    axis_plane(1, -1, c[1], size), axis_plane(1, 1, c[1] + h, size)])


def frustum(P):
    c, h, r0, r1 = [O.Q(x) for x in P[:3]], O.Q(P[3]), O.Q(P[4]), O.Q(P[5])
    size = size_of(P[:3], *P[3:])
    return ("and", [frustum_side(c, r0, (r1 - r0) / h, size),
                    axis_plane(1, -1, c[1], size), axis_plane(1, 1, c[1] + h, size)])


def hemisphere(P):
    return ("and", [sphere(P), axis_plane(1, -1, O.Q(P[1]), size_of(P[:3], P[3]))])


def torus(P):
    return Torus(P)


def quadric(P):
    xx, yy, zz, xy, yz, zx, x, y, z, c = [O.Q(v) for v in P[:10]]
    lo, hi = [O.Q(v) for v in P[10:13]], [O.Q(v) for v in P[13:16]]
    size = max(abs(v) for v in P[10:])
    extent = max(P[13 + i] - P[10 + i] for i in range(3))
    q = Quad([[xx, xy / 2, zx / 2], [xy / 2, yy, yz / 2], [zx / 2, yz / 2, zz]], [x, y, z], c, size, given=True)

    def bend(p):
        return min(extent, root_sum([O.fl(v) for v in q.slope(p)]) / q.bend) if q.bend else extent
    q.rad = bend
    return ("and", [q] + slabs(lo, hi, size))


def height_field(columns, rows, heights, base):
    """base: None for a sheet"""
    top = Heights(columns, rows, heights, base is None)
    if base is None:
        return top
    size = max(top.size, abs(base))
    return ("and", [top, axis_plane(1, -1, O.Q(base), size)]
            + [axis_plane(i, s, fmpq(s > 0), size) for i in (0, 2) for s in (-1, 1)])


def convex_mesh(corners, faces):
    """Faces anticlockwise from outside, of a convex solid."""
    size = max(abs(x) for c in corners for x in c)
    planes = []
    for face in faces:
        a, b, c = [[O.Q(x) for x in corners[k]] for k in face]
        n = O.cross(O.vsub(b, a), O.vsub(c, a))
        planes.append(Quad(ZERO, n, -O.vdot(n, a), size, altitude((a, b, c))))
    return ("and", planes)


def placed(expression, place):
    """Each atom with the map of its leaf."""
    if isinstance(expression, tuple):
        return (expression[0], [placed(e, place) for e in expression[1]])
    return ("at", [expression], place)


# --- tracing

def value(expression, states):
    if isinstance(expression, tuple):
        word = expression[0]
        if word == "and":
            return all(value(e, states) for e in expression[1])
        if word == "or":
            return any(value(e, states) for e in expression[1])
        if word == "not":
            return not value(expression[1][0], states)
        return states[id(expression[1][0])]
    return states[id(expression)]


def atoms(expression, place=None):
    if not isinstance(expression, tuple):
        yield expression, place
        return
    for e in expression[1]:
        yield from atoms(e, expression[2] if expression[0] == "at" else place)


class Result:
    __slots__ = ("hits", "margin", "S", "deg", "inside")


def between(a, b):
    """A rational, and a short one where doubles tell a and b apart."""
    fa, fb = O.to_fraction(a.t.b), O.to_fraction(b.t.b)
    middle = (fa + fb) / 2
    short = O.Q(O.rnd(middle))
    return short if fa < short < fb else middle


def grouped(cuts):
    """Cuts by equal t; None where it is not decided whether they are equal."""
    groups = []
    for cut in sorted(cuts, key=lambda c: O.to_fraction(c.t.b)):
        last = groups[-1][-1] if groups else None
        if last is not None and last.t.b.overlaps(cut.t.b):
            if last.t.q is None or cut.t.q is None:
                return None
            if last.t.q == cut.t.q:
                groups[-1].append(cut)
                continue
        groups.append([cut])
    return groups


def parallel(a, b):
    return all(x.contains(0) for x in O.cross(a.n, b.n))


def gap_of(a, b):
    return abs(O.fl(b.t.b - a.t.b))


def shift_to_meet(a, b, length):
    """Of the line, until the surfaces of two cuts are met at once, to first order."""
    return gap_of(a, b) * length / (1 / max(a.cos, 1e-300) + 1 / max(b.cos, 1e-300))


def trace(expression, o, d, combined=False, extra_S=0.0):
    """combined: surfaces that are closer than SAME make the margin 0."""
    o, d = [O.Q(x) for x in o], [O.Q(x) for x in d]
    result = Result()
    result.hits, result.margin, result.S, result.deg = [], math.inf, extra_S, False
    cuts, ask, lines = [], {}, {}
    for atom, place in atoms(expression):
        key = None if place is None else tuple(place)
        if key not in lines:
            lines[key] = Line(place, o, d, extra_S)
        met = atom.meet(lines[key])
        if met is None:
            result.deg = True
            return result
        cuts += met[0]
        result.margin = min(result.margin, met[1])
        result.S = max(result.S, lines[key].scale * lines[key].S)
        ask[id(atom)] = met[2]
    for cut in cuts:
        result.S = max(result.S, cut.noise)
    groups = grouped(cuts)
    if groups is None:
        result.deg = True
        return result
    walk(expression, groups, ask, Line(None, o, d, 0.0), combined, result)
    return result


def walk(expression, groups, ask, line, combined, result):
    length = line.speed()
    states, values = [], []
    heights = [id(a) for a, _ in atoms(expression) if isinstance(a, Heights)]
    for k in range(len(groups) + 1):
        if not groups:
            t = fmpq(0)
        elif k == 0:
            t = O.to_fraction(groups[0][0].t.b) - 1
        elif k == len(groups):
            t = O.to_fraction(groups[-1][0].t.b) + 1
        else:
            t = between(groups[k - 1][0], groups[k][0])
        changed = ask if k == 0 else [id(c.atom) for c in groups[k - 1]] + heights
        now = {**(states[-1] if k else {}), **{a: ask[a](t) for a in changed}}
        states.append(now)
        values.append(value(expression, now))
    result.inside = values
    near = [math.inf] * len(groups)
    for i in range(len(groups)):
        for j in range(i + 1, len(groups)):
            # Surfaces that are clearly apart need no closer look.
            if nearness(groups[i], groups[j], length) > FAR:
                continue
            if j > i + 1 or len(set(values[i:j + 2])) > 1 or flips(expression, states[i], groups[i:j + 1], values[i]):
                weigh(groups[i], groups[j], length, line, combined, result)
                shift = min(shift_to_meet(a, b, length) for a in groups[i] for b in groups[j])
                near[i], near[j] = min(near[i], shift), min(near[j], shift)
    for i, group in enumerate(groups):
        alike = all(parallel(group[0], c) for c in group[1:])
        matters = values[i] != values[i + 1] or flips(expression, states[i], [group], values[i])
        if len(group) > 1 and not alike and matters:
            result.margin = near[i] = 0.0
        if values[i] == values[i + 1]:
            continue
        cut = next((c for c in group if toggled(expression, states[i], states[i + 1], c) != values[i]), group[0])
        out = 1 if O.fl(O.vdot(cut.n, [O.A(x) for x in line.d])) > 0 else -1
        if out == (1 if values[i + 1] else -1):
            cut.n = [-x for x in cut.n]
        cut.nm = min(cut.nm, near[i])
        result.hits.append(cut)


def toggled(expression, before, after, cut):
    return value(expression, {**before, id(cut.atom): after[id(cut.atom)]})


def flips(expression, state, groups, plain):
    """Whether some one of the groups' atoms, changed by itself, would change the value."""
    return any(value(expression, {**state, id(c.atom): not state[id(c.atom)]}) != plain for g in groups for c in g)


def nearness(first, second, length):
    """In units of the noise scale."""
    return min(shift_to_meet(a, b, length) / max(a.noise, b.noise) for a in first for b in second)


def weigh(first, second, length, line, combined, result):
    for a in first:
        for b in second:
            if combined:
                t = O.fl(b.t.b)
                speed = max(abs(O.rnd(x)) for x in line.d)
                reach = max(abs(O.rnd(x)) for x in line.o) / speed + abs(t)
                if gap_of(a, b) < SAME * reach:
                    result.margin = 0.0
            if a.atom is not b.atom:
                result.margin = min(result.margin, shift_to_meet(a, b, length) / max(a.noise, b.noise))


# --- sheets that lie in y = 0

def flat(o, d, extra_S, sides):
    """sides(x, z) -> how far within the sheet the point is (< 0: outside), and its size"""
    o, d = [O.Q(x) for x in o], [O.Q(x) for x in d]
    line = Line(None, o, d, extra_S)
    result = Result()
    result.hits, result.margin, result.deg = [], math.inf, False
    result.S, result.inside = line.S, []
    if d[1] == 0:
        result.deg = o[1] == 0
        if not result.deg:
            result.margin = abs(O.rnd(o[1])) / line.S
        return result
    t = -o[1] / d[1]
    within, size = sides(o[0] + t * d[0], o[2] + t * d[2])
    result.S = max(line.S, size)
    cut = cut_at(line, None, O.Root(O.A(t), t), [arb(0), arb(1), arb(0)], result.S, size, nm=math.inf)
    result.margin = abs(within) * cut.cos / result.S
    result.deg = within == 0
    if within >= 0:
        result.hits.append(cut)
    return result


def disc(P):
    def sides(x, z):
        return P[0] - number(O.A(x * x + z * z).sqrt()) if x or z else P[0], P[0]
    return sides


def rectangle(P):
    def sides(x, z):
        return O.rnd(min(x, O.Q(P[0]) - x, z, O.Q(P[1]) - z)), max(P)
    return sides


def plane(P):
    return lambda x, z: (math.inf, 1.0)


def sheet_trace(heights, o, d, extra_S=0.0):
    """An open height field: every crossing is a hit."""
    line = Line(None, [O.Q(x) for x in o], [O.Q(x) for x in d], extra_S)
    result = Result()
    met = heights.meet(line)
    result.deg = met is None
    result.inside = []
    if met is not None:
        result.hits, result.margin = sorted(met[0], key=lambda c: O.to_fraction(c.t.b)), met[1]
        result.S = max(line.S, heights.size)
    return result
