"""Random solids about the origin, as calls of the scene language, and the vectors for them."""
import math

KINDS = ["sphere", "box", "cylinder", "cone", "torus", "mesh"]
CONVEX = ["sphere", "box", "cylinder", "cone"]


def number(x):
    return repr(float(x))


def triple(v):
    return "{%s}" % ", ".join(number(x) for x in v)


def add(a, b, factor=1.0):
    return [x + factor * y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.sqrt(dot(v, v))
    return [x / length for x in v]


def random_unit(rng):
    while True:
        v = [rng.gauss(0, 1) for _ in range(3)]
        if dot(v, v) > 1e-4:
            return unit(v)


def round_mesh(rng):
    """A closed star-shaped mesh of quadrangles and triangles, with its vertices in general position."""
    rings, slices = 5, 8
    at = lambda ring, k: 1 + (ring - 1) * slices + k % slices
    vertices = [[0.0, rng.uniform(0.8, 1.1), 0.0]]
    for ring in range(1, rings):
        for k in range(slices):
            tilt, turn, radius = math.pi * ring / rings, 2 * math.pi * k / slices, rng.uniform(0.8, 1.1)
            vertices.append([radius * math.sin(tilt) * math.cos(turn), radius * math.cos(tilt),
                             radius * math.sin(tilt) * math.sin(turn)])
    last = len(vertices)
    vertices.append([0.0, -rng.uniform(0.8, 1.1), 0.0])
    faces = []
    for k in range(slices):
        faces.append([0, at(1, k + 1), at(1, k)])
        faces.append([last, at(rings - 1, k), at(rings - 1, k + 1)])
        for ring in range(1, rings - 1):
            faces.append([at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)])
            faces.append([at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)])
    return vertices, faces


class Solid:
    """About a unit in size, about the origin; symmetric in x, but for meshes."""

    def __init__(self, kind, rng):
        self.kind = kind
        u = rng.uniform
        if kind == "sphere":
            self.anchor, self.lengths = [0.0, u(-.2, .2), u(-.2, .2)], [u(.6, 1.1)]
        elif kind == "box":
            self.lengths = [u(.8, 1.6), u(.8, 1.6), u(.8, 1.6)]
            self.anchor = [-x / 2 for x in self.lengths]
        elif kind == "cylinder":
            self.anchor, self.lengths = [0.0, u(-.9, -.6), 0.0], [u(1.2, 1.8), u(.5, .9)]
        elif kind == "cone":
            self.anchor, self.lengths = [0.0, u(-.9, -.6), 0.0], [u(1.2, 1.8), u(.5, .9)]
        elif kind == "torus":
            self.anchor, self.lengths = [0.0, 0.0, 0.0], [u(.6, .8), u(.15, .35)]
        else:
            self.anchor, self.lengths = [0.0, 0.0, 0.0], []
            self.vertices, self.faces = round_mesh(rng)

    def inside(self):
        """A point well inside."""
        a, n = self.anchor, self.lengths
        if self.kind in ("sphere", "mesh"):
            return list(a)
        if self.kind == "box":
            return add(a, n, 0.5)
        if self.kind == "torus":
            return [n[0], 0.0, 0.0]
        return [a[0], a[1] + n[0] * (0.5 if self.kind == "cylinder" else 0.7), a[2]]

    def lua(self, scale=1.0, offset=(0.0, 0.0, 0.0), mirror=False):
        """The call that makes it, scaled and then moved, in its coordinates."""
        sign = -1.0 if mirror else 1.0
        at = lambda v: triple([o + scale * x for o, x in zip(offset, [sign * v[0], v[1], v[2]])])
        if self.kind == "mesh":
            return "gr.mesh('m', {%s}, {%s}, {smooth = false})" % (
                ", ".join(at(v) for v in self.vertices), ", ".join("{%d, %d, %d}" % tuple(f) for f in self.faces))
        anchor = list(self.anchor)
        if mirror and self.kind == "box":
            anchor[0] += self.lengths[0]
        lengths = [scale * x for x in self.lengths]
        if self.kind == "box":
            return "gr.nh_box('b', %s, %s)" % (at(anchor), triple(lengths))
        return "gr.nh_%s('s', %s, %s)" % (self.kind, at(anchor), ", ".join(number(x) for x in lengths))


def matrix_of(calls):
    """Column vectors and translation of transform calls [(name, arguments)], the last applied last."""
    columns, shift = [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]], [0.0, 0.0, 0.0]
    for name, arguments in calls:
        apply = lambda v, n=name, a=arguments: turned(v, *a) if n == "rotate" else [x * y for x, y in zip(v, a)]
        if name == "translate":
            shift = add(shift, arguments)
        else:
            columns, shift = [apply(c) for c in columns], apply(shift)
    return columns, shift


def turned(v, axis, degrees):
    angle = math.radians(degrees)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    out = list(v)
    out[i] = math.cos(angle) * v[i] - math.sin(angle) * v[j]
    out[j] = math.sin(angle) * v[i] + math.cos(angle) * v[j]
    return out


def mapped(matrix, point, vector=False):
    columns, shift = matrix
    out = [sum(columns[k][i] * point[k] for k in range(3)) for i in range(3)]
    return out if vector else add(out, shift)


def calls_lua(node, calls):
    text = ""
    for name, arguments in calls:
        text += "%s:%s(%s)\n" % (node, name, ", ".join("'%s'" % a if isinstance(a, str) else number(a) for a in arguments))
    return text


def inverse_calls(calls):
    out = []
    for name, a in reversed(calls):
        out.append((name, (a[0], -a[1]) if name == "rotate" else [-x for x in a] if name == "translate" else [1 / x for x in a]))
    return out


def turn(rng):
    return ("rotate", (rng.choice("xyz"), rng.uniform(-180, 180)))


def camera_lua(name, size, eye, view, up, fov, ambient, lights):
    return "gr.render(root, '%s.pfm', %d, %d, %s, %s, %s, %s, %s, {%s})\n" % (
        name, size[0], size[1], triple(eye), triple(view), triple(up), number(fov), triple(ambient), ", ".join(lights))


def light_lua(at, colour):
    return "gr.light(%s, %s, {1, 0, 0})" % (triple(at), triple(colour))


def camera_rays(size, view, up, fov):
    """Directions through the middles of the pixels, row by row from the top."""
    forward = unit(view)
    right = unit(cross(forward, unit(up)))
    above = cross(right, forward)
    pixel = 2 * math.tan(math.radians(fov) / 2) / size[1]
    for y in range(size[1]):
        for x in range(size[0]):
            yield add(add(forward, right, (x + 0.5 - size[0] / 2) * pixel), above, -(y + 0.5 - size[1] / 2) * pixel)
