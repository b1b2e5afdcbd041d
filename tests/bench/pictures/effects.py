"""One effect at a time, for slopes.py: scripts in which one pair of a sample's dimensions carries the error."""
import os
from . import assets

HEAD = """gr.background({0.1, 0.15, 0.25}, {0.5, 0.6, 0.8})
local root = gr.node('root')
local grey = gr.material({0.6, 0.6, 0.6}, {0, 0, 0}, 1)
local red = gr.material({0.8, 0.25, 0.2}, {0, 0, 0}, 1)
local blue = gr.material({0.2, 0.35, 0.8}, {0, 0, 0}, 1)
local gold = gr.material({0.8, 0.6, 0.2}, {0, 0, 0}, 1)
"""
AMBIENT = "{1, 1, 1}, {}"
SOFT = "{0.2, 0.2, 0.2}, {gr.light({4, 8, 5}, {0.9, 0.9, 0.9}, {1, 0, 0}, 1.5)}"
BALLS = """for i = 0, 24 do
  root:add_child(gr.nh_sphere('ball', {1.3 * (i % 5 - 2), 0.5 + 0.2 * math.sin(i), -1.3 * (i // 5)}, 0.45),
                 ({red, blue, gold})[i % 3 + 1])
end
"""
FLOOR = "root:add_child(gr.nh_box('floor', {-30, -1, -30}, {60, 1, 60}), grey)\n"
CHECKER = "root:add_child(gr.mesh('plane', 'checks.obj'), grey, gr.texture('checker.png', {0, 0, 0}, 1))\n"
GLASS = """local glass = gr.nh_sphere('glass', {%s}, %s)
glass:set_refraction(1.5, 0)
glass:set_fresnel(true)
root:add_child(glass, grey)
"""


def shot(body, light=AMBIENT, eye="{0, 2.2, 7}", view="{0, -0.3, -1}", fov=34, lens=""):
    return HEAD + body + "gr.render(root, 'effect.png', 640, 360, %s, %s, {0, 1, 0}, %g, %s%s)\n" % (
        eye, view, fov, light, lens)


def checks(folder):
    assets.checker_texture(os.path.join(folder, "checker.png"))
    assets.rectangle(os.path.join(folder, "checks.obj"), (-40, -40), (40, 40), 0.0, 4.0)


def edges(_):
    """flat colours: only what a pixel covers"""
    return shot(BALLS)


def lens(_):
    """the same far out of focus: circles of many pixels"""
    return shot(BALLS, lens=", gr.focal(2.5, 0.05, 0.12)")


def light(_):
    """nothing but a penumbra on a plane; what casts it is out of sight"""
    return shot(FLOOR + "for i = -3, 3 do\n"
                "  root:add_child(gr.nh_box('bar', {i * 2.2, 2.5, -8}, {1.0, 0.1, 16}), grey)\nend\n",
                SOFT, eye="{0, 1.8, 2}", view="{0, -1, -1.2}", fov=30)


def glass(_):
    """a ball of glass with Fresnel's reflection before coloured balls"""
    return shot(BALLS + GLASS % ("0, 1.2, 3", "1.0"), eye="{0, 1.4, 6}", view="{0, -0.06, -1}", fov=38)


def texture(folder):
    """a textured plane, fine in the distance"""
    checks(folder)
    return shot(CHECKER, view="{0, -0.45, -1}")


def everything(folder):
    """pixel, lens, light, glass and texture together"""
    checks(folder)
    return shot(CHECKER + BALLS + GLASS % ("0.4, 0.9, 2.2", "0.7"), SOFT, lens=", gr.focal(6, 0.05, 0.1)")


# name: (script, more options)
EFFECTS = {"pixel edges": (edges, ()), "lens": (lens, ()), "light": (light, ()), "glass": (glass, ()),
           "texture": (texture, ()), "edges, gaussian filter": (edges, ("--filter", "gaussian")),
           "edges, mitchell filter": (edges, ("--filter", "mitchell")), "everything": (everything, ())}
