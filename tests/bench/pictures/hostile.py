"""Scenes made to deceive an error estimate: detail that few samples meet, or that all of them meet alike.

Each function returns a script; what the script reads is written into `folder`.
"""
import os, random
import numpy as np
from . import assets

SUN = "{gr.light({8, 12, 9}, {0.9, 0.9, 0.9}, {1, 0, 0}%s)}"
SOFT = SUN % ", 1.2"
POINT = SUN % ""


def shot(lines, lights=POINT, eye="{0, 3, 10}", view="{0, -0.25, -1}", fovy=34, ambient=0.15):
    return "\n".join(["gr.options{max_depth = 5}", "gr.background({0.1, 0.15, 0.25})", "local root = gr.node('root')",
                      "local grey = gr.material({0.56, 0.56, 0.56}, {0, 0, 0}, 1)", *lines,
                      "gr.render(root, 'hostile.png', 640, 360, %s, %s, {0, 1, 0}, %g, {%g, %g, %g}, %s)" % (
                          eye, view, fovy, ambient, ambient, ambient, lights)]) + "\n"


FLOOR = "root:add_child(gr.nh_box('floor', {-60, -1, -60}, {120, 1, 120}), grey)"


def rods(_):
    """rods of a fifth to half a pixel at 160x90, dark and bright, in all directions"""
    rng = random.Random(5)
    lines = [FLOOR, "local dark = gr.material({0.02, 0.02, 0.02}, {0, 0, 0}, 1)",
             "local bright = gr.material({0.9, 0.8, 0.3}, {0.3, 0.3, 0.3}, 40)"]
    for i in range(60):
        lines.append("do local n = gr.nh_cylinder('rod', {0, 0, 0}, %.4f, %.4f); n:rotate('x', %.2f); n:rotate('y', %.2f); "
                     "n:translate(%.4f, %.4f, %.4f); root:add_child(n, %s) end" % (
                         rng.uniform(2, 6), rng.uniform(0.006, 0.016), rng.uniform(-40, 40), rng.uniform(0, 180),
                         rng.uniform(-5, 5), rng.uniform(0, 1), rng.uniform(-6, 4), rng.choice(["dark", "bright"])))
    return shot(lines, SOFT)


def highlights(_):
    """small shiny balls with exponents from 500 to 5000: highlights far below a pixel"""
    rng = random.Random(6)
    lines = [FLOOR]
    for i in range(150):
        r = rng.uniform(0.05, 0.35)
        lines.append("root:add_child(gr.nh_sphere('ball', {%.4f, %.4f, %.4f}, %.4f), gr.material({0.1, 0.1, 0.12}, "
                     "{0.9, 0.9, 0.9}, %.0f))" % (rng.uniform(-5, 5), r, rng.uniform(-8, 5), r,
                                                  10 ** rng.uniform(2.7, 3.7)))
    return shot(lines, POINT)


def checker(folder):
    """a textured plane to the horizon"""
    assets.checker_texture(os.path.join(folder, "checker.png"))
    assets.rectangle(os.path.join(folder, "plane.obj"), (-2000, -2000), (2000, 2000), 0.0, 4.0)
    return shot(["root:add_child(gr.mesh('plane', 'plane.obj'), grey, gr.texture('checker.png', {0, 0, 0}, 1))",
                 "root:add_child(gr.nh_sphere('ball', {0, 1, 0}, 1), grey)"], SOFT, view="{0, -0.12, -1}")


def boxes(_):
    """a floor of 80 x 80 boxes, dark and bright by turns"""
    return shot(["local dark = gr.material({0.03, 0.03, 0.03}, {0, 0, 0}, 1)",
                 "local bright = gr.material({0.9, 0.9, 0.9}, {0, 0, 0}, 1)",
                 "for i = 0, 79 do for j = 0, 79 do",
                 "  root:add_child(gr.nh_box('b', {-20 + i / 2, -1, -34 + j / 2}, {0.5, 1 + 0.1 * ((i + j) % 2), 0.5}),",
                 "                 (i + j) % 2 == 0 and dark or bright)", "end end"], POINT, view="{0, -0.2, -1}")


def far_tori(_):
    """tori of a few pixels, some with a tube far below one, high above a floor"""
    rng = random.Random(8)
    lines = [FLOOR]
    for i in range(120):
        big = rng.uniform(0.08, 0.3)
        lines.append("do local n = gr.nh_torus('t', {0, 0, 0}, %.4f, %.4f); n:rotate('x', %.2f); n:rotate('y', %.2f); "
                     "n:translate(%.4f, %.4f, %.4f); root:add_child(n, gr.material({%.3f, %.3f, 0.2}, {0.5, 0.5, 0.5}, 80)) "
                     "end" % (big, big * rng.uniform(0.03, 0.3), rng.uniform(0, 180), rng.uniform(0, 180),
                              rng.uniform(-7, 7), rng.uniform(0.2, 4), rng.uniform(-14, -4), rng.uniform(0.2, 0.9),
                              rng.uniform(0.2, 0.9)))
    return shot(lines, SOFT)


def foliage(folder):
    """twenty thousand loose triangles of about a pixel, and their shadow"""
    rng = np.random.default_rng(9)
    count = 20000
    direction = rng.normal(size=(count, 3))
    center = direction / np.linalg.norm(direction, axis=1, keepdims=True) * 1.8 * rng.random((count, 1)) ** (1 / 3)
    corners = center[:, None, :] + rng.normal(scale=0.035, size=(count, 3, 3))
    with open(os.path.join(folder, "leaves.obj"), "w") as f:
        f.write(assets.rows("v %.5f %.5f %.5f", corners.reshape(-1, 3), "\n") + "\n")
        f.write(assets.rows("f %d %d %d", 1 + np.arange(3 * count).reshape(-1, 3), "\n") + "\n")
    return shot([FLOOR, "local tree = gr.mesh('tree', 'leaves.obj', {smooth = false})", "tree:translate(0, 2.2, 0)",
                 "root:add_child(tree, gr.material({0.2, 0.5, 0.15}, {0.1, 0.1, 0.1}, 20))"], SOFT)


def fence(_):
    """pickets to the horizon, and their shadows from a point light behind them"""
    return shot([FLOOR, "local wood = gr.material({0.6, 0.4, 0.25}, {0, 0, 0}, 1)",
                 "for row = 0, 3 do for i = -60, 60 do",
                 "  root:add_child(gr.nh_box('p', {i * 0.14, 0, 2 - 5 * row}, {0.05, 0.9, 0.03}), wood)", "end",
                 "root:add_child(gr.nh_box('r', {-9, 0.6, 2.03 - 5 * row}, {18, 0.05, 0.02}), wood)", "end"],
                "{gr.light({-6, 5, -24}, {0.9, 0.9, 0.9}, {1, 0, 0})}")


def mirror_grid(_):
    """mirrors that show a grid of thin bars, which the camera itself hardly sees"""
    return shot([FLOOR, "local bar = gr.material({0.9, 0.85, 0.7}, {0, 0, 0}, 1)",
                 "for i = -40, 40 do",
                 "  root:add_child(gr.nh_box('v', {i * 0.5, 0, 14}, {0.06, 16, 0.06}), bar)",
                 "  if i >= 0 then root:add_child(gr.nh_box('h', {-20, i * 0.4, 14}, {40, 0.05, 0.06}), bar) end", "end",
                 "local flat = gr.nh_box('flat', {-4, 0.1, -4}, {4, 3, 0.1}); flat:set_reflection(0.1)",
                 "root:add_child(flat, grey)",
                 "local ball = gr.nh_sphere('ball', {2, 1.2, 0}, 1.2); ball:set_reflection(0.1)",
                 "root:add_child(ball, grey)"], POINT)


def holes(_):
    """a small bright light behind a lattice with small holes: bright spots on a dark floor"""
    return shot([FLOOR, "local plate = gr.material({0.3, 0.3, 0.3}, {0, 0, 0}, 1)",
                 "for i = -30, 30 do",
                 "  root:add_child(gr.nh_box('x', {i * 0.3, 4.0, -9}, {0.285, 0.01, 18}), plate)",
                 "  root:add_child(gr.nh_box('z', {-9, 4.02, i * 0.3}, {18, 0.01, 0.285}), plate)", "end"],
                "{gr.light({0.1, 9, -1.3}, {2.5, 2.4, 2.2}, {1, 0, 0}, 0.03)}", eye="{0, 2.5, 10}",
                view="{0, -0.22, -1}", ambient=0.05)


def shells(_):
    """what is left of combined solids, most of it thinner than a pixel: cut shells, lenses, fins, slots, tubes"""
    rng = random.Random(9)
    ball, box, rod = ("gr.nh_%s('p', {%%g, %%g, %%g}, %s)" % kind for kind in
                      (("sphere", "%g"), ("box", "{%g, %g, %g}"), ("cylinder", "%g, %g")))
    lines = [FLOOR, "local pale = gr.material({0.9, 0.85, 0.7}, {0.2, 0.2, 0.2}, 50)",
             "local red = gr.material({0.8, 0.3, 0.2}, {0.3, 0.3, 0.3}, 20)"]
    for i in range(45):
        thin = 0.004 * 2 ** rng.uniform(0, 4)
        call, parts = (
            ("difference", [ball % (0, 0, 0, 0.8), ball % (0, 0, 0, 0.8 - thin), box % (-2, 0.1, -2, 4, 4, 4)]),
            ("intersection", [ball % (0, 0, 3, 3 + thin), ball % (0, 0, -3, 3 + thin)]),
            ("intersection", [box % (-1, -0.5, 0, 2, 1, 2), box % (-1, -0.8, thin - 2, 2, 1.6, 2)]),
            ("difference", [box % (-0.6, -0.6, -0.6, 1.2, 1.2, 1.2), box % (-0.3, -1, -1, 2 * thin, 2, 2),
                            ball % (0.2, 0.1, 1.595, 1), rod % (0.2, -1, 0.2, 3, thin)]),
            ("difference", [rod % (0, -0.8, 0, 1.6, 0.5), rod % (0, -1, 0, 2, 0.5 - thin)]))[i % 5]
        lines.append("do local n = gr.%s('n', %s); n:rotate('x', %.2f); n:rotate('z', %.2f); n:translate(%.2f, 1, %.2f); "
                     "root:add_child(n, %s) end" % (call, ", ".join(parts), rng.uniform(0, 360), rng.uniform(0, 360),
                                                    1.6 * (i % 9 - 4), 3 - 1.8 * (i // 9), rng.choice(["pale", "red"])))
    return shot(lines, SOFT)


SCENES = {f.__name__: f for f in (rods, highlights, checker, boxes, far_tori, foliage, fence, mirror_grid, holes,
                                  shells)}
