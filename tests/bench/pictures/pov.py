"""A table of scenes.py as a POV-Ray scene: the twin of lua.py's script.

Quality is not part of it; it is declared on the command line: AN (area light of AN x AN), AADAPT (adaptive level, -1:
none), AJIT (jitter), and BS, BSMIN, BVAR, BCONF (most and fewest blur samples, variance, confidence).
"""
import math
import numpy as np

HEAD = """#version 3.7;
#ifndef (AN) #declare AN = 5; #end
#ifndef (AADAPT) #declare AADAPT = 1; #end
#ifndef (AJIT) #declare AJIT = 1; #end
#ifndef (BS) #declare BS = 20; #end
#ifndef (BSMIN) #declare BSMIN = 0; #end
#ifndef (BVAR) #declare BVAR = 1/128; #end
#ifndef (BCONF) #declare BCONF = 0.9; #end
"""


def v3(v):
    return "<%s>" % ",".join("%.9g" % x for x in v)


def looks(o):
    m = o["mat"]
    if o["type"] == "tiles":    # map_type 0 lies in xy; the image's u follows x and its v follows z
        pigment = ('image_map { png "%s" gamma 1.0 map_type 0 interpolate 2 } '
                   'matrix <1,0,0, 0,0,1, 0,1,0, 0,0,0> scale %g' % (o["file"], o["scale"]))
    else:
        pigment = "rgbt <%s,%.9g>" % (",".join("%.9g" % x for x in m["color"]), m["transmit"])
    mirror = " reflection { rgb %g }" % m["reflection"] if m["reflection"] > 0 else ""
    inside = " interior { ior %g }" % m["ior"] if m["transmit"] > 0 else ""
    return "texture { pigment { %s } finish { ambient %g diffuse %g phong %g phong_size %g%s } }%s" % (
        pigment, m["ambient"], m["diffuse"], m["phong"], m["phong_size"], mirror, inside)


def shape(o):
    kind, m = o["type"], looks(o)
    if kind == "sphere":
        return "sphere { %s, %.9g %s }" % (v3(o["center"]), o["radius"], m)
    if kind == "cylinder":
        return "cylinder { %s, %s, %.9g %s }" % (v3(o["p0"]), v3(o["p1"]), o["radius"], m)
    if kind == "cone":
        return "cone { %s, %.9g, %s, 0 %s }" % (v3(o["p0"]), o["r0"], v3(o["p1"]), m)
    if kind == "box":
        c, s = math.cos(math.radians(o["turned"])), math.sin(math.radians(o["turned"]))
        rows = [c, 0, -s, 0, 1, 0, s, 0, c, *o["at"]]
        return "box { %s, %s %s matrix <%s> }" % (v3(o["min"]), v3(o["max"]), m, ",".join("%.12g" % x for x in rows))
    if kind == "torus":
        axis = np.array(o["axis"])
        u = np.cross([1.0, 0, 0] if abs(axis[0]) < 0.9 else [0, 0, 1.0], axis)
        u /= np.linalg.norm(u)
        rows = [*u, *axis, *np.cross(u, axis), *o["center"]]
        return "torus { %.9g, %.9g %s matrix <%s> }" % (o["major"], o["minor"], m, ",".join("%.12g" % x for x in rows))
    if kind == "tiles":
        low, high = o["min"], o["max"]
        return "box { %s, %s %s }" % (v3((low[0], o["y"] - 0.1, low[1])), v3((high[0], o["y"], high[1])), m)
    return '#include "mesh_%s.inc"\nobject { TheMesh %s }' % (o["size"], m)


def lamp(l):
    if l["radius"] <= 0:
        return "light_source { %s rgb %s }" % (v3(l["pos"]), v3(l["color"]))
    return ("light_source { %s rgb %s\n  #if (AN > 1) area_light <%.9g,0,0>, <0,%.9g,0>, AN, AN circular orient\n"
            "  #if (AADAPT >= 0) adaptive AADAPT #end\n  #if (AJIT) jitter #end #end }"
            % (v3(l["pos"]), v3(l["color"]), 2 * l["radius"], 2 * l["radius"]))


def script(s):
    c = s["camera"]
    aspect = s["size"][0] / s["size"][1]
    angle = 2 * math.degrees(math.atan(aspect * math.tan(math.radians(c["fovy"]) / 2)))
    lens = ""
    if c["lens_radius"] > 0:    # its lens reaches a quarter of `aperture` from the axis
        lens = ("\n  aperture %.9g focal_point %s"
                "\n  #if (BSMIN > 0) blur_samples BSMIN, BS #else blur_samples BS #end"
                " variance BVAR confidence BCONF" % (
            4 * c["lens_radius"], v3(c["focus"])))
    lines = [HEAD, "global_settings { assumed_gamma 1.0 max_trace_level %d ambient_light rgb 1 }" % s["max_depth"],
             "background { rgb %s }" % v3(s["background"]),
             "camera { perspective location %s sky %s right <-%.12g,0,0> up <0,1,0> angle %.10g look_at %s%s }" % (
                 v3(c["eye"]), v3(c["up"]), aspect, angle, v3(c["at"]), lens)]
    return "\n".join(lines + [lamp(l) for l in s["lights"]] + [shape(o) for o in s["objects"]]) + "\n"
