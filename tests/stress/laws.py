"""Laws that pictures obey at any scale, place and map, tried with random scenes.

Every law gets a random generator, a Studio and a Report. u = 2^-53. Tolerances: pictures hold floats, whose rounding
is FLOAT of a value up to 1; what moves by k u of its size (k: how often its size fits into its coordinates, or the
condition of its map) changes colour by STEEP k u at most, STEEP being what a highlight of exponent 20 on a tube of a
quarter's radius makes of it where the surface is seen at 1 : 10. Pixels beyond are counted as silhouettes: there a
rounding decides what is seen. More of them than HANDFUL in a picture is a failure.
"""
import math
from fractions import Fraction

from picture import difference
from solids import *

U = 2.0 ** -53
FLOAT = 2.0 ** -22
STEEP = 4096.0
HANDFUL = 4
SIZE = (48, 36)
MATERIAL = "gr.material({0.7, 0.5, 0.3}, {0.4, 0.4, 0.4}, 20)"
MATT = "gr.material({1, 0.5, 0.25}, {0, 0, 0}, 0)"
BLACK = [0.0, 0.0, 0.0]


def tolerance(k):
    return FLOAT + STEEP * U * k


def hold(report, group, name, got, expected, limit, repeat, handful=HANDFUL):
    """Pixels of `got` are within `limit` of `expected`, relative to values above 1, but for a handful."""
    worst, odd = 0.0, 0
    for a, b in zip(got, expected):
        off = difference(a, b) / max(1.0, max(b))
        if off <= limit:
            worst = max(worst, off)
        else:
            odd += 1
    report.law(group, name, len(got), min(odd, handful), worst, limit, bad=odd if odd > handful else 0, repeat=repeat)


class View:
    """A camera and a light around a unit scene."""

    def __init__(self, rng):
        d = random_unit(rng)
        d[1] = abs(d[1])
        self.eye = [rng.uniform(3.5, 5) * x for x in d]
        self.view = add([rng.uniform(-.3, .3) for _ in range(3)], self.eye, -1.0)
        self.up = unit(add([0, 1, 0], random_unit(rng), 0.3))
        self.light = [rng.uniform(3, 8) * x for x in random_unit(rng)]
        self.light[1] = abs(self.light[1]) + 0.5

    def lua(self, name, scale=1.0, offset=(0.0, 0.0, 0.0)):
        at = lambda v: [o + scale * x for o, x in zip(offset, v)]
        return camera_lua(name, SIZE, at(self.eye), self.view, self.up, 35, [0.1, 0.1, 0.1],
                          [light_lua(at(self.light), [0.9, 0.9, 0.9])])


def floor_lua(scale=1.0, offset=(0.0, 0.0, 0.0)):
    at = [o + scale * x for o, x in zip(offset, [-3.0, -2.0, -3.0])]
    return "gr.nh_box('floor', %s, %s)" % (triple(at), triple([6 * scale, scale, 6 * scale]))


def scene_lua(solid_lua, floor, after=""):
    return ("root = gr.node('root')\nroot:add_child(%s, %s)\n" % (solid_lua, MATERIAL)
            + "root:add_child(%s, gr.material({0.4, 0.4, 0.4}, {0, 0, 0}, 0))\n%s" % (floor, after))


def scales_and_places(kind, rng, studio, report, repeat):
    """A scene's picture does not change when all is made larger, smaller, or moved far away."""
    solid, view = Solid(kind, rng), View(rng)
    script = scene_lua(solid.lua(), floor_lua()) + view.lua("unit")
    cases = [("scale %g" % s, s, 0.0) for s in (1e-6, 1e-3, 1e3, 1e6)]
    cases += [("%g sizes away" % d, 10 ** rng.uniform(-6, 6) if rng.random() < .5 else 1.0, d) for d in (1e3, 1e6, 1e9)]
    cases += [("scale 2^%d" % e, 2.0 ** e, 0.0) for e in (-20, 20)]
    for i, (_, scale, away) in enumerate(cases):
        offset = [scale * away * x for x in random_unit(rng)]
        if rng.random() < 0.5:
            script += scene_lua(solid.lua(scale, offset), floor_lua(scale, offset))
        else:
            calls = [("scale", [scale] * 3), ("translate", offset)]
            script += scene_lua(solid.lua(), floor_lua(), calls_lua("root", calls))
        script += view.lua("case%d" % i, scale, offset)
    unit_picture, *pictures = studio.shoot(script, ["unit"] + ["case%d" % i for i in range(len(cases))])
    for (name, _, away), picture in zip(cases, pictures):
        if name.startswith("scale 2^"):
            bad = sum(a != b for a, b in zip(picture.pixels, unit_picture.pixels))
            report.law(kind, name + ": same bits", len(picture.pixels), 0, bad=bad, repeat=repeat)
        else:
            hold(report, kind, name, picture.pixels, unit_picture.pixels, tolerance(1 + away), repeat)


def maps_that_cancel(kind, rng, studio, report, repeat):
    """What is mapped there and back through the graph is seen as if it had never been away."""
    solid, view = Solid(kind, rng), View(rng)
    stretch = lambda reach: [rng.choice((-1, 1)) * 10 ** rng.uniform(-reach, reach) for _ in range(3)]
    chains = [("scales 1e-6..1e6, mirrored", [("scale", stretch(6))], 1.0),
              ("sheared by 1e3", [turn(rng), ("scale", stretch(1.5)), turn(rng)], 1e3),
              ("sheared by 1e6", [turn(rng), ("scale", stretch(3)), turn(rng)], 1e6)]
    script = scene_lua(solid.lua(), floor_lua()) + view.lua("unit")
    for i, (_, chain, _) in enumerate(chains):
        script += scene_lua("inner", floor_lua(), calls_lua("inner", chain + inverse_calls(chain))).replace(
            "root = ", "inner = %s\nroot = " % solid.lua(), 1) + view.lua("case%d" % i)
    mirrored = solid.lua(mirror=True)
    script += "inner = %s\ninner:scale(-1, 1, 1)\n" % mirrored + scene_lua("inner", floor_lua()) + view.lua("mirrored")
    unit_picture, *pictures = studio.shoot(script, ["unit"] + ["case%d" % i for i in range(len(chains))] + ["mirrored"])
    for (name, _, k), picture in zip(chains + [("mirrored", None, 1.0)], pictures):
        hold(report, kind, name, picture.pixels, unit_picture.pixels, tolerance(k), repeat)


def coincident(kind, rng, studio, report, repeat):
    """Of two that coincide up to rounding, the first is seen, without a speck of the other."""
    solid, view = Solid(kind, rng), View(rng)
    turns = [turn(rng), turn(rng)]
    away = [rng.uniform(-5, 5) for _ in range(3)]
    there_and_back = turns + inverse_calls(turns) + [("translate", away), ("translate", [-x for x in away])]
    twin = "twin = %s\n" % solid.lua() + calls_lua("twin", there_and_back) + "root:add_child(twin, gr.material({0, 0, 1}, {0, 0, 0}, 0))\n"
    script = scene_lua(solid.lua(), floor_lua()) + view.lua("alone") + twin + view.lua("both")
    alone, both = studio.shoot(script, ["alone", "both"])
    hold(report, kind, "coincident: the first is seen", both.pixels, alone.pixels, tolerance(10), repeat)


def random_map(rng, stretch=True):
    calls = [("scale", [rng.choice((-1, 1)) * 10 ** rng.uniform(-1, 1) for _ in range(3)])] if stretch else []
    calls += [turn(rng), turn(rng)]
    if stretch and rng.random() < 0.5:
        calls += [("scale", [10 ** rng.uniform(-1, 1) for _ in range(3)]), turn(rng)]
    size = 10 ** rng.uniform(-6, 6)
    return calls + [("scale", [size] * 3), ("translate", [size * rng.choice((0, 10, 1e3)) * x for x in random_unit(rng)])]


def closed_is_dark(kind, rng, studio, report, repeat):
    """No light comes into a closed solid, nor out of it: not one pixel."""
    solid = Solid(kind, rng)
    calls = random_map(rng)
    matrix = matrix_of(calls)
    inside = mapped(matrix, solid.inside())
    outside = [mapped(matrix, [rng.uniform(2, 30) * x for x in random_unit(rng)]) for _ in range(4)]
    make = "root = gr.node('root')\nroot:add_child(%s, %s)\n" % (solid.lua(), MATERIAL) + calls_lua("root", calls)
    lights = [light_lua(p, [1e6, 1e6, 1e6]) for p in outside]
    script = make + camera_lua("inside", SIZE, inside, random_unit(rng), random_unit(rng), 120, BLACK, lights)
    script += camera_lua("outside", SIZE, outside[0], add(inside, outside[0], -1.0), random_unit(rng), 40, BLACK,
                         [light_lua(inside, [1e6, 1e6, 1e6])])
    for picture, name in zip(studio.shoot(script, ["inside", "outside"]), ["dark inside", "dark outside, lit inside"]):
        bad = sum(difference(p, BLACK) != 0.0 for p in picture.pixels)
        report.law(kind, name, len(picture.pixels), 0, bad=bad, repeat=repeat)


def furnace(kind, rng, studio, report, repeat):
    """In white light a white body cannot be seen, whatever it does with the light."""
    solid, view = Solid(kind, rng), View(rng)
    calls = random_map(rng)
    matrix = matrix_of(calls)
    eye = mapped(matrix, view.eye)
    look = mapped(matrix, view.view, vector=True)
    shot = lambda name, ambient: camera_lua(name, SIZE, eye, look, view.up, 40, ambient, [])
    white = "gr.background({1, 1, 1})\nroot = gr.node('root')\nbody = %s\n" % solid.lua()
    f = rng.random()
    body = "body:set_reflection(%s)\n" % number(f) if rng.random() < .3 else (
        "body:set_refraction(%s, %s)\nbody:set_fresnel(%s)\n" % (number(rng.uniform(1, 2.5)), number(f),
                                                                 rng.choice(("true", "false"))))
    moved = "root:add_child(body, gr.material({1, 1, 1}, {0, 0, 0}, 0))\n" + calls_lua("root", calls)
    (picture,) = studio.shoot(white + body + moved + shot("white", [1, 1, 1]), ["white"])
    hold(report, kind, "white furnace", picture.pixels, [[1, 1, 1]] * len(picture.pixels), FLOAT, repeat, handful=0)
    if kind in CONVEX:
        # A mirror image of itself would be black.
        mirror = "body:set_reflection(0)\nroot:add_child(body, gr.material({0, 0, 0}, {0, 0, 0}, 0))\n"
        script = white + mirror + calls_lua("root", calls) + shot("mirror", BLACK)
        (picture,) = studio.shoot(script, ["mirror"], "--max-depth", "1")
        hold(report, kind, "mirror without acne", picture.pixels, [[1, 1, 1]] * len(picture.pixels), FLOAT, repeat, handful=0)
        air = "body:set_refraction(1, 0)\nroot:add_child(body, gr.material({0, 0, 0}, {0, 0, 0}, 0))\n"
        script = white + air + calls_lua("root", calls) + shot("air", BLACK)
        (picture,) = studio.shoot(script, ["air"], "--max-depth", "2")
        hold(report, kind, "entered once, left once", picture.pixels, [[1, 1, 1]] * len(picture.pixels), FLOAT, repeat)


def thin_sheet(rng, studio, report, repeat):
    """A sheet of 1e-3 to 1e-9 of its size is lit on its upper side alone."""
    thickness = 10 ** rng.uniform(-9, -3)
    calls = random_map(rng, stretch=False)
    matrix = matrix_of(calls)
    size = calls[-2][1][0]
    away = math.sqrt(dot(calls[-1][1], calls[-1][1])) / size
    light = [rng.uniform(-20, 20), rng.uniform(0.5, 20), rng.uniform(-20, 20)]
    eye, view, up = [rng.uniform(-5, 5), rng.uniform(2, 8), rng.uniform(-5, 5)], random_unit(rng), random_unit(rng)
    view = [0.5 * view[0], -1.0, 0.5 * view[2]]
    sheet = "gr.nh_box('sheet', %s, %s)" % (triple([-50, -thickness, -50]), triple([100, thickness, 100]))
    script = "root = gr.node('root')\nroot:add_child(%s, %s)\n" % (sheet, MATT)
    script += "root:add_child(gr.nh_box('below', {-60, -31, -60}, {120, 1, 120}), %s)\n" % MATT + calls_lua("root", calls)
    lights = [light_lua(mapped(matrix, light), [1, 1, 1])]
    at = lambda v: mapped(matrix, v)
    way = lambda v: mapped(matrix, v, vector=True)
    script += camera_lua("above", SIZE, at(eye), way(view), way(up), 40, BLACK, lights)
    script += camera_lua("below", SIZE, at([eye[0], -eye[1], eye[2]]), way(random_unit(rng)), way(up), 90, BLACK, lights)
    above, below = studio.shoot(script, ["above", "below"])
    expected = []
    for d in camera_rays(SIZE, view, up, 40):
        point = add(eye, d, -eye[1] / d[1])
        to = add(light, point, -1.0)
        cosine = to[1] / math.sqrt(dot(to, to))
        expected.append([cosine, 0.5 * cosine, 0.25 * cosine])
    hold(report, "sheet", "lit above, no acne", above.pixels, expected, tolerance(100 + away), repeat, handful=0)
    bad = sum(difference(p, BLACK) != 0.0 for p in below.pixels)
    report.law("sheet", "dark below, no leak", len(below.pixels), 0, bad=bad, repeat=repeat)


def resting_sphere(rng, studio, report, repeat):
    """A sphere that touches a box in one point, in light as low as 1e-6: Lambert and one shadow, on paper."""
    radius, lowness = rng.uniform(.5, 2), 10 ** rng.uniform(-6, -0.3)
    calls = random_map(rng, stretch=False)
    matrix = matrix_of(calls)
    away = math.sqrt(dot(calls[-1][1], calls[-1][1])) / calls[-2][1][0]
    turn_angle, far = rng.uniform(0, 2 * math.pi), rng.uniform(10, 40)
    light = [far * math.cos(turn_angle), far * lowness, far * math.sin(turn_angle)]
    centre = [0.0, radius, 0.0]
    heading = random_unit(rng)
    while 7 * math.hypot(heading[0], heading[2]) <= radius:    # the eye would be in the sphere, or above its top
        heading = random_unit(rng)
    eye = [7 * heading[0], rng.uniform(1, 6), 7 * heading[2]]
    view, up, fov = add([0, radius / 2, 0], eye, -1.0), [0.0, 1.0, 0.0], 35
    script = "root = gr.node('root')\nroot:add_child(gr.nh_sphere('s', %s, %s), %s)\n" % (triple(centre), number(radius), MATT)
    script += "root:add_child(gr.nh_box('floor', {-100, -1, -100}, {200, 1, 200}), %s)\n" % MATT + calls_lua("root", calls)
    script += camera_lua("rest", SIZE, mapped(matrix, eye), mapped(matrix, view, vector=True),
                         mapped(matrix, up, vector=True), fov, BLACK, [light_lua(mapped(matrix, light), [1 / lowness] * 3)])
    (picture,) = studio.shoot(script, ["rest"])
    expected = [resting_pixel(eye, d, centre, radius, light, lowness) for d in camera_rays(SIZE, view, up, fov)]
    # The light's height, a part `lowness` of its distance, is what the coordinates have to resolve.
    hold(report, "resting", "sphere on a box, low light", picture.pixels, expected,
         tolerance((100 + away) / lowness), repeat)


def sphere_hit(o, d, centre, radius):
    q = add(o, centre, -1.0)
    b, a = dot(q, d), dot(d, d)
    foot = add(q, d, -b / a)
    inside = radius * radius - dot(foot, foot)
    return None if inside <= 0 else -b / a - math.sqrt(inside / a)


def resting_pixel(eye, d, centre, radius, light, lowness):
    t_floor = -eye[1] / d[1] if d[1] < 0 else math.inf
    t_sphere = sphere_hit(eye, d, centre, radius)
    if t_sphere is not None and t_sphere < t_floor:
        point = add(eye, d, t_sphere)
        normal = unit(add(point, centre, -1.0))
        to = add(light, point, -1.0)
        value = max(0.0, dot(normal, to) / math.sqrt(dot(to, to)) / lowness)
    else:
        point = add(eye, d, t_floor)
        if not math.isfinite(t_floor) or max(abs(point[0]), abs(point[2])) > 100:
            return BLACK
        point[1] = 0.0
        to = add(light, point, -1.0)
        shadowed = sphere_hit(point, to, centre, radius)
        value = 0.0 if shadowed is not None and 0 < shadowed < 1 else to[1] / math.sqrt(dot(to, to)) / lowness
    return [value, 0.5 * value, 0.25 * value]


def exact_inverse(columns):
    c = [[Fraction(x) for x in column] for column in columns]
    rows = [cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1])]
    determinant = dot(c[0], rows[0])
    return [[x / determinant for x in row] for row in rows]


def ellipsoid(rng, studio, report, repeat):
    """Sphere, scaled by 1e-6 to 1e6 with a ratio up to 1e6, lit from the eye: hits and normals in rational numbers."""
    size = (16, 12)
    base = rng.uniform(-6, 0)
    calls = [("scale", [rng.choice((-1, 1)) * 10 ** (base + rng.uniform(0, 6)) for _ in range(3)]), turn(rng), turn(rng)]
    columns, _ = matrix_of(calls)
    inverse = exact_inverse(columns)
    back = lambda v: [dot(row, [Fraction(x) for x in v]) for row in inverse]
    unseen = [rng.uniform(1.5, 4) * x for x in random_unit(rng)]
    eye = mapped((columns, [0, 0, 0]), unseen)
    view = mapped((columns, [0, 0, 0]), add([0.5 * x for x in random_unit(rng)], unseen, -1.0))
    distance, up = math.sqrt(dot(view, view)), random_unit(rng)
    right = unit(cross(unit(view), up))
    spread = max(math.sqrt(float(dot(q, q))) for q in (back(right), back(cross(right, unit(view)))))
    fov = math.degrees(min(1.0, 1.5 / (spread * distance)))
    script = "root = gr.node('root')\ns = gr.sphere('s')\n%sroot:add_child(s, %s)\n" % (calls_lua("s", calls), MATT)
    script += camera_lua("ellipsoid", size, eye, view, up, fov, BLACK, [light_lua(eye, [1, 1, 1])])
    (picture,) = studio.shoot(script, ["ellipsoid"])
    o = back(eye)
    expected = []
    for direction in camera_rays(size, view, up, fov):
        d = back(direction)
        a, b, c = dot(d, d), dot(o, d), dot(o, o) - 1
        inside = b * b - a * c
        if inside <= 0:
            expected.append(BLACK)
            continue
        t = Fraction((float(-b) - math.sqrt(inside)) / float(a))
        point = [float(x) for x in add(o, d, t)]
        normal = unit([float(sum(inverse[k][i] * Fraction(point[k]) for k in range(3))) for i in range(3)])
        cosine = max(0.0, -dot(normal, unit(direction)))
        expected.append([cosine, 0.5 * cosine, 0.25 * cosine])
    hold(report, "ellipsoid", "scales 1e-6..1e6, exact", picture.pixels, expected, tolerance(1e7), repeat)


OF_SOLIDS = [scales_and_places, maps_that_cancel, coincident, closed_is_dark, furnace]
OF_SCENES = [thin_sheet, resting_sphere, ellipsoid]


def all_laws():
    """(name, function of rng, studio, report, repeat)"""
    for law in OF_SCENES:
        yield law.__name__, law
    for law in OF_SOLIDS:
        for kind in KINDS:
            yield law.__name__ + "/" + kind, lambda *rest, l=law, k=kind: l(k, *rest)
