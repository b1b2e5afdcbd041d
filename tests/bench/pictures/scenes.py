"""The benchmark scenes as plain tables, from which lua.py writes scripts and pov.py their POV-Ray twins.

Right-handed, y up. A material holds: colour, the weights of ambient and diffuse light, highlight weight and exponent,
mirror weight, transmitted share (0: opaque) and index of refraction.
"""
import math, random

WIDTH, HEIGHT = 640, 360
SKY = [0.1, 0.15, 0.25]


def mat(color, highlight=0.0, exponent=40, ambient=0.1, diffuse=0.7, mirror=0.0, transmit=0.0, ior=1.0):
    return dict(color=list(color), ambient=ambient, diffuse=diffuse, phong=highlight, phong_size=exponent,
                reflection=mirror, transmit=transmit, ior=ior)


GROUND = mat((0.8, 0.8, 0.8))
GLASS = mat((1, 1, 1), 0.4, 100, ambient=0.0, diffuse=0.0, mirror=0.08, transmit=0.90, ior=1.5)
WATER = mat((0.7, 0.85, 1.0), ambient=0.0, diffuse=0.05, transmit=0.95, ior=1.33)
MIRROR = mat((0.9, 0.9, 1.0), 0.3, 100, diffuse=0.1, mirror=0.80)


def sphere(center, radius, m):
    return dict(type="sphere", center=list(center), radius=radius, mat=m)


def cylinder(p0, p1, radius, m):
    return dict(type="cylinder", p0=list(p0), p1=list(p1), radius=radius, mat=m)


def cone(base, radius, apex, m):
    return dict(type="cone", p0=list(base), r0=radius, p1=list(apex), mat=m)


def torus(center, axis, major, minor, m):
    length = math.sqrt(sum(x * x for x in axis))
    return dict(type="torus", center=[float(x) for x in center], axis=[x / length for x in axis], major=major,
                minor=minor, mat=m)


def box(low, high, m, turned=0.0, at=(0.0, 0.0, 0.0)):
    """turned by degrees about y, then moved"""
    return dict(type="box", min=list(low), max=list(high), mat=m, turned=turned, at=list(at))


def tiles(low, high, y, file, scale, highlight=0.0, exponent=40):
    """a textured rectangle in the plane y, an image every `scale` units"""
    return dict(type="tiles", min=list(low), max=list(high), y=y, file=file, scale=scale,
                mat=mat((1, 1, 1), highlight, exponent, ambient=0.1 / 0.7, diffuse=1.0))


def mesh(size, m):
    return dict(type="mesh", size=size, mat=m)


def light(pos, strength, radius=0.0):
    return dict(pos=list(pos), color=[strength] * 3, radius=radius)


def camera(eye, at, fovy, lens_radius=0.0, focus=None):
    """focus: a point on the line from eye to at"""
    return dict(eye=list(eye), at=list(at), up=[0, 1, 0], fovy=fovy, lens_radius=lens_radius, focus=focus)


def scene(name, title, cam, lights, objects, max_depth=5, size=(WIDTH, HEIGHT)):
    return dict(name=name, title=title, background=SKY, camera=cam, lights=lights, objects=objects,
                max_depth=max_depth, size=size)


def s1():
    def paint(*color, weight=0.5, exponent=60):
        return mat(color, weight, exponent)
    objects = [box((-40, -1, -40), (40, 0, 40), GROUND),
               sphere((-3.6, 1.0, 0.0), 1.0, paint(0.9, 0.2, 0.2)),
               sphere((-1.6, 0.7, 2.0), 0.7, paint(0.2, 0.7, 0.3)),
               sphere((-1.2, 1.4, -1.8), 1.4, paint(0.3, 0.4, 0.9)),
               sphere((0.4, 0.45, 3.0), 0.45, paint(0.9, 0.8, 0.2)),
               sphere((2.6, 0.55, 2.6), 0.55, paint(0.8, 0.3, 0.8)),
               cylinder((4.2, 0.0, -0.6), (4.2, 2.6, -0.6), 0.8, paint(0.9, 0.6, 0.3, weight=0.4, exponent=30)),
               cone((1.9, 0.0, -1.4), 1.0, (1.9, 2.6, -1.4), paint(0.4, 0.8, 0.8, weight=0.4, exponent=30)),
               torus((1.2, 0.35, 1.2), (0, 1, 0), 0.85, 0.35, paint(0.9, 0.5, 0.5))]
    return scene("S1", "soft shadows", camera((0, 4.5, 11), (0.2, 0.6, 0), 32.0),
                 [light((6, 9, 6), 0.65, 1.5), light((-7, 7, 4), 0.45, 1.0)], objects)


def s2():
    def paint(*color):
        return mat(color, 0.5, 60)
    objects = [box((-40, -1, -40), (40, 0, 40), GROUND),
               box((-40, 0, -7), (40, 12, -6), mat((0.6, 0.7, 0.8))),
               sphere((-2.4, 1.2, 1.6), 1.2, GLASS),
               cylinder((0.6, 0.01, 1.4), (0.6, 2.2, 1.4), 0.9, GLASS),
               cylinder((0.6, 0.15, 1.4), (0.6, 1.9, 1.4), 0.78, WATER),
               box((-1.5, 0, -1.5), (1.5, 3.0, 1.5), MIRROR, 30, (3.6, 0.001, -2.5)),
               sphere((-0.9, 0.5, 3.2), 0.5, paint(0.9, 0.2, 0.2)),
               sphere((2.3, 0.5, 2.6), 0.5, paint(0.2, 0.8, 0.3)),
               sphere((-1.6, 0.8, -2.6), 0.8, paint(0.9, 0.8, 0.2)),
               cylinder((-4.2, 0, -1.8), (-4.2, 2.6, -1.8), 0.5, paint(0.8, 0.4, 0.9)),
               torus((-3.9, 0.25, 3.4), (0, 1, 0), 0.6, 0.25, paint(0.3, 0.5, 0.9))]
    return scene("S2", "glass", camera((0, 3.6, 10.5), (0, 1.1, 0), 34.0), [light((-5, 9, 7), 1.0, 1.0)], objects,
                 max_depth=10, size=(320, 180))


def s3():
    rng = random.Random(31)
    objects = [box((-60, -1, -60), (60, 0, 60), GROUND)]
    for row in range(7):
        for column in range(5):
            x, z = 1.7 * (column - 2) + 0.35 * row - 1.0, 5.0 - 2.4 * row
            m = mat([round(rng.uniform(0.2, 0.95), 3) for _ in range(3)], 0.5, 60)
            kind = (row + 2 * column) % 4
            if kind == 0:
                objects.append(sphere((x, 0.55, z), 0.55, m))
            elif kind == 1:
                objects.append(cylinder((x, 0, z), (x, 1.3, z), 0.4, m))
            elif kind == 2:
                objects.append(cone((x, 0, z), 0.55, (x, 1.4, z), m))
            else:
                objects.append(torus((x, 0.62, z), (0.4, 0, 1), 0.45, 0.17, m))
    eye, at = (0, 2.6, 10.0), (0, 0.7, 0.2)
    return scene("S3", "depth of field", camera(eye, at, 30.0, 0.16, list(at)), [light((5, 9, 8), 1.0, 0.8)], objects,
                 size=(320, 180))


def s4(count=400):
    rng = random.Random(12345)
    k = (400.0 / count) ** (1 / 3)
    objects = [box((-60, -5, -60), (60, -4, 60), GROUND)]
    for _ in range(count):
        center = [round(rng.uniform(*r), 6) for r in ((-7, 7), (-3.2, 3.8), (-8, 4))]
        z, turn = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
        s = math.sqrt(1 - z * z)
        major = rng.uniform(0.35, 0.7) * k
        minor = major * rng.uniform(0.2, 0.45)
        color = [round(rng.uniform(0.2, 0.95), 4) for _ in range(3)]
        objects.append(torus(center, (s * math.cos(turn), z, s * math.sin(turn)), round(major, 6), round(minor, 6),
                             mat(color, 0.5, 60)))
    return scene("S4", "tori", camera((0, 1.0, 15), (0, 0, 0), 32.0), [light((10, 14, 16), 0.95)], objects)


def s5():
    return scene("S5", "mesh", camera((0, 2.0, 8.5), (0, -0.1, 0), 34.0), [light((6, 9, 6), 1.0, 1.0)],
                 [box((-40, -3, -40), (40, -2.3, 40), GROUND), mesh("500k", mat((0.8, 0.55, 0.35), 0.4, 40))],
                 size=(320, 180))


def s6():
    def paint(*color):
        return mat(color, 0.5, 60)
    wall = mat((0.75, 0.7, 0.6))
    objects = [tiles((-5, -6), (5, 9), 0.0, "floor.png", 4.0, 0.2, 40),
               box((-5.2, 0, -6), (-5, 5, 9), mat((0.7, 0.4, 0.35))),
               box((5, 0, -6), (5.2, 5, 9), mat((0.4, 0.55, 0.7))),
               box((-5.2, 0, -6.2), (5.2, 5, -6), wall),
               box((-5.2, 5, -6.2), (5.2, 5.2, 9), wall),
               box((-2.2, 0.8, -5.98), (2.2, 3.8, -5.9), MIRROR),
               sphere((-1.9, 1.0, 0.2), 1.0, GLASS),
               sphere((0.3, 0.6, 2.2), 0.6, mat((0.9, 0.9, 0.9), 0.3, 100, diffuse=0.2, mirror=0.7)),
               cylinder((2.5, 0, -0.8), (2.5, 1.1, -0.8), 0.9, paint(0.5, 0.35, 0.2)),
               sphere((2.5, 1.6, -0.8), 0.5, GLASS),
               torus((-3.4, 0.3, 2.4), (0, 1, 0), 0.7, 0.3, paint(0.3, 0.7, 0.4)),
               cone((-3.2, 0, -3.4), 0.8, (-3.2, 2.2, -3.4), paint(0.9, 0.8, 0.2)),
               box((-0.6, 0, -0.6), (0.6, 1.2, 0.6), paint(0.8, 0.3, 0.3), 25, (0.6, 0, -2.6))]
    eye, at = (0.4, 2.2, 8.6), (0, 1.2, 0.2)
    return scene("S6", "textured room", camera(eye, at, 42.0, 0.06, list(at)),
                 [light((-2.5, 4.5, 3.0), 0.55, 0.35), light((3.0, 4.5, -1.0), 0.45, 0.35)], objects, max_depth=8,
                 size=(320, 180))


def s7():
    rng = random.Random(77)
    objects = [box((-40, -1, -40), (40, 0, 40), GROUND)]
    for _ in range(300):
        x, z = rng.uniform(-6, 6), rng.uniform(-8, 4)
        tilt = [rng.gauss(0, 0.25), rng.gauss(0, 0.25)]
        height = rng.uniform(0.8, 2.8)
        top = [round(v, 5) for v in (x + tilt[0] * height, height, z + tilt[1] * height)]
        color = [round(rng.uniform(0.2, 0.95), 3) for _ in range(3)]
        objects.append(cylinder((round(x, 5), 0, round(z, 5)), top, round(rng.uniform(0.012, 0.05), 4),
                                mat(color, 0.4, 50)))
    return scene("S7", "rods", camera((0, 3.2, 10.5), (0, 0.9, -0.5), 34.0), [light((6, 10, 6), 1.0, 0.8)], objects,
                 size=(320, 180))


SCENES = {"S1": s1, "S2": s2, "S3": s3, "S4": s4, "S5": s5, "S6": s6, "S7": s7}
