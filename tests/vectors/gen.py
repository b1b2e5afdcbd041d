#!/usr/bin/env python3
"""gen.py --seed 1 --n 2000 --out vec [--prim torus] : stress vectors, one text file per primitive.

Line = blank separated tokens, numbers are C hex floats (read with strtod), '#' lines are comments:
  class  params[np]  (class 'affine' only: M[12] row-major 3x4 object->world)  o[3] d[3]
  tmin S dm nh  { t_hi t_lo cos gap nm part nx ny nz (triangle only: u v) } * nh
np: sphere 4 (c r) box 6 (lo size) cylinder/cone 5 (c h r) torus 5 (c R r) triangle 9 (a b c)
All nh hits of the WHOLE line are listed, ascending t (negative too).  A test takes the hits with t>tmin.
true t = t_hi+t_lo (error < 2^-100 relative).  In class affine o,d and the normal are world space,
t is the shared parameter, S dm gap cos are object space.
See oracle.py for the meaning of S, dm, cos, gap, nm.  dmu = dm/(2^-53*S).
fan.txt: fan k  V[3] ring[3k] o[3] d[3] nhit exact   (closed triangles V,ring[i],ring[i+1] hit by the line;
  a watertight mesh intersector must report >= 1 hit)
"""
import argparse, math, random, sys, time, os
from fractions import Fraction
import oracle as O
import solids_gen
from gen_tools import crossf, dotf, dy, g6, hexf, inball, lu, mad, norm, perp, unit

# --- primitive samplers: return params, centre, bound radius, feature size
def prim_sample(prim, r, size, c):
    if prim == "sphere":
        return c + [size], c, size, size
    if prim == "box":
        s = [size * r.uniform(0.3, 1.5) for _ in range(3)]
        lo = [c[i] - s[i] / 2 for i in range(3)]
        return lo + s, c, math.sqrt(sum(x * x for x in s)) / 2, min(s)
    if prim in ("cylinder", "cone"):
        h, rad = size * r.uniform(0.4, 3), size * r.uniform(0.3, 1)
        return c + [h, rad], c, math.hypot(h / 2, rad), min(h, rad)
    if prim == "torus":
        R = size
        rr = size * r.uniform(0.05, 0.8)
        return c + [R, rr], c, R + rr, rr


def surf(prim, P, r):
    """approximate surface point and outward normal"""
    if prim == "sphere":
        u = unit(r)
        return mad(P[:3], P[3], u), u
    if prim == "box":
        i = r.randrange(3)
        s = r.randrange(2)
        p = [P[k] + P[3 + k] * r.random() for k in range(3)]
        p[i] = P[i] + (P[3 + i] if s else 0.0)
        n = [0.0] * 3
        n[i] = 1.0 if s else -1.0
        return p, n
    c = P[:3]
    a = r.uniform(0, 2 * math.pi)
    ca, sa = math.cos(a), math.sin(a)
    if prim == "cylinder":
        h, R = P[3], P[4]
        k = r.random()
        if k < 0.6:
            return [c[0] + R * ca, c[1] + h * (r.random() - 0.5), c[2] + R * sa], [ca, 0.0, sa]
        s = 1 if k < 0.8 else -1
        q = R * math.sqrt(r.random())
        return [c[0] + q * ca, c[1] + s * h / 2, c[2] + q * sa], [0.0, float(s), 0.0]
    if prim == "cone":
        h, R = P[3], P[4]
        if r.random() < 0.7:
            k = math.sqrt(r.uniform(0.001, 1))
            n = norm([h * ca, R, h * sa])
            return [c[0] + k * R * ca, c[1] + h / 2 - k * h, c[2] + k * R * sa], n
        q = R * math.sqrt(r.random())
        return [c[0] + q * ca, c[1] - h / 2, c[2] + q * sa], [0.0, -1.0, 0.0]
    if prim == "torus":
        R, rr = P[3], P[4]
        while True:
            b = r.uniform(0, 2 * math.pi)
            if R > rr or R + rr * math.cos(b) > 0:
                break
        w = R + rr * math.cos(b)
        return ([c[0] + w * ca, c[1] + w * sa, c[2] + rr * math.sin(b)],
                [math.cos(b) * ca, math.cos(b) * sa, math.sin(b)])


def to_project_frame(prim, P, o, d, M):
    """The samplers think of cylinder and cone by the centre of the solid, cone apex up; the project puts the
    base centre of a cylinder, and the apex of a cone that opens upwards, at (x,y,z). Rounding the new y moves the
    solid by at most an ulp, and the oracle then sees the moved one."""
    if prim == "cylinder":
        P = [P[0], P[1] - P[3] / 2] + P[2:]
    elif prim == "cone":
        P = [P[0], -(P[1] + P[3] / 2)] + P[2:]
        if M is None:
            o, d = [o[0], -o[1], o[2]], [d[0], -d[1], d[2]]
        else:
            M = [-x if i % 4 == 1 else x for i, x in enumerate(M)]
    return P, o, d, M


class Gen:
    def __init__(self, prim, seed, n, out):
        self.prim, self.seed, self.n = prim, seed, n
        self.f = open(os.path.join(out, prim + ".txt"), "w")
        self.f.write("# %s, seed %d; format: README.md\n" % (prim, seed))
        self.stat = {}

    def emit(self, cls, P, o, d, tmin=0.0, M=None, on_surface=False):
        prim = self.prim
        P = [float(x) for x in P]
        o = [float(x) for x in o]
        d = [float(x) for x in d]
        P, o, d, M = to_project_frame(prim, P, o, d, M)
        if not all(math.isfinite(x) for x in P + o + d) or (d[0] == 0 and d[1] == 0 and d[2] == 0):
            return False
        extra = None
        oo, dd = o, d
        if M is not None:
            oo, dd, extra, inv = O.ray_to_object(M, o, d)
        res = O.intersect(prim, P, oo, dd, extra)
        if res.deg:
            return False
        dl = math.sqrt(sum(float(O.rnd(O.Q(x))) ** 2 for x in dd)) if M is not None else math.sqrt(dotf(d, d))
        if on_surface:
            # ghost = root nearest 0
            if not res.hits:
                gcos = 1e-9
            else:
                gcos = max(min(res.hits, key=lambda h: abs(O.fl(h.t.b))).cos, 1e-9)
            tmin = 2.0 ** -40 * res.S / (gcos * dl)
        dm = res.dm
        toks = [cls] + [hexf(x) for x in P]
        if M is not None:
            toks += [hexf(x) for x in M]
        toks += [hexf(x) for x in o + d]
        hl = []
        nf = 0
        for h in res.hits:
            hi, lo = O.rnd2(h.t.q if h.t.q is not None else h.t.b)
            if not math.isfinite(hi):
                return False
            dm = min(dm, abs(hi - tmin) * dl * h.cos)
            n = h.n
            if M is not None:
                n = [sum((O.A(inv[k][i]) * n[k] for k in range(3)), O.arb(0)) for i in range(3)]
                l2 = O.vdot(n, n)
                if not l2.contains(0):
                    s = l2.sqrt()
                    n = [x / s for x in n]
            hl += [hexf(hi), hexf(lo), g6(h.cos), g6(h.gap), g6(h.nm), str(h.part)] + [hexf(O.rnd(x)) for x in n]
            if prim == "triangle":
                hl += [hexf(O.rnd(h.uv[0])), hexf(O.rnd(h.uv[1]))]
            if hi > tmin:
                nf += 1
        toks += [hexf(tmin), g6(res.S), g6(dm), str(len(res.hits))] + hl
        self.f.write(" ".join(toks) + "\n")
        st = self.stat.setdefault(cls, [0, 0, 0])
        st[0] += 1
        st[1] += nf > 0
        st[2] += dm >= 1024 * O.EPS * res.S
        return True

    def cls(self, name, fn):
        r = random.Random("%d/%s/%s" % (self.seed, self.prim, name))
        k = 0
        while k < self.n:
            a = fn(r)
            if a is None:
                continue
            kw = a[3] if len(a) > 3 else {}
            if self.emit(name, a[0], a[1], a[2], **kw):
                k += 1


def std_prim(prim, r):
    return prim_sample(prim, r, r.uniform(0.3, 3), [r.uniform(-5, 5) for _ in range(3)])


def run_implicit(prim, seed, n, out):
    G = Gen(prim, seed, n, out)

    def aimed(r, P, c, B, dist, unit_d=True):
        o = mad(c, dist * B, unit(r))
        d = [x - y for x, y in zip(inball(r, c, 1.2 * B), o)]
        return P, o, norm(d) if unit_d else d

    def typical(r):
        P, c, B, s = std_prim(prim, r)
        return aimed(r, P, c, B, r.uniform(1.2, 20), r.random() < 0.5)
    G.cls("typical", typical)
    for k in (3, 6, 9):
        def far(r, k=k):
            P, c, B, s = std_prim(prim, r)
            return aimed(r, P, c, B, 10.0 ** k * r.uniform(0.5, 2))
        G.cls("far1e%d" % k, far)

    def scale0(r):
        P, c, B, s = prim_sample(prim, r, lu(r, -6, 6), [0.0] * 3)
        return aimed(r, P, c, B, r.uniform(1.2, 20))
    G.cls("scale0", scale0)

    def scaleoff(r):
        z = lu(r, -6, 6)
        P, c, B, s = prim_sample(prim, r, z, [1e4 * z * x for x in unit(r)])
        return aimed(r, P, c, B, r.uniform(1.2, 20))
    G.cls("scaleoff", scaleoff)

    def graze(r):
        P, c, B, s = std_prim(prim, r)
        p, nn = surf(prim, P, r)
        tau = perp(r, nn)
        dlt = lu(r, -14, -2) * r.choice((-1, 1)) * s
        o = mad(mad(p, dlt, nn), -B * r.uniform(1.5, 8), tau)
        return P, o, tau
    G.cls("graze", graze)

    def zd(r):
        z = lambda: r.choice((0.0, -0.0))
        k = r.random()
        if k < 0.5:
            d = [z(), z(), z()]
            d[r.randrange(3)] = r.choice((-1.0, 1.0)) * (1.0 if r.random() < .5 else lu(r, -3, 3))
        else:
            d = norm([r.gauss(0, 1), r.gauss(0, 1), 0.0])
            d.insert(r.randrange(3), z())
            d.pop(3) if d[3] == 0 else d.pop(2) if d[2] == 0 else None
            if len(d) > 3:
                d = d[:3]
        return d

    def axis(r):
        c = [dy(r.uniform(-5, 5), 4) for _ in range(3)] if r.random() < .5 else [0.0] * 3
        P, c, B, s = prim_sample(prim, r, dy(r.uniform(0.5, 3), 4), c)
        d = zd(r)
        if not any(d):
            return None
        k = r.random()
        if k < 0.3:
            tgt = list(c)                                 # exactly through the centre
        elif k < 0.6:
            tgt = list(c)
            i = r.randrange(3)
            tgt[i] = tgt[i] + dy(r.uniform(-B, B), 8)     # through an axis
        else:
            tgt = inball(r, c, B)
        m = 2.0 ** r.randrange(2, 5)
        o = [tgt[i] - m * B * d[i] if d[i] != 0 else tgt[i] for i in range(3)]
        return P, o, d
    G.cls("axis", axis)

    def inside(r):
        P, c, B, s = std_prim(prim, r)
        p, nn = surf(prim, P, r)
        f = r.uniform(0.01, 0.99)
        if prim == "torus":
            o = mad(p, -f * P[4], nn)
        elif prim in ("sphere", "box", "cylinder"):
            o = [c[i] + (p[i] - c[i]) * f for i in range(3)]
        else:
            b = [c[0], c[1] - P[3] * 0.25, c[2]]
            o = [b[i] + (p[i] - b[i]) * f for i in range(3)]
        return P, o, unit(r)
    G.cls("inside", inside)

    def secondary(r, sgn):
        P, c, B, s = std_prim(prim, r)
        p, nn = surf(prim, P, r)
        cs = lu(r, -4, -1) if r.random() < 0.2 else r.uniform(0.05, 1)
        d = [sgn * cs * nn[i] for i in range(3)]
        t = perp(r, nn)
        q = math.sqrt(1 - cs * cs)
        d = [d[i] + q * t[i] for i in range(3)]
        if r.random() < .3:
            z = lu(r, -2, 2)
            d = [x * z for x in d]
        return P, p, d, {"on_surface": True}
    G.cls("leave", lambda r: secondary(r, 1))
    G.cls("enter", lambda r: secondary(r, -1))

    def dirscale(r):
        P, c, B, s = std_prim(prim, r)
        P, o, d = aimed(r, P, c, B, r.uniform(1.2, 20))
        z = lu(r, -6, 6)
        return P, o, [x * z for x in d]
    G.cls("dirscale", dirscale)

    def rot(r):
        a = unit(r)
        b = perp(r, a)
        return [a, b, crossf(a, b)]

    def affine(r):
        P, c, B, s = std_prim(prim, r)
        A1, A2 = rot(r), rot(r)
        sc = [lu(r, -2, 2) for _ in range(3)]
        L = [[sum(A1[k][i] * sc[k] * A2[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        T = [r.uniform(-10, 10) for _ in range(3)]
        M = []
        for i in range(3):
            M += L[i] + [T[i]]
        P, o, d = aimed(r, P, c, B, r.uniform(1.2, 20))
        ow = [dotf(L[i], o) + T[i] for i in range(3)]
        dw = [dotf(L[i], d) for i in range(3)]
        return P, ow, norm(dw), {"M": M}
    G.cls("affine", affine)

    if prim in ("box", "cylinder", "cone"):
        def rim(r):
            P, c, B, s = std_prim(prim, r)
            a = r.uniform(0, 2 * math.pi)
            if prim == "box":
                p = [P[k] + P[3 + k] * r.random() for k in range(3)]
                ks = r.sample(range(3), r.choice((2, 2, 3)))
                for k in ks:
                    p[k] = P[k] + P[3 + k] * r.randrange(2)
            else:
                sg = -1 if prim == "cone" else r.choice((-1, 1))
                p = [c[0] + P[4] * math.cos(a), c[1] + sg * P[3] / 2, c[2] + P[4] * math.sin(a)]
            p = mad(p, s * lu(r, -14, -2), unit(r))
            o = mad(c, B * r.uniform(1.5, 10), unit(r))
            return P, o, norm([p[i] - o[i] for i in range(3)])
        G.cls("rim", rim)
    if prim == "cone":
        def apex(r):
            P, c, B, s = std_prim(prim, r)
            p = mad([c[0], c[1] + P[3] / 2, c[2]], s * lu(r, -14, -1), unit(r))
            o = mad(c, B * r.uniform(1.5, 10), unit(r))
            return P, o, norm([p[i] - o[i] for i in range(3)])
        G.cls("apex", apex)

        def generator(r):     # nearly parallel to a generator line: leading coefficient cancels
            P, c, B, s = std_prim(prim, r)
            a = r.uniform(0, 2 * math.pi)
            g = norm([P[4] * math.cos(a), -P[3], P[4] * math.sin(a)])
            e = lu(r, -16, -3)
            d = norm(mad(g, e, unit(r)))
            p = inball(r, c, B)
            return P, mad(p, -B * r.uniform(1.5, 8), d), d
        G.cls("generator", generator)
    if prim == "torus":
        def withR(r, ratio, c=None):
            c = [r.uniform(-5, 5) for _ in range(3)] if c is None else c
            R = r.uniform(0.3, 3)
            return c + [R, R * ratio], c, R * (1 + ratio)

        def spindle(r):
            P, c, B = withR(r, r.uniform(1.01, 4))
            return aimed(r, P, c, B, r.uniform(1.2, 20))
        G.cls("spindle", spindle)

        def horn(r):
            k = r.random()
            P, c, B = withR(r, 1.0 if k < .5 else 1 + r.choice((-1, 1)) * lu(r, -15, -2))
            return aimed(r, P, c, B, r.uniform(1.2, 20))
        G.cls("horn", horn)

        def thin(r):
            P, c, B = withR(r, lu(r, -5, -3))
            p, nn = surf(prim, P, r)
            p = inball(r, mad(p, -P[4], nn), 1.2 * P[4])
            o = mad(c, B * r.uniform(1.2, 10), unit(r))
            return P, o, norm([p[i] - o[i] for i in range(3)])
        G.cls("thin", thin)

        def biquad(r):
            c = [dy(r.uniform(-4, 4), 4) for _ in range(3)] if r.random() < .6 else [0.0] * 3
            P = c + [dy(r.uniform(.5, 3), 6), 0.0]
            P[4] = dy(P[3] * r.uniform(0.1, 1.2), 6)
            k = r.random()
            if k < 0.4:                     # exactly through the centre
                d = [dy(x, 8) for x in unit(r)]
                m = 2.0 ** r.randrange(1, 5)
                o = [c[i] - m * d[i] for i in range(3)]
            elif k < 0.6:                   # from the axis
                o = [c[0], c[1], c[2] + dy(r.uniform(-8, 8), 6)]
                d = [dy(x, 10) for x in unit(r)]
            elif k < 0.8:                   # parallel to the axis / in the xy plane
                o = [c[0] + dy(r.uniform(-4, 4), 6), c[1] + dy(r.uniform(-4, 4), 6), c[2] + 8]
                d = [0.0, 0.0, -1.0]
            else:
                o = [c[0] + 8, c[1] + dy(r.uniform(-4, 4), 6), c[2]]
                d = [-1.0, dy(r.uniform(-.5, .5), 6), r.choice((0.0, -0.0))]
            if not any(d):
                return None
            return P, o, d
        G.cls("biquad", biquad)

        def inflect(r):        # near-triple/quadruple roots: asymptotic directions and the top circle plane
            P, c, B, s = std_prim("torus", r)
            R, rr = P[3], P[4]
            a = r.uniform(0, 2 * math.pi)
            er, et, ez = [math.cos(a), math.sin(a), 0.0], [-math.sin(a), math.cos(a), 0.0], [0.0, 0.0, 1.0]
            b = r.uniform(math.pi / 2, 3 * math.pi / 2) if r.random() < .8 else math.pi / 2
            nn = [math.cos(b) * er[i] + math.sin(b) * ez[i] for i in range(3)]
            tm = [-math.sin(b) * er[i] + math.cos(b) * ez[i] for i in range(3)]
            w = R + rr * math.cos(b)
            k1, k2 = 1 / rr, math.cos(b) / w if w != 0 else 0.0
            if w <= 0 or k2 > 0:
                return None
            th = math.atan(math.sqrt(-k1 / k2)) if k2 != 0 else math.pi / 2
            tau = [math.cos(th) * tm[i] + math.sin(th) * et[i] for i in range(3)]
            e = lu(r, -14, -2) * r.choice((-1, 1))
            tau = norm(mad(tau, e, unit(r)))
            p = [c[i] + w * er[i] + (rr * math.sin(b)) * ez[i] for i in range(3)]
            p = mad(p, rr * lu(r, -14, -2) * r.choice((-1, 1)), nn)
            return P, mad(p, -B * r.uniform(1.5, 6), tau), tau
        G.cls("inflect", inflect)
    def special(r):            # dyadic everything: origin at centre / axis / foci / on the surface or its extension, "round" directions
        c = [0.0] * 3 if r.random() < .5 else [dy(r.uniform(-4, 4), 3) for _ in range(3)]
        a = dy(r.uniform(.5, 3), 4)
        if prim == "torus":
            R, rr = a, a * r.choice((0.25, 0.5, 1.0, 2.0, 1.5))
            P = c + [R, rr]
            base = r.choice([(0, 0, 0), (R, 0, 0), (0, -R, 0), (0, 0, rr), (0, 0, -rr / 2), (R / 2, 0, 0), (R, 0, rr / 2), (-R, 0, -rr / 4),
                             (0, 0, 2 * rr), (R + 2 * rr, 0, 0), (R + rr, 2 * R + 2 * rr, 0), (0, 4 * R, rr / 2), (4 * R, 0, rr / 2), (R - rr, -4 * R, 0)])
        elif prim == "sphere":
            P = c + [a]
            base = [a * r.choice((-2, -1, -.5, 0, 0, .5, 1, 2)) for _ in range(3)]
        elif prim == "box":
            w = [a * r.choice((.5, 1, 2)) for _ in range(3)]
            P = c + w
            base = [x * r.choice((-1, 0, .25, .5, 1, 1.5)) for x in w]
        else:
            h = a * r.choice((.5, 1, 2, 4))
            P = c + [h, a]
            base = [a * r.choice((-2, -1, -.5, 0, 0, .5, 1, 2)), h * r.choice((-1, -.5, -.25, 0, .25, .5, 1)), a * r.choice((-2, -1, 0, 0, .5, 1))]
        d = [r.choice((0.0, -0.0, 1.0, -1.0, 0.5, -0.25, 2.0)) for _ in range(3)]
        if not any(d):
            return None
        return P, [c[i] + base[i] for i in range(3)], d
    G.cls("special", special)
    G.f.close()
    return G.stat


def run_triangle(seed, n, out):
    G = Gen("triangle", seed, n, out)

    def tri(r, s=1.0, c=None):
        c = [r.uniform(-5, 5) for _ in range(3)] if c is None else c
        return [x for _ in range(3) for x in inball(r, c, s)]

    def pt(P, u, v):
        return [P[i] * (1 - u - v) + P[3 + i] * u + P[6 + i] * v for i in range(3)]

    def bary(r, over=0.25):
        while True:
            u, v = r.uniform(-over, 1 + over), r.uniform(-over, 1 + over)
            if u + v <= 1 + over:
                return u, v

    def cen(P):
        return [(P[i] + P[3 + i] + P[6 + i]) / 3 for i in range(3)]

    def typical(r):
        P = tri(r, r.uniform(.3, 3))
        o = mad(cen(P), r.uniform(1, 20), unit(r))
        p = pt(P, *bary(r))
        d = [p[i] - o[i] for i in range(3)]
        return P, o, norm(d) if r.random() < .5 else d
    G.cls("typical", typical)
    for k in (3, 6, 9):
        def far(r, k=k):
            P = tri(r)
            o = mad(cen(P), 10.0 ** k * r.uniform(.5, 2), unit(r))
            p = pt(P, *bary(r))
            return P, o, norm([p[i] - o[i] for i in range(3)])
        G.cls("far1e%d" % k, far)

    def scale0(r):
        z = lu(r, -6, 6)
        P = tri(r, z, [0.0] * 3)
        o = mad(cen(P), z * r.uniform(1, 20), unit(r))
        p = pt(P, *bary(r))
        return P, o, norm([p[i] - o[i] for i in range(3)])
    G.cls("scale0", scale0)

    def scaleoff(r):
        z = lu(r, -6, 6)
        P = tri(r, z, [1e4 * z * x for x in unit(r)])
        o = mad(cen(P), z * r.uniform(1, 20), unit(r))
        p = pt(P, *bary(r))
        return P, o, norm([p[i] - o[i] for i in range(3)])
    G.cls("scaleoff", scaleoff)

    def edge(r):           # near edges, relative distance 1e-2..1e-14
        P = tri(r, r.uniform(.3, 3))
        u = r.random()
        e = lu(r, -14, -2) * r.choice((-1, 1))
        u, v = r.choice(((u, e), (e, u), (u, 1 - u + e)))
        p = pt(P, u, v)
        o = mad(cen(P), r.uniform(1, 10), unit(r))
        return P, o, norm([p[i] - o[i] for i in range(3)])
    G.cls("edge", edge)

    def dtri(r):
        while True:
            P = [dy(x, 8) for x in tri(r, 2.0)]
            e1 = [P[3 + i] - P[i] for i in range(3)]
            e2 = [P[6 + i] - P[i] for i in range(3)]
            if dotf(crossf(e1, e2), crossf(e1, e2)) > 1e-3:
                return P

    def exactedge(r):      # exactly on an edge / vertex (all arithmetic exact), at t = 1 or 2^-k
        P = dtri(r)
        k = r.randrange(0, 257) / 256.0
        i = r.randrange(3)
        a, b = P[3 * i:3 * i + 3], P[3 * ((i + 1) % 3):3 * ((i + 1) % 3) + 3]
        if r.random() < .3:
            k = 0.0
        p = [a[j] + (b[j] - a[j]) * k for j in range(3)]
        o = [dy(x, 8) for x in mad(cen(P), r.uniform(1, 10), unit(r))]
        m = 2.0 ** r.randrange(-3, 4)
        return P, o, [(p[j] - o[j]) * m for j in range(3)]
    G.cls("exactedge", exactedge)

    def sliver(r):
        a = [r.uniform(-5, 5) for _ in range(3)]
        dr = unit(r)
        L = r.uniform(.5, 3)
        w = L * lu(r, -7, -5)
        b = mad(a, L, dr)
        c = mad(mad(a, L * r.random(), dr), w, perp(r, dr))
        P = a + b + c
        if r.random() < .5:
            P = P[3:] + P[:3]
        p = pt(P, *bary(r))
        o = mad(a, r.uniform(1, 10), unit(r))
        return P, o, norm([p[i] - o[i] for i in range(3)])
    G.cls("sliver", sliver)

    def huge(r):
        z = lu(r, 5, 9)
        P = tri(r, z, [r.uniform(-1, 1) * z for _ in range(3)])
        o = [r.uniform(-10, 10) for _ in range(3)]
        if r.random() < .5:      # passing near the origin
            n = unit(r)
            t1 = perp(r, n)
            t2 = crossf(n, t1)
            q = mad([0.0] * 3, r.uniform(-20, 20), n)
            P = mad(q, -z, t1) + mad(mad(q, z * r.uniform(.2, 1), t1), -z, t2) + mad(mad(q, z * .5, t1), z, t2)
            p = mad(q, 50, unit(r))
        else:
            p = pt(P, *bary(r))
        return P, o, norm([p[i] - o[i] for i in range(3)])
    G.cls("huge", huge)

    def parallel(r):
        P = tri(r, r.uniform(.3, 3))
        e1 = [P[3 + i] - P[i] for i in range(3)]
        e2 = [P[6 + i] - P[i] for i in range(3)]
        nn = crossf(e1, e2)
        if dotf(nn, nn) < 1e-6:
            return None
        nn = norm(nn)
        t = perp(r, nn)
        e = lu(r, -17, -2) * r.choice((-1, 1))
        p = pt(P, *bary(r))
        d = norm(mad(t, e, nn))
        return P, mad(p, -r.uniform(2, 10), d), d
    G.cls("parallel", parallel)

    def axis(r):
        P = dtri(r)
        z = lambda: r.choice((0.0, -0.0))
        d = [z(), z(), z()]
        i = r.randrange(3)
        d[i] = r.choice((-1.0, 1.0))
        if r.random() < .4:
            d[(i + 1) % 3] = dy(r.uniform(-1, 1), 8)
        u, v = (dy(x, 4) for x in bary(r, .1))
        p = pt(P, u, v)
        return P, [p[j] - 8 * d[j] if d[j] != 0 else p[j] for j in range(3)], d
    G.cls("axis", axis)

    def secondary(r):      # leaves the triangle: ghost must be excluded by tmin; no other hit exists
        P = tri(r, r.uniform(.3, 3))
        e1 = [P[3 + i] - P[i] for i in range(3)]
        e2 = [P[6 + i] - P[i] for i in range(3)]
        nn = crossf(e1, e2)
        if dotf(nn, nn) < 1e-6:
            return None
        nn = norm(nn)
        u, v = bary(r, 0)
        cs = lu(r, -4, -1) if r.random() < 0.2 else r.uniform(0.05, 1)
        t = perp(r, nn)
        q = math.sqrt(1 - cs * cs)
        s = r.choice((-1, 1))
        return P, pt(P, u, v), [s * cs * nn[i] + q * t[i] for i in range(3)], {"on_surface": True}
    G.cls("leave", secondary)

    def affine(r):
        P = tri(r, r.uniform(.3, 3))
        a, a2 = unit(r), unit(r)
        b, b2 = perp(r, a), perp(r, a2)
        A1, A2 = [a, b, crossf(a, b)], [a2, b2, crossf(a2, b2)]
        sc = [lu(r, -2, 2) for _ in range(3)]
        L = [[sum(A1[k][i] * sc[k] * A2[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        T = [r.uniform(-10, 10) for _ in range(3)]
        M = []
        for i in range(3):
            M += L[i] + [T[i]]
        o = mad(cen(P), r.uniform(1, 20), unit(r))
        p = pt(P, *bary(r))
        d = [p[i] - o[i] for i in range(3)]
        return P, [dotf(L[i], o) + T[i] for i in range(3)], norm([dotf(L[i], d) for i in range(3)]), {"M": M}
    G.cls("affine", affine)
    G.f.close()
    # watertight fans
    r = random.Random("%d/fan" % seed)
    F = open(os.path.join(out, "fan.txt"), "w")
    F.write("# fan k V[3] ring[3k] o[3] d[3] nhit kind : line certified to cross the closed fan, >=1 hit required\n")
    k = 0
    ne = 0
    while k < 4 * n:
        K = r.randrange(4, 9)
        ax = unit(r)
        b1 = perp(r, ax)
        b2 = crossf(ax, b1)
        kind = r.choice(("vertex", "edge", "near", "flat"))
        off = [r.uniform(-100, 100) for _ in range(3)] if r.random() < .5 else [0.0] * 3
        ring = []
        for i in range(K):
            a = 2 * math.pi * (i + r.uniform(-.2, .2)) / K
            s = r.uniform(.3, 1.5) * (lu(r, -4, 0) if kind == "flat" else 1)
            q = mad(mad(mad(off, s * math.cos(a), b1), s * math.sin(a), b2), r.uniform(-.3, .3) * s, ax)
            ring.append([dy(x, 30) for x in q])
        V = [dy(x, 30) for x in off]
        d = norm(mad(ax, .3, unit(r)))
        dist = r.uniform(1, 50)
        if kind == "vertex":
            o = [dy(x, 20) for x in mad(V, -dist, d)]
            d = [V[i] - o[i] for i in range(3)]
        else:
            i = r.randrange(K)
            f = r.randrange(1, 128) / 256.0
            p = [V[j] + f * (ring[i][j] - V[j]) for j in range(3)]
            o = mad(p, -dist, d)
            if kind == "edge":
                o = [dy(x, 10) for x in o]
            d = [p[j] - o[j] for j in range(3)]
            if kind == "near":
                d = norm(d)
        nh = 0
        sg = []
        for i in range(K):
            T = V + ring[i] + ring[(i + 1) % K]
            res = O.intersect("triangle", T, o, d)
            nh += len(res.hits)
            a = [O.Q(x) for x in ring[i]]
            b = [O.Q(x) for x in ring[(i + 1) % K]]
            oo = [O.Q(x) for x in o]
            vq = [O.Q(x) for x in V]
            sg.append(O.vdot(O.cross(O.vsub(a, vq), O.vsub(b, vq)), [O.Q(x) for x in d]))
        if not (all(x > 0 for x in sg) or all(x < 0 for x in sg)) or nh == 0:
            continue
        F.write(" ".join(["fan", str(K)] + [hexf(x) for x in V] + [hexf(x) for q in ring for x in q]
                         + [hexf(x) for x in o + d] + [str(nh), kind]) + "\n")
        k += 1
        ne += nh > 1
    F.close()
    G.stat["fan"] = [k, k, ne]
    return G.stat


if __name__ == "__main__":
    ap = argparse.ArgumentParser()
    ap.add_argument("--seed", type=int, default=1)
    ap.add_argument("--n", type=int, default=2000)
    ap.add_argument("--out", default="vec")
    ap.add_argument("--prim", default="all")
    a = ap.parse_args()
    os.makedirs(a.out, exist_ok=True)
    prims = ["sphere", "box", "cylinder", "cone", "torus", "triangle"] + list(solids_gen.RUNS) if a.prim == "all" else a.prim.split(",")
    for p in prims:
        t0 = time.time()
        if p in solids_gen.RUNS:
            st = solids_gen.run(p, a.seed, a.n, a.out)
        else:
            st = run_triangle(a.seed, a.n, a.out) if p == "triangle" else run_implicit(p, a.seed, a.n, a.out)
        print(p, "%.1fs" % (time.time() - t0))
        for k, v in st.items():
            print("   %-10s n=%d hit(t>tmin)=%d well-cond=%d" % (k, *v))
        sys.stdout.flush()
