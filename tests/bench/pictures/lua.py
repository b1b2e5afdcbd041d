"""A table of scenes.py as a script of the scene language.

POV-Ray's materials become the nearest of the language's: diffuse colour times diffuse; a white highlight; reflection
and transparency as weights of the own colour. The pictures differ a little, so each renderer is held against its own
converged image.
"""
import math


def vec(v):
    return "{" + ", ".join("%.9g" % x for x in v) + "}"


def turn_y_to(axis):
    """degrees about z, then about y, that turn +y into the unit vector"""
    x, y, z = axis
    return -math.degrees(math.acos(max(-1.0, min(1.0, y)))), math.degrees(math.atan2(-z, x))


def along(node, axis, at, first=""):
    about_z, about_y = turn_y_to(axis)
    return ["%s%s:rotate('z', %.9g); %s:rotate('y', %.9g)" % (first, node, about_z, node, about_y),
            "%s:translate(%.9g, %.9g, %.9g)" % (node, *at)]


def shape(n, o, name):
    """lines that make the node n"""
    kind = o["type"]
    if kind == "sphere":
        return ["local %s = gr.nh_sphere('%s', %s, %.9g)" % (n, n, vec(o["center"]), o["radius"])]
    if kind == "box":
        sides = vec([b - a for a, b in zip(o["min"], o["max"])])
        made = ["local %s = gr.nh_box('%s', %s, %s)" % (n, n, vec(o["min"]), sides)]
        if o["turned"] or any(o["at"]):
            made += ["%s:rotate('y', %.9g)" % (n, o["turned"]), "%s:translate(%.9g, %.9g, %.9g)" % (n, *o["at"])]
        return made
    if kind == "torus":
        return ["local %s = gr.nh_torus('%s', {0, 0, 0}, %.9g, %.9g)" % (n, n, o["major"], o["minor"]),
                *along(n, o["axis"], o["center"], "%s:rotate('x', -90); " % n)]
    if kind in ("cylinder", "cone"):
        d = [b - a for a, b in zip(o["p0"], o["p1"])]
        h = math.sqrt(sum(x * x for x in d))
        u = [x / h for x in d]
        if kind == "cylinder":
            return ["local %s = gr.nh_cylinder('%s', {0, 0, 0}, %.9g, %.9g)" % (n, n, h, o["radius"]),
                    *along(n, u, o["p0"])]
        return ["local %s = gr.nh_cone('%s', {0, 0, 0}, %.9g, %.9g)" % (n, n, h, o["r0"]),
                *along(n, [-x for x in u], o["p1"])]
    if kind == "tiles":
        return ["local %s = gr.mesh('%s', '%s_tiles.obj')" % (n, n, name)]
    return ["local %s = gr.mesh('%s', 'mesh_%s.obj', {smooth = true})" % (n, n, o["size"])]


def looks(n, o):
    m = o["mat"]
    highlight = vec([m["phong"]] * 3)
    diffuse = vec([c * m["diffuse"] for c in m["color"]])
    lines = []
    if m["transmit"] > 0:
        lines.append("%s:set_refraction(%.9g, %.9g)" % (n, m["ior"], 1 - m["transmit"]))
    if m["reflection"] > 0:
        lines.append("%s:set_reflection(%.9g)" % (n, 1 - m["reflection"]))
    texture = ", gr.texture('%s', %s, %.9g)" % (o["file"], highlight, m["phong_size"]) if o["type"] == "tiles" else ""
    lines.append("scene:add_child(%s, gr.material(%s, %s, %.9g)%s)" % (n, diffuse, highlight, m["phong_size"], texture))
    return lines


def script(s):
    c = s["camera"]
    lines = ["-- " + s["title"], "gr.options{max_depth = %d}" % s["max_depth"],
             "gr.background(%s)" % vec(s["background"]), "local scene = gr.node('scene')"]
    for i, o in enumerate(s["objects"]):
        n = "n%d" % (i + 1)
        lines += ["do", *shape(n, o, s["name"]), *looks(n, o), "end"]
    view = [a - e for a, e in zip(c["at"], c["eye"])]
    lens = ""
    if c["lens_radius"] > 0:
        distance = math.sqrt(sum((f - e) ** 2 for f, e in zip(c["focus"], c["eye"])))
        lens = ", gr.focal(%.9g, %.9g, %.9g)" % (distance, distance / 1000, c["lens_radius"])
    lights = ",\n   ".join("gr.light(%s, %s, {1, 0, 0}, %.9g)" % (vec(l["pos"]), vec(l["color"]), l["radius"])
                           for l in s["lights"])
    lines.append("gr.render(scene, '%s.png', %d, %d, %s, %s, %s, %.9g, %s,\n  {%s}%s)" % (
        s["name"], *s["size"], vec(c["eye"]), vec(view), vec(c["up"]), c["fovy"], vec([0.1 / 0.7] * 3), lights, lens))
    return "\n".join(lines) + "\n"
