"""H: numbers while rendering."""
import os

from harness import BALL, Case, ROOT, SHOT, shot


def scaled(factor):
    """A lit ball on a floor, all of it `factor` large."""
    return (ROOT + "local k = %s\nlocal s = gr.nh_sphere('s', {0,0,0}, k) root:add_child(s, white)\n"
            "root:add_child(gr.nh_box('f', {-5 * k, -2 * k, -5 * k}, {10 * k, k, 10 * k}), white)\n"
            "gr.render(root, 'x.png', 24, 18, {0,k,5*k}, {0,-0.2,-1}, {0,1,0}, 50, {0.3,0.3,0.3}, {gr.light({3*k,5*k,9*k}, {0.7,0.7,0.7}, {1,0,0})})" % factor)


def two_scales(project, folder):
    """The same picture in units a million times larger."""
    for name, factor in (("small.lua", "2^-20"), ("large.lua", "2^20")):
        with open("%s/%s" % (folder, name), "w") as f:
            f.write(scaled(factor))
    return ["sh", "-c", "'%s' small.lua -q --spp 4 -o small.png && '%s' large.lua -q --spp 4 -o x.png && '%s' compare small.png x.png --tolerance 0.001"
            % (project, project, project)]


def fine(ids, name, script, says=(), never=("error", "finite"), **more):
    return Case(ids, name, script, says=says, never=never, writes="x.png", **more)


MIRRORS = shot("for _, x in ipairs{-3, 2} do local b = gr.nh_box('b', {x, -9, -9}, {1, 18, 18}) b:set_reflection(0) root:add_child(b, white) end "
               "for _, z in ipairs{-9, 8} do local b = gr.nh_box('b', {-9, -9, z}, {18, 18, 1}) b:set_reflection(0) root:add_child(b, white) end")
SOFT = BALL.replace("8, 6", "40, 30").replace("{1,0,0})", "{1,0,0}, 1)")
TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CASES = [
    *[fine("H1", "a radiance of %s, towards an error" % value, SOFT.replace("{0.7,0.7,0.7}", "{%s,0.7,0.7}" % value), (), ("nan", "error", "finite"),
           args=("scene.lua", "-q", "--error", "0.003")) for value in ("1e39", "1e160", "1e300")],
    fine("H1", "a radiance that is no number", BALL.replace("{0.7,0.7,0.7}, {1,0,0}", "{1e308,1e308,1e308}, {1e-300,0,0}"), r"warning: .*not finite.*\d+,\d+", ()),
    Case("H2", "units of 2^-20 and 2^20", "", command=two_scales, prints="RMSE", writes="x.png"),
    fine("H3", "the eye in a ball", shot("root:add_child(gr.nh_sphere('s', {0,0,0}, 9), white)")),
    fine("H3", "the eye in a mesh of glass", shot("local m = gr.nh_box('m', {-9,-9,-9}, 18) m:set_refraction(1.5, 0) root:add_child(m, white)")),
    fine("H4", "along a box's faces", shot("root:add_child(gr.nh_box('b', {0,0,-1}, {1,1,9}), white) root:add_child(gr.nh_box('b', {-1,-1,5}, {2,2,1}), white)")),
    fine("H5", "a hall of mirrors", MIRRORS),
    fine("H5", "a hall of mirrors of any depth", MIRRORS, args=("scene.lua", "-q", "--spp", "1", "--max-depth", "1000000", "--cutoff", "0")),
    fine("H6", "glass at every angle", shot("local s = gr.sphere('s') s:set_refraction(1.5, 0) s:set_fresnel(true) root:add_child(s, white) "
         "local c = gr.nh_box('c', {-2,-2,-2}, 4) c:set_refraction(0.5, 0) root:add_child(c, white)"), args=("scene.lua", "-q", "--spp", "16")),
    fine("H7", "a shininess without end", shot("root:add_child(gr.sphere('s'), gr.material({0,0,0}, {1e6,1e6,1e6}, 1e9))")),
    Case("H8", "a million samples", BALL.replace("8, 6", "1, 1"), ("scene.lua", "-q", "--spp", "1000000"), writes="x.png", seconds=60),
    *[fine("H9", "torus " + radii, shot("root:add_child(gr.torus('t', %s), white)" % radii)) for radii in ("1, 1", "1, 1e-9", "1e-9, 1", "1, 5", "1e6, 1")],
    *[fine("H10", "coincident faces: " + name, shot("local a, b = gr.cube('a'), gr.cube('b') root:add_child(%s, white)" % solid), (), ("nan", "error", "finite"))
      for name, solid in (("a union", "gr.union('u', a, b)"), ("an intersection", "gr.intersection('i', a, b)"),
                          ("a difference", "gr.difference('d', a, gr.nh_box('c', {0,0,0}, {1,1,0.5}))"),
                          ("nothing left", "gr.difference('d', a, b)"))],
    fine("H10", "nothing in common", shot("root:add_child(gr.intersection('i', gr.cube('a'), gr.nh_sphere('b', {9,9,9}, 1)), white)"), r"scene\.lua:2: warning: .*'i' is empty"),
    *[Case("H10", "a part that bounds no solid: " + what, shot("local p = %s root:add_child(gr.difference('cut', gr.sphere('s'), p), white)" % part), code=1,
           says=r"scene\.lua:2: error: gr\.difference: 'cut' cannot use 'p'.* %s, which bounds no solid" % what)
      for what, part in (("an open mesh", "gr.mesh('p', {{0,0,0}, {1,0,0}, {0,1,0}}, {{0,1,2}})"), ("a plane", "gr.plane('p')"),
                         ("a disc", "gr.disc('p')"), ("a quad", "gr.quad('p')"))],
    Case("H10", "a solid of itself", shot("local g = gr.node('g') local u = gr.union('u', gr.sphere('s'), g) g:add_child(u) root:add_child(u, white)"), code=1,
         says=r"scene\.lua:2: error: gr\.add_child: cycle: u -> g -> u"),
    Case("H10", "2^40 parts", shot("local g = gr.sphere('s') for i = 1, 40 do g = gr.union('u', g, g) end root:add_child(g, white)"), code=4,
         says="combines more than 65536 nodes", never="finite"),
    Case("H10", "100,000 solids within solids", shot("local g = gr.sphere('s') local c = gr.cube('c') for i = 1, 100000 do g = gr.difference('u', g, c) end root:add_child(g, white)"), code=4,
         says="1000 deep", never="finite"),
    Case("H12", "a compiler that is told to take numbers lightly", "", code=1, says="error: .*fast",
         command=lambda project, folder: ["g++", "-std=c++20", "-ffast-math", "-fsyntax-only", "-x", "c++",
                                          os.path.join(TOP, "include/rt/core/numeric.h")]),
]
