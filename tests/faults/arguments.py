"""D: arguments of gr.*"""
import os

from harness import BALL, Case, OLD, ROOT, SHOT, shot

CALL = "gr.render(root, %s, %s, %s, {0,0,5}, %s, %s, {0,1,0}, 50, {1,1,1}, {})"


def wrong(ids, name, call, says, code=1, **more):
    """A call on the script's second line that must fail there."""
    return Case(ids, name, ROOT + call, code=code, says=[r"scene\.lua:2: error: ", *([says] if isinstance(says, str) else says)],
                **more)


def fine(ids, name, script, says=(), never="warning", **more):
    return Case(ids, name, script, says=says, never=never if not says else (), writes=more.pop("writes", "x.png"), **more)


def render(file="'x.png'", w="8", h="6", view="{0,0,-1}", up="{0,1,0}", fov="50", eye="{0,0,5}", lights="{}"):
    return "gr.render(root, %s, %s, %s, %s, %s, %s, %s, {1,1,1}, %s)" % (file, w, h, eye, view, up, fov, lights)


def placed(transform):
    return shot("local s = gr.sphere('s') %s root:add_child(s, white)" % transform)


def nothing_outside(run):
    if os.path.exists(os.path.join(os.path.dirname(run.folder), "escaped.png")):
        yield "written outside of the scene's folder"


def differ(run):
    if run.read("x.png") == run.read("y.png"):
        yield "the second render does not see the change"


def same(run):
    if run.read("x.png") != run.read("y.png"):
        yield "the two differ"


BARE = "root:add_child(gr.sphere('bare'))"
CASES = [
    wrong("D1", "too few arguments", "gr.nh_sphere('s')", "nh_sphere.*centre|nh_sphere.*center|nh_sphere.*position|nh_sphere.*#2"),
    fine("D1", "too many, warned of once for each call", shot("for i = 1, 3 do gr.node('n', 1, 2, 3) end root:add_child(gr.sphere('s'), white)"),
         r"scene\.lua:2: warning: gr\.node: .*ignored"),
    wrong("D2", "a word for a number", "gr.nh_sphere('s', {0,0,0}, 'abc')", ["nh_sphere.*radius", "abc|string"]),
    fine("D2", "a numeral for a number", shot("root:add_child(gr.nh_sphere('s', {0,0,0}, '1'), white)")),
    *[wrong("D3", "%s as %s" % (value, what), call % value, "finite") for value in ("0/0", "math.huge", "-math.huge") for what, call in (
        ("radius", "gr.nh_sphere('s', {0,0,0}, %s)"), ("colour", "gr.material({1,%s,1}, {0,0,0}, 1)"),
        ("translation", "gr.node('n'):translate(0, %s, 0)"), ("angle", "gr.node('n'):rotate('x', %s)"),
        ("light", "gr.light({0,0,0}, {1,1,1}, {%s,0,0})"), ("lens", "gr.focal(%s, 0.1, 0.1)"),
        ("vertex", "gr.mesh('m', {{0,0,%s}, {1,0,0}, {0,1,0}}, {{0,1,2}})"),
        ("ambient", "gr.render(root, 'x.png', 8, 6, {0,0,5}, {0,0,-1}, {0,1,0}, 50, {1,1,%s}, {})"))],
    wrong("D4", "tuple too short", "gr.nh_sphere('s', {0,0}, 1)", "nh_sphere"),
    wrong("D4", "tuple with a hole", "gr.nh_sphere('s', {0,nil,0}, 1)", "nh_sphere"),
    fine("D4", "tuple too long", shot("root:add_child(gr.nh_sphere('s', {0,0,0,4}, 1), white)"), "warning: "),
    Case("D4", "tuple behind __index", ROOT + "gr.nh_sphere('s', setmetatable({}, {__index = function(t, k) return k <= 3 and k or nil end}), 1)" + SHOT,
         code={0, 1}),
    Case("D4", "tuple whose __index fails", ROOT + "gr.nh_sphere('s', setmetatable({}, {__index = error}), 1)", code=1, says="error: "),
    wrong("D5", "radius 0", "gr.nh_sphere('s', {0,0,0}, 0)", r"radius must be > 0 \(got 0\)"),
    wrong("D5", "radius -1", "gr.nh_sphere('s', {0,0,0}, -1)", r"radius must be > 0 \(got -1\)"),
    fine("D6", "scale(0,1,1)", placed("s:scale(0,1,1)"), "warning: .*flat"),
    fine("D7", "mirrored", placed("s:scale(-1,1,1)")),
    *[Case("D8", "scale %s" % s, placed("s:scale(%s)" % s), code=1, says="scene.lua:\\d+: error: ") for s in ("1e-320,1,1", "1e-310,1e-310,1e-310")],
    Case("D8 E10", "a product that overflows", placed("for i = 1, 3 do s:scale(1e150,1e150,1e150) end"), code=1, says="finite|large|small|invert"),
    Case("E10", "a product that vanishes", shot("local s, g = gr.sphere('s'), gr.node('g') s:scale(1e-200,1e-200,1e-200) g:scale(1e-200,1e-200,1e-200) "
         "g:add_child(s, white) root:add_child(g)"), code={0, 1}, says="error: |warning: .*flat"),
    wrong("D9", "axis w", "gr.node('n'):rotate('w', 90)", ["rotate", "w"]),
    wrong("D9", "axis xy", "gr.node('n'):rotate('xy', 90)", ["rotate", "xy"]),
    fine("D9", "axis X", placed("s:rotate('X', 90)")),
    fine("D10", "colour over 1", shot("root:add_child(gr.sphere('s'), gr.material({2,3,4}, {5,0,0}, 1))")),
    fine("D10", "colour below 0", shot("root:add_child(gr.sphere('s'), gr.material({-1,0,0}, {0,0,0}, 1))"), "warning: "),
    fine("D11", "exponent 0", shot("root:add_child(gr.sphere('s'), gr.material({1,1,1}, {1,1,1}, 0))")),
    wrong("D11", "exponent -1", "gr.material({1,1,1}, {1,1,1}, -1)", "material.*exponent|material.*>= 0"),
    fine("D11", "exponent 1e9", shot("root:add_child(gr.sphere('s'), gr.material({1,1,1}, {1,1,1}, 1e9))")),
    *[wrong("D12", "refractive index " + i, "gr.sphere('s'):set_refraction(%s, 0.5)" % i, "refraction.*index") for i in ("0", "-1")],
    wrong("D12", "weight over 1", "gr.sphere('s'):set_reflection(1.5)", "reflection"),
    Case("D12", "index below 1", shot("local s = gr.sphere('s') s:set_refraction(0.8, 0.5) root:add_child(s, white)"), writes="x.png"),
    fine("D13", "falloff {0,0,0}", ROOT + "root:add_child(gr.sphere('s'), white)\n" + render(lights="{gr.light({3,3,3}, {1,1,1}, {0,0,0})}"),
         "warning: .*falloff"),
    *[fine("D14", "a light " + where, ROOT + "root:add_child(gr.sphere('s'), white)\n" + render(lights="{gr.light(%s, {1,1,1}, {0,0,1})}" % place), never="finite")
      for where, place in (("on a surface", "{0,0,1}"), ("at the eye", "{0,0,5}"), ("in the middle", "{0,0,0}"))],
    fine("D15", "no lights", ROOT + "root:add_child(gr.sphere('s'), white)\n" + render(), never="error"),
    wrong("D16", "view of zero", render(view="{0,0,0}"), "view"),
    wrong("D16", "up of zero", render(up="{0,0,0}"), "up"),
    Case("D16", "view along up", ROOT + "root:add_child(gr.sphere('s'), white)\n" + render(up="{0,0,-2}"), says="warning: .*up", writes="x.png"),
    *[wrong("D17", "fov " + f, render(fov=f), "fov") for f in ("0", "180", "360", "-10")],
    *[wrong("D18", "width " + w, render(w=w), "w must be a whole number", code=1) for w in ("0", "-3", "1.5", "0/0", "1e300", "-2^63", "'x'", "2^31", "2^53")],
    wrong("D19", "10^9 pixels", render(w="40000", h="25000"), ["1000000000|40000x25000", "--max-pixels", "MB"], code=4, seconds=5),
    wrong("D20", "no name", render(file="''"), "file|name", code={1, 2, 3}),
    *[Case("D20", "output " + n[:20], ROOT + "root:add_child(gr.sphere('s'), white)\n" + render(file=n), code={1, 3}, says="error: ")
      for n in ("'a/b/'", "'x'", "'x.xyz'", "'" + "n" * 300 + ".png'", "'x\\0.png'", "'.png.'")],
    Case("D21", "output upwards", ROOT + render(file="'../escaped.png'"), code={1, 3}, says="error: ", also=nothing_outside),
    Case("D21", "absolute output", ROOT + render(file="'/tmp/rt-escaped.png'"), code={1, 3}, says="error: "),
    Case("D22", "no render", ROOT, says="warning: .*nothing"),
    fine("D22", "a thousand renders", ROOT + "for i = 1, 1000 do " + render(file="'out/' .. i .. '.png'", w="1", h="1") + " end", never="error", writes="out/1000.png"),
    fine("D22", "two renders of one name", BALL + SHOT, "warning: .*x\\.png"),
    Case("D23", "render within a callback", shot("table.sort({1, 2}, function() %s end) root:add_child(gr.sphere('s'), white)" % render()), code={0, 1}),
    wrong("D24", "unknown option", "gr.options{sppp = 3}", "did you mean 'spp'"),
    wrong("D24", "unknown call", "gr.sphear('s')", "sphere"),
    fine("D25", "odd names", shot("root:add_child(gr.sphere(('n'):rep(1 << 20)), white) root:add_child(gr.sphere(''), white) "
         r"root:add_child(gr.sphere('\xff\xfe'), white) root:add_child(gr.sphere('s'), white) root:add_child(gr.sphere('s'), white)"), never="error"),
    Case("D25", "a name of 1 MB in a message", shot("root:add_child(gr.sphere(('n'):rep(1 << 20)))"), code=1, says="error: "),
    fine("D26", "a material on a group", shot("local g = gr.node('g') g:set_material(white) g:add_child(gr.sphere('s'), white) root:add_child(g)"), "warning: .*g"),
    Case("D26", "neither material nor texture", shot(BARE), code=1, says=[r"scene\.lua:2: error: ", "bare", "material"]),
    fine("D27", "changed after a render", ROOT + "local s = gr.sphere('s') root:add_child(s, white)" + SHOT + "s:translate(9, 9, 0)" + SHOT.replace("x.png", "y.png"),
         also=differ, never="error"),
    fine("D27", "changed and changed back", ROOT + "local s = gr.sphere('s') root:add_child(s, white)" + SHOT + "s:translate(9, 9, 0) s:translate(-9, -9, 0)"
         + SHOT.replace("x.png", "y.png"), also=same, never="error"),
]
