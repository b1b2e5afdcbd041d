"""Certified rays against quadrics, combined solids, height fields, and the other solids that oracle.py has not.

run(kind, seed, n, folder) writes KIND.txt, n cases a class. Format: README.md. gen.py calls it.
"""
import math, os, random
import oracle as O
import solids_oracle as S
from gen_tools import crossf, dotf, dy, g6, hexf, inball, lu, mad, norm, perp, unit

OPERATIONS = ("union", "intersection", "difference")


class Solid:
    """words: as the program reads it. trace(o, d, extra_S) -> S.Result. c, B, s: a ball around it, and its feature."""

    def __init__(self, words, trace, c, B, s, extra=None):
        self.words, self.trace, self.c, self.B, self.s, self.extra = words, trace, c, B, s, extra


def plain(words, expression, c, B, s, combined=False, extra=None):
    return Solid(words, lambda o, d, extra_S=0.0: S.trace(expression, o, d, combined, extra_S), c, B, s, extra)


def rotation(r):
    a = unit(r)
    b = perp(r, a)
    return [a, b, crossf(a, b)]


# --- quadrics

def form(r, name):
    """Weights of x^2, y^2, z^2, of y, and the constant, on a solid of size 1."""
    w = lambda: 1 / r.uniform(0.4, 1) ** 2
    return {"ellipsoid": ([w(), w(), w()], 0, -1), "one_sheet": ([w(), -w(), w()], 0, -r.uniform(0.02, 0.3)),
            "two_sheets": ([w(), -w(), w()], 0, r.uniform(0.02, 0.3)), "cone": ([w(), -w(), w()], 0, 0),
            "paraboloid": ([w(), 0, w()], -1, -0.5), "saddle": ([w(), 0, -w()], -1, r.uniform(-.2, .2)),
            "tube": ([w(), 0, w()], 0, -0.5), "gutter": ([w(), 0, 0], -1, -0.3),
            "hyperbolic_tube": ([w(), 0, -w()], 0, r.uniform(-.3, .3)), "crossed_planes": ([w(), 0, -w()], 0, 0),
            "slab": ([w(), 0, 0], 0, -0.2), "half_space": ([0, 0, 0], 1, r.uniform(-.5, .5))}[name]


FORMS = ("ellipsoid", "one_sheet", "two_sheets", "cone", "paraboloid", "saddle", "tube", "gutter", "hyperbolic_tube",
         "crossed_planes", "slab", "half_space")
CURVED = ("one_sheet", "two_sheets", "cone", "saddle", "hyperbolic_tube", "paraboloid", "gutter")


def quadric(r, size, c, name=None, turned=None, bits=None):
    name = name or r.choice(FORMS)
    w, slope, k = form(r, name)
    if bits is not None:
        w, k = [dy(x, bits) for x in w], dy(k, bits)
    A = rotation(r) if (r.random() < 0.6 if turned is None else turned) else [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]
    sign = 1 if r.random() < 0.8 else -1
    g = sign * lu(r, -2, 2) if bits is None else sign
    M = [[g * sum(w[k] * A[k][i] * A[k][j] for k in range(3)) / size ** 2 for j in range(3)] for i in range(3)]
    l = [g * slope * A[1][i] / size for i in range(3)]
    Mc = [dotf(row, c) for row in M]
    k = g * k + dotf(Mc, c) - dotf(l, c)
    l = [l[i] - 2 * Mc[i] for i in range(3)]
    cut = lambda: size * r.uniform(0.5, 1.4) if bits is None else size * dy(r.uniform(0.5, 1.4), 3)
    lo, hi = [c[i] - cut() for i in range(3)], [c[i] + cut() for i in range(3)]
    P = [M[0][0], M[1][1], M[2][2], 2 * M[0][1], 2 * M[1][2], 2 * M[2][0]] + l + [k] + lo + hi
    B = math.dist(lo, hi) / 2
    return plain([hexf(x) for x in P], S.quadric(P), [(lo[i] + hi[i]) / 2 for i in range(3)], B, size, extra=(M, name))


# --- the solids by anchor and lengths

def frustum(r, size, c, bits=None):
    short = (lambda x: x) if bits is None else (lambda x: dy(x, bits))
    h = short(size * r.uniform(0.4, 2))
    r0 = short(size * r.uniform(0.3, 1))
    r1 = r0 * (1 + r.choice((-1, 1)) * lu(r, -9, -1)) if bits is None and r.random() < .3 else short(size * r.uniform(0.05, 1.2))
    if r0 == r1:
        r1 = 2 * r0
    P = [c[0], c[1] - h / 2, c[2], h, r0, r1]
    return plain([hexf(x) for x in P], S.frustum(P), c, math.hypot(h / 2, max(r0, r1)), min(h, r0, r1))


def hemisphere(r, size, c, bits=None):
    return plain([hexf(x) for x in c + [size]], S.hemisphere(c + [size]), c, size, size)


def sheet(words, sides, c, B):
    return Solid([hexf(x) for x in words], lambda o, d, extra_S=0.0: S.flat(o, d, extra_S, sides), c, B, B)


def disc(r, size, c, bits=None):
    return sheet([size], S.disc([size]), [0.0] * 3, size)


def rectangle(r, size, c, bits=None):
    P = [size, size * (r.uniform(.3, 3) if bits is None else r.choice((.5, 1.0, 2.0)))]
    return sheet(P, S.rectangle(P), [P[0] / 2, 0.0, P[1] / 2], math.hypot(*P) / 2)


def plane(r, size, c, bits=None):
    return sheet([], S.plane([]), [size * r.uniform(-1, 1), 0.0, size * r.uniform(-1, 1)], size)


# --- height fields

def heights(r, kind=None):
    nx, nz = r.randrange(2, 6), r.randrange(2, 6)
    if kind == "grid":
        nx, nz = r.choice((2, 3, 5)), r.choice((2, 3, 5))
    kind = r.choice(("steep", "gentle", "flat")) if kind in (None, "grid") else kind
    amplitude = {"steep": lu(r, 0, 2), "gentle": lu(r, -4, 0), "flat": 0.25}[kind]
    h = [r.uniform(0, amplitude) for _ in range(nx * nz)]
    if kind == "flat":
        h = [r.choice((0.0, 0.0, 0.25)) for _ in h]
    return nx, nz, [dy(x, 24) for x in h]


def height_field(r, size=1.0, c=None, bits=None, kind=None, closed=None):
    nx, nz, h = heights(r, kind)
    base = None
    if r.random() < 0.6 if closed is None else closed:
        base = min(h) - dy(r.uniform(0.1, 1), 6)
    words = [str(nx), str(nz)] + [hexf(x) for x in h] + (["0"] if base is None else ["1", hexf(base)])
    low = min(h) if base is None else base
    centre = [0.5, (low + max(h)) / 2, 0.5]
    B = math.hypot(0.7072, (max(h) - low) / 2)
    solid = S.height_field(nx, nz, h, base)
    if base is not None:
        return plain(words, solid, centre, B, 0.1, extra=(nx, nz, h, base))
    return Solid(words, lambda o, d, extra_S=0.0: S.sheet_trace(solid, o, d, extra_S), centre, B, 0.1,
                 extra=(nx, nz, h, base))


# --- combined solids

def mesh_words(corners, faces):
    return (["mesh", str(len(corners)), str(len(faces))] + [hexf(x) for c in corners for x in c]
            + [str(k) for f in faces for k in f])


def tetrahedron(r, size, c):
    while True:
        p = [[dy(x, 20) if size > 1e-2 else x for x in inball(r, c, size)] for _ in range(4)]
        volume = dotf(crossf(mad(p[1], -1, p[0]), mad(p[2], -1, p[0])), mad(p[3], -1, p[0]))
        if abs(volume) > 0.1 * size ** 3:
            break
    if volume < 0:
        p[2], p[3] = p[3], p[2]
    return p, [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def octahedron(r, size, c):
    p = []
    for i in range(3):
        for sign in (-1, 1):
            q = list(c)
            q[i] += sign * size * r.choice((0.5, 0.75, 1.0))
            p.append(q)
    return p, [(x, 2 + y, 4 + z) if (x + y + z) % 2 else (x, 4 + z, 2 + y)
               for x in (0, 1) for y in (0, 1) for z in (0, 1)]


def leaf(r, size, c, kinds=None):
    """-> words, expression"""
    kind = r.choice(kinds or ("sphere", "box", "cylinder", "cone", "torus", "frustum", "hemisphere", "quadric", "mesh",
                              "height_field"))
    u = lambda a, b: dy(size * r.uniform(a, b), 12) if size > 1e-2 else size * r.uniform(a, b)
    if kind == "mesh":
        corners, faces = r.choice((tetrahedron, octahedron))(r, size, c)
        return mesh_words(corners, faces), S.convex_mesh(corners, faces)
    if kind == "quadric":
        q = quadric(r, size, c, bits=8)
        P = [float.fromhex(w) for w in q.words]
        return [kind] + q.words, S.quadric(P)
    if kind == "height_field":
        f = height_field(r, closed=True, kind=r.choice(("gentle", "flat")))
        nx, nz, h, base = f.extra
        z = 2.0 ** round(math.log2(1.5 * size))
        M = [z, 0.0, 0.0, c[0] - z / 2, 0.0, z, 0.0, c[1] - z * max(h) / 2, 0.0, 0.0, z, c[2] - z / 2]
        return ["at"] + [hexf(x) for x in M] + [kind] + f.words, S.placed(S.height_field(nx, nz, h, base), M)
    if kind == "box":
        w = [u(0.8, 1.6) for _ in range(3)]
        P = [c[i] - w[i] / 2 for i in range(3)] + w
    else:
        lengths = {"sphere": [u(0.5, 1)], "cylinder": [u(0.6, 1.6), u(0.4, 1)], "cone": [u(0.8, 2), u(0.4, 1)],
                   "torus": [u(0.6, 0.9), u(0.15, 0.45)], "hemisphere": [u(0.6, 1.1)],
                   "frustum": [u(0.6, 1.6), u(0.4, 0.7), u(0.71, 1)]}[kind]
        drop = lengths[0] / 2 if kind in ("cylinder", "cone", "frustum") else 0.0
        P = [c[0], c[1] - drop, c[2]] + lengths
    words, expression = [kind] + [hexf(x) for x in P], getattr(S, kind)(P)
    if r.random() < 0.3 and size > 1e-2:
        M = turned_about(r, c)
        return ["at"] + [hexf(x) for x in M] + words, S.placed(expression, M)
    return words, expression


def turned_about(r, c):
    A = rotation(r)
    M = []
    for i in range(3):
        M += A[i] + [c[i] - dotf(A[i], c)]
    return M


def combine(operation, parts):
    words = [operation, str(len(parts))] + [w for p in parts for w in p[0]]
    solids = [p[1] for p in parts]
    if operation == "union":
        return words, ("or", solids)
    if operation == "intersection":
        return words, ("and", solids)
    return words, ("and", [solids[0]] + [("not", [s]) for s in solids[1:]])


def tree(r, size, c, depth, kinds=None):
    if depth == 0:
        return leaf(r, size, [dy(x, 12) for x in inball(r, c, 0.4 * size)] if size > 1e-2
                    else inball(r, c, 0.4 * size), kinds)
    parts = [tree(r, size, c, r.choice((depth - 1, 0)) if i else depth - 1, kinds)
             for i in range(r.choice((2, 2, 3)))]
    return combine(r.choice(OPERATIONS), parts)


def whole(words, expression, c, size):
    return plain(words, expression, c, 1.6 * size, size, combined=True)


def csg(r, size, c, depth=None, kinds=None):
    """One of which something is left, at no unlikely place."""
    while True:
        words, expression = tree(r, size, c, depth or r.choice((1, 1, 2)), kinds)
        s = whole(words, expression, c, size)
        if point_on(r, s)[0]:
            return s


def shell(r):
    """A solid without one that is hardly smaller: a wall of 1e-2 to 1e-7 of its size."""
    c, e = [dy(r.uniform(-2, 2), 8) for _ in range(3)], lu(r, -7, -2)
    outer = dy(r.uniform(0.5, 1.5), 10)
    if r.random() < 0.5:
        parts = [["sphere"] + [hexf(x) for x in c + [q]] for q in (outer, outer * (1 - e))]
        solids = [S.sphere(c + [q]) for q in (outer, outer * (1 - e))]
    else:
        boxes = []
        for q in (outer, outer * (1 - e)):
            boxes.append([x - q for x in c] + [2 * q] * 3)
        parts, solids = [["box"] + [hexf(x) for x in P] for P in boxes], [S.box(P) for P in boxes]
    return whole(*combine("difference", list(zip(parts, solids))), c, outer * 1.2)


def neighbours(r, gap):
    """Two boxes side by side, `gap` apart (< 0: overlapping), and what is made of them."""
    c = [dy(r.uniform(-2, 2), 6) for _ in range(3)]
    w = [dy(r.uniform(0.5, 1.5), 6) for _ in range(3)]
    i = r.randrange(3)
    first, second = [c[k] - w[k] for k in range(3)] + w, list(c) + list(w)
    for k in range(3):
        if k != i:
            second[k] = first[k] + r.choice((0.0, dy(r.uniform(-.2, .2), 6)))
    second[i] = c[i] + gap
    inner = r.random() < 0.5            # the second within the first, and its face on the first's
    if inner:
        second[i] = first[i] + w[i] / 2 + gap
        second[3 + i] = w[i] / 2
    operation = ("difference" if inner else "union") if r.random() < 0.8 else r.choice(OPERATIONS[::2])
    parts = [(["box"] + [hexf(x) for x in P], S.box(P)) for P in (first, second)]
    if r.random() < 0.3:
        ball = [c[k] - w[k] / 2 for k in range(3)] + [dy(0.4, 6)]
        parts.append((["sphere"] + [hexf(x) for x in ball], S.sphere(ball)))
    s = whole(*combine(operation, parts), c, max(w))
    s.extra = first, i, inner
    return s


def across(r, s):
    """Through the face between: from within the first of two side by side, from beyond where one is in the other."""
    first, i, inner = s.extra
    p = [first[k] + first[3 + k] * r.uniform(0.05, 0.95) for k in range(3)]
    d = [r.uniform(-.4, .4) for _ in range(3)]
    d[i] = r.choice((-1.0, 1.0, 1.0, 1.0)) * (-1 if inner else 1)
    return s, mad(p, -3 * s.B if inner else 0, d), norm(d)


# --- rays

class Writer:
    def __init__(self, kind, seed, n, folder):
        self.kind, self.seed, self.n = kind, seed, n
        self.file = open(os.path.join(folder, kind + ".txt"), "w")
        self.file.write("# %s, seed %d; format: README.md\n" % (kind, seed))
        self.stat = {}

    def emit(self, cls, solid, o, d, M=None, on_surface=False):
        o, d = [float(x) for x in o], [float(x) for x in d]
        if not any(d):
            return False
        oo, dd, extra_S, inv = o, d, 0.0, None
        if M is not None:
            oo, dd, extra_S, inv = O.ray_to_object(M, o, d)
        found = solid.trace(oo, dd, extra_S)
        if found.deg:
            return False
        length = O.fl(O.A(O.vdot([O.Q(x) for x in dd], [O.Q(x) for x in dd])).sqrt())
        tmin = 0.0
        if on_surface:
            ghost = min(found.hits, key=lambda h: abs(O.fl(h.t.b)), default=None)
            tmin = 2.0 ** -40 * found.S / (max(ghost.cos if ghost else 0.0, 1e-9) * length)
        margin, answers = found.margin, []
        for i, h in enumerate(found.hits):
            hi, lo = O.rnd2(h.t.b)
            margin = min(margin, abs(hi - tmin) * length * h.cos / found.S)
            n = h.n
            if inv is not None:
                n = [sum((O.A(inv[k][i]) * n[k] for k in range(3)), O.arb(0)) for i in range(3)]
                s = O.vdot(n, n)
                n = n if s.contains(0) else [x / s.sqrt() for x in n]
            answers += [hexf(hi), g6(lo), g6(h.cos), g6(h.nm), g6(h.noise), g6(h.rad)]
            answers += [hexf(O.rnd(x)) for x in n]
        words = [cls] + solid.words + ([hexf(x) for x in M] if M is not None else [])
        words += [hexf(x) for x in o + d] + [hexf(tmin), "|", g6(found.S), g6(margin * found.S), str(len(found.hits))]
        self.file.write(" ".join(words + answers) + "\n")
        stat = self.stat.setdefault(cls, [0, 0, 0])
        stat[0] += 1
        stat[1] += any(O.fl(h.t.b) > tmin for h in found.hits)
        stat[2] += margin >= 64 * O.EPS
        return True

    def cls(self, name, make, times=1):
        r = random.Random("%d/%s/%s" % (self.seed, self.kind, name))
        count = 0
        while count < times * self.n:
            case = make(r)
            if case is None:
                continue
            more = case[3] if len(case) > 3 else {}
            count += self.emit(name, case[0], case[1], case[2], **more)


def aimed(r, s, dist, reach=1.0, tries=3):
    """A ray from so many radii away; one that hits, if there is one among so many."""
    for _ in range(tries):
        o = mad(s.c, dist * s.B, unit(r))
        d = [x - y for x, y in zip(inball(r, s.c, reach * s.B), o)]
        if tries == 1 or hits_of(s, o, d):
            break
    return o, norm(d) if r.random() < 0.7 else d


def hits_of(s, o, d):
    found = s.trace(o, d)
    return [] if found.deg else found.hits


def point_on(r, s):
    """A surface point, rounded, and its outward normal"""
    for _ in range(30):
        o, d = aimed(r, s, r.uniform(1.5, 4), tries=1)
        hits = hits_of(s, o, d)
        if hits:
            h = r.choice(hits)
            t = O.fl(h.t.b)
            return mad(o, t, d), [O.fl(x) for x in h.n]
    return None, None


def graze(r, s):
    p, n = point_on(r, s)
    if p is None:
        return None
    tau = perp(r, n)
    if r.random() < 0.3:
        tau = norm(mad(tau, r.choice((-1, 1)) * lu(r, -9, -1), n))
    o = mad(mad(p, lu(r, -14, -2) * r.choice((-1, 1)) * s.s, n), -s.B * r.uniform(1.5, 8), tau)
    return s, o, tau


def secondary(r, s, sign):
    p, n = point_on(r, s)
    if p is None:
        return None
    cos = lu(r, -4, -1) if r.random() < 0.2 else r.uniform(0.05, 1)
    d = mad([sign * cos * x for x in n], math.sqrt(1 - cos * cos), perp(r, n))
    return s, p, d, {"on_surface": True}


def inside(r, s):
    o, d = aimed(r, s, r.uniform(1.5, 4))
    hits = hits_of(s, o, d)
    if len(hits) < 2:
        return None
    i = r.randrange(len(hits) - 1)
    a, b = O.fl(hits[i].t.b), O.fl(hits[i + 1].t.b)
    return s, mad(o, a + (b - a) * r.uniform(0.01, 0.99), d), unit(r)


def rim(r, s):
    """Between two points of the same view that show different faces, or one of which shows none."""
    o = mad(s.c, r.uniform(1.5, 6) * s.B, unit(r))
    p, q = inball(r, s.c, s.B), inball(r, s.c, s.B)

    def seen(x):
        hits = [h for h in hits_of(s, o, mad(x, -1, o)) if O.fl(h.t.b) > 0]
        return id(hits[0].atom) if hits else 0
    at_p = seen(p)
    if at_p == seen(q):
        return None
    least = 0.3 * 10 ** r.uniform(-13, -2)
    while math.dist(p, q) > least * s.B:
        m = [(p[i] + q[i]) / 2 for i in range(3)]
        if seen(m) == at_p:
            p = m
        else:
            q = m
    return s, o, norm(mad(r.choice((p, q)), -1, o))


def axis_direction(r):
    d = [0.0, 0.0, 0.0]
    if r.random() < 0.6:
        d[r.randrange(3)] = r.choice((-1.0, 1.0))
    else:
        i = r.randrange(3)
        d = [0.0 if k == i else r.choice((-1.0, -0.5, 0.5, 1.0)) for k in range(3)]
    return [r.choice((0.0, -0.0)) if x == 0 else x for x in d]


def axis(r, s):
    d = axis_direction(r)
    target = [dy(x, 4) for x in (s.c if r.random() < 0.4 else inball(r, s.c, s.B))]
    m = 2.0 ** r.randrange(2, 5)
    B = 2.0 ** round(math.log2(s.B))
    return s, [target[i] - m * B * d[i] for i in range(3)], d


def under_a_map(r, s):
    A1, A2 = rotation(r), rotation(r)
    stretch = [lu(r, -1, 1) for _ in range(3)]
    L = [[sum(A1[k][i] * stretch[k] * A2[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    T = [r.uniform(-10, 10) for _ in range(3)]
    o, d = aimed(r, s, r.uniform(1.2, 20))
    M = [x for i in range(3) for x in L[i] + [T[i]]]
    return s, [dotf(L[i], o) + T[i] for i in range(3)], norm([dotf(L[i], d) for i in range(3)]), {"M": M}


def common_classes(w, make, short, scales=True, sheets=False):
    """make(r): of any place and size. short(r): of few bits, for exact special positions."""
    w.cls("typical", lambda r: (lambda s: (s, *aimed(r, s, r.uniform(1.2, 20))))(make(r)))
    for k in (3, 6):
        w.cls("far1e%d" % k, lambda r, k=k: (lambda s: (s, *aimed(r, s, 10.0 ** k * r.uniform(.5, 2))))(make(r)))
    w.cls("graze", lambda r: graze(r, make(r)))
    w.cls("axis", lambda r: axis(r, short(r)))
    w.cls("special", lambda r: special(r, short(r)))
    w.cls("leave", lambda r: secondary(r, make(r), 1))
    w.cls("enter", lambda r: secondary(r, make(r), -1))
    w.cls("affine", lambda r: under_a_map(r, make(r)))
    if not sheets:
        w.cls("inside", lambda r: inside(r, make(r)))
        w.cls("rim", lambda r: rim(r, make(r)))


def special(r, s):
    """Origin and direction of very few bits."""
    o = [dy(s.c[i], 3) + 2.0 ** round(math.log2(s.B)) * r.choice((-2, -1, -.5, -.25, 0, 0, .25, .5, 1, 2)) for i in range(3)]
    if r.random() < 0.5:
        return s, o, [2.0 * (dy(s.c[i], 3) - o[i]) for i in range(3)]
    return s, o, [r.choice((0.0, -0.0, 1.0, -1.0, 0.5, -0.25, 2.0)) for _ in range(3)]


def anywhere(r):
    return r.uniform(0.3, 3), [r.uniform(-5, 5) for _ in range(3)]


def somewhere_short(r):
    return dy(r.uniform(0.5, 3), 4), [dy(r.uniform(-5, 5), 3) for _ in range(3)] if r.random() < .5 else [0.0] * 3


def scaled(w, make):
    def scale0(r):
        s = make(r, lu(r, -6, 6), [0.0] * 3)
        return (s, *aimed(r, s, r.uniform(1.2, 20)))
    w.cls("scale0", scale0)

    def scaleoff(r):
        z = lu(r, -6, 6)
        s = make(r, z, [1e4 * z * x for x in unit(r)])
        return (s, *aimed(r, s, r.uniform(1.2, 20)))
    w.cls("scaleoff", scaleoff)


def near_asymptote(r, s, off):
    """A direction in which the quadric's leading coefficient all but vanishes; None where it has none"""
    M = s.extra[0]
    q2 = lambda d: sum(M[i][j] * d[i] * d[j] for i in range(3) for j in range(3))
    if s.extra[1] in ("paraboloid", "gutter"):
        return norm(mad(null_direction(M), off, unit(r)))
    a, b = unit(r), unit(r)
    if q2(a) * q2(b) >= 0:
        return None
    for _ in range(60):
        m = norm([a[i] + b[i] for i in range(3)])
        if q2(m) * q2(a) > 0:
            a = m
        else:
            b = m
    return norm(mad(a, off, unit(r)))


def asymptote(r):
    s = quadric(r, *anywhere(r), name=r.choice(CURVED))
    d = near_asymptote(r, s, lu(r, -16, -3))
    return d and (s, mad(inball(r, s.c, s.B), -s.B * r.uniform(0.5, 8), d), d)


def null_direction(M):
    rows = [crossf(M[i], M[j]) for i, j in ((0, 1), (1, 2), (2, 0))]
    best = max(rows, key=lambda v: dotf(v, v))
    if dotf(best, best) > 1e-20 * max(dotf(m, m) for m in M) ** 2:
        return norm(best)
    row = max(M, key=lambda v: dotf(v, v))
    return norm(crossf(row, [1.0, 0.3, -0.7]))


def shallow(r):
    """Nearly along a quadric's surface, and close to it, all the way through the box."""
    name = r.choice(("one_sheet", "saddle", "hyperbolic_tube", "cone"))
    s = quadric(r, *anywhere(r), name=name)
    M = s.extra[0]
    p, n = point_on(r, s)
    if p is None:
        return None
    # In the tangent plane the form is indefinite on these: one of its two null directions.
    a = perp(r, n)
    b = crossf(n, a)
    q = lambda u, v: sum(M[i][j] * u[i] * v[j] for i in range(3) for j in range(3))
    aa, ab, bb = q(a, a), q(a, b), q(b, b)
    if ab * ab - aa * bb < 0 or aa == 0:
        return None
    k = (-ab + r.choice((-1, 1)) * math.sqrt(max(0.0, ab * ab - aa * bb))) / aa
    d = norm([k * a[i] + b[i] for i in range(3)])
    d = norm(mad(d, lu(r, -12, -2), unit(r)))
    return s, mad(mad(p, s.s * lu(r, -12, -2) * r.choice((-1, 1)), n), -s.B * r.uniform(1, 8), d), d


def apex(r):
    size, c = anywhere(r)
    s = quadric(r, size, c, name="cone")
    p = mad(c, size * lu(r, -10, -1), unit(r))
    return s, *(lambda o: (o, norm(mad(p, -1, o))))(mad(c, s.B * r.uniform(1.5, 10), unit(r)))


def close(r):
    """From near the surface, in a box about the origin: where noise is least, and a solver's own error shows."""
    size = r.uniform(0.5, 2)
    s = quadric(r, size, [size * x * r.choice((0, 0, 0.3, 1)) for x in unit(r)])
    p, n = point_on(r, s)
    if p is None:
        return None
    way = r.random()
    if way < 0.3:
        d = unit(r)
    elif way < 0.6:
        d = norm(mad(perp(r, n), lu(r, -8, -1), n))
    else:
        d = near_asymptote(r, s, lu(r, -16, -1))
    return d and (s, mad(p, -s.B * r.uniform(0.05, 1), d), d)


def crossed(r):
    """Nearly along one of two crossed planes, or along a cone, past where they meet."""
    size = r.uniform(0.5, 2)
    name = r.choice(("crossed_planes", "crossed_planes", "cone"))
    s = quadric(r, size, [0.0] * 3, name=name, turned=False)
    p = [0.0, size * r.uniform(-0.4, 0.4) if name == "crossed_planes" else 0.0, 0.0]
    d = near_asymptote(r, s, lu(r, -7, -2))
    return d and (s, mad(mad(p, size * lu(r, -7, -1), unit(r)), -s.B * r.uniform(0.05, 1), d), d)


def run_quadric(w):
    common_classes(w, lambda r: quadric(r, *anywhere(r)),
                   lambda r: quadric(r, *somewhere_short(r), turned=False, bits=6))
    scaled(w, quadric)
    w.cls("asymptote", asymptote)
    w.cls("shallow", shallow)
    w.cls("apex", apex)
    w.cls("close", close, 4)
    w.cls("crossed", crossed, 3)


def run_simple(make):
    def run(w):
        flat = make in (disc, rectangle, plane)
        common_classes(w, lambda r: make(r, *anywhere(r)), lambda r: make(r, *somewhere_short(r), bits=6), sheets=flat)
        scaled(w, make)
    return run


def run_heights(w):
    common_classes(w, height_field, lambda r: height_field(r, kind="grid"))

    def gridline(r):
        s = height_field(r, kind="grid")
        nx, nz, h, base = s.extra
        at = r.randrange(nx) / (nx - 1), r.randrange(nz) / (nz - 1)
        o, d = [at[0], dy(s.c[1] + 2 * s.B, 6), -1.0], [0.0, -dy(r.uniform(0.1, 2), 6), 1.0]
        if r.random() < 0.5:
            o, d = [-1.0, o[1], at[1]], [1.0, d[1], 0.0]
        return s, o, d
    w.cls("gridline", gridline)

    def vertical(r):
        s = height_field(r, kind=r.choice(("grid", None)))
        up = r.choice((-1.0, 1.0))
        p = [r.uniform(-.1, 1.1), r.uniform(-.1, 1.1)]
        if r.random() < 0.5:
            p = [dy(x, 3) for x in p]
        return s, [p[0], s.c[1] - up * 3 * s.B, p[1]], [0.0, up, 0.0]
    w.cls("vertical", vertical)

    def below(r):
        s = height_field(r)
        o = [r.uniform(-1, 2), s.c[1] - s.B * r.uniform(1.5, 5), r.uniform(-1, 2)]
        return s, o, norm(mad(inball(r, s.c, s.B), -1, o))
    w.cls("below", below)

    def sides(r):
        s = height_field(r, closed=True)
        nx, nz, h, base = s.extra
        y = base + (max(h) - base) * r.uniform(0, 1)
        out = [r.choice((-1, 2)), y, r.uniform(0, 1)]
        d = [0.5 - out[0], (max(h) - base) * r.uniform(-.3, .3), r.uniform(-.5, .5)]
        return (s, out, d) if r.random() < 0.5 else (s, out[::-1], d[::-1])
    w.cls("sides", sides)
    w.cls("steep", lambda r: (lambda s: (s, *aimed(r, s, r.uniform(1.2, 5), 0.7)))(height_field(r, kind="steep")))
    w.cls("flat", lambda r: (lambda s: (s, *aimed(r, s, r.uniform(1.2, 5), 0.7)))(height_field(r, kind="flat")))


def rings(r, size, c):
    """From between crossings of a line with four or more."""
    s = csg(r, size, c, depth=1, kinds=("torus", "torus", "quadric"))
    for _ in range(20):
        o, d = aimed(r, s, r.uniform(1.2, 6), 0.8, tries=1)
        hits = hits_of(s, o, d)
        if len(hits) >= 4:
            i = r.randrange(len(hits) - 1)
            a, b = O.fl(hits[i].t.b), O.fl(hits[i + 1].t.b)
            return s, mad(o, a + (b - a) * r.uniform(0.1, 0.9), d), d


def run_csg(w):
    where = lambda r: (dy(r.uniform(0.5, 2), 6), [dy(r.uniform(-4, 4), 6) for _ in range(3)])
    common_classes(w, lambda r: csg(r, *where(r)),
                   lambda r: csg(r, dy(r.uniform(.5, 2), 2), [dy(r.uniform(-4, 4), 1) for _ in range(3)]))

    def scale0(r):
        s = csg(r, lu(r, -6, 6), [0.0] * 3)
        return (s, *aimed(r, s, r.uniform(1.2, 20)))
    w.cls("scale0", scale0)

    def through(make):
        def case(r):
            s = make(r)
            return (s, *aimed(r, s, r.uniform(1.2, 6), 0.6))
        return case
    w.cls("depth3", through(lambda r: csg(r, *where(r), depth=3)))
    w.cls("meshes", through(lambda r: csg(r, *where(r), kinds=("mesh", "mesh", "height_field", "box"))))
    w.cls("shell", through(shell))
    w.cls("shared", lambda r: across(r, neighbours(r, 0.0)))
    w.cls("rings", lambda r: rings(r, *where(r)))
    w.cls("near", lambda r: across(r, neighbours(r, r.choice((-1, 1)) * lu(r, -10, -3))))


RUNS = {"quadric": run_quadric, "csg": run_csg, "height_field": run_heights, "frustum": run_simple(frustum),
        "hemisphere": run_simple(hemisphere), "disc": run_simple(disc), "rectangle": run_simple(rectangle),
        "plane": run_simple(plane)}


def run(kind, seed, n, folder):
    writer = Writer(kind, seed, n, folder)
    RUNS[kind](writer)
    writer.file.close()
    return writer.stat
