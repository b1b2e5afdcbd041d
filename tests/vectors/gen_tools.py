"""What the generators of cases share."""
import math

hexf = lambda x: float(x).hex()
g6 = lambda x: ("%.5e" % x) if math.isfinite(x) else "1e308"


def unit(r):
    while True:
        v = [r.gauss(0, 1) for _ in range(3)]
        l = math.sqrt(sum(x * x for x in v))
        if l > 1e-3:
            return [x / l for x in v]


def norm(v):
    l = math.sqrt(sum(x * x for x in v))
    return [x / l for x in v]


def crossf(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dotf(a, b):
    return sum(x * y for x, y in zip(a, b))


def mad(p, s, v):
    return [p[i] + s * v[i] for i in range(3)]


def perp(r, n):
    while True:
        v = crossf(n, unit(r))
        if dotf(v, v) > 1e-2:
            return norm(v)


def lu(r, a, b):
    return 10 ** r.uniform(a, b)


def dy(x, bits=10):            # dyadic rounding -> exact arithmetic downstream
    return round(x * 2 ** bits) / 2 ** bits


def inball(r, c, rad):
    return mad(c, rad * r.random() ** (1 / 3), unit(r))
