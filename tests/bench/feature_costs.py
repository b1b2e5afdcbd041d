#!/usr/bin/env python3
"""feature_costs.py [--project ./Project] [--rounds N] [--spp N] [--markdown]: what leaving out gains, by feature.

Renders one scene by the leanest variant, and again with each feature forced on though no ray ever meets it: an object
that has it stands far behind the camera; for lights, a radius below any rounding; for the lens, an aperture as small.
The picture stays the same, which is checked; the cost is what the feature's code adds where it is not needed, and so
what a scene without it is spared. Rounds are interleaved; the ratio is the median over rounds of
processor time (--stats) to that of the leanest render beside it.
"""
import argparse, json, os, statistics, subprocess, sys, tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

SCENE = """
local root = gr.node('root')
local grey = gr.material({0.6, 0.6, 0.6}, {0.3, 0.3, 0.3}, 20)
root:add_child(gr.nh_box('floor', {-40, -1, -40}, {80, 1, 80}), grey)
local parts = {gr.nh_sphere('ball', {0, 0.5, 0}, 0.5), gr.nh_box('box', {-0.4, 0, -0.4}, {0.8, 0.8, 0.8}),
               gr.nh_cylinder('drum', {0, 0, 0}, 1, 0.4), gr.nh_cone('cone', {0, 0, 0}, 1, 0.5)}
for i = 0, 143 do
    local place = gr.node('place ' .. i)
    place:translate(1.5 * (i %% 12 - 5.5), 0, -1.5 * (i // 12))
    place:add_child(parts[i %% 4 + 1], grey)
    root:add_child(place)
end
local radius, focal, background, lamp = 0, nil, nil, nil
local far = gr.nh_sphere('far', {0, 900, 900}, 1)
%s
gr.background({0.3, 0.4, 0.6})
gr.render(root, 'x.png', 320, 180, {0, 4, 8}, {0, -0.35, -1}, {0, 1, 0}, 45, {0.3, 0.3, 0.3},
          {lamp or gr.light({-6, 20, 10}, {0.7, 0.7, 0.7}, {1, 0, 0}, radius)}, focal)
"""

# name -> what makes the scene use it, and the key that --stats lists it by
FEATURES = {
    "area lights": "radius = 1e-14",
    "spot lights": "lamp = gr.spot_light{position = {-6, 20, 10}, direction = {0, 1, 0}, colour = {0.7, 0.7, 0.7}, "
                   "inner = 180, outer = 180}",
    "lens": "focal = gr.focal(9, 0.5, 1e-15)",
    "textures and bump maps": "root:add_child(far, nil, gr.texture('white.png', {0, 0, 0}, 1))",
    "patterns": "root:add_child(far, nil, gr.checker{first = {1, 1, 1}, second = {1, 1, 1}})",
    "meshes": "root:add_child(gr.mesh('far', {{0, 900, 900}, {1, 900, 900}, {0, 901, 900}}, {{0, 1, 2}}), grey)",
    "combined solids": "root:add_child(gr.difference('d', far, gr.nh_sphere('b', {0, 900, 901}, 1)), grey)",
    "reflection": "far:set_reflection(0.5) root:add_child(far, grey)",
    "refraction": "far:set_refraction(1.5, 0.5) root:add_child(far, grey)",
    "motion blur": "far:move(0, 0, 1) root:add_child(far, grey)",
    "caustics": "gr.options{caustics = true} far:set_reflection(0.5) root:add_child(far, grey)",
    "absorption": "far:set_refraction(1.5, 0.5) far:set_absorption{1, 0, 0} root:add_child(far, grey)",
}
# An object more in the scene, whatever it is made of, costs too: those that add one are set beside this.
OBJECT = "root:add_child(far, grey)"


def white_png(path):
    import struct, zlib
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = zlib.compress(b"\0\xff\xff\xff")
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", rows) + chunk(b"IEND", b""))


def render(project, folder, name, spp):
    """(processor seconds, features, pixels)"""
    stats, output = os.path.join(folder, "stats.json"), os.path.join(folder, name + ".pfm")
    subprocess.run([project, os.path.join(folder, name + ".lua"), "-q", "-j", "1", "--spp", str(spp), "--stats", stats,
                    "-o", output], check=True, stderr=subprocess.DEVNULL)
    with open(stats) as file:
        only = json.load(file)["renders"][0]
    with open(output, "rb") as file:
        return only["cpu_seconds"], only["features"], file.read()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--project", default=os.path.join(TOP, "Project"))
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--spp", type=int, default=8)
    parser.add_argument("--markdown", action="store_true")
    arguments = parser.parse_args()
    scenes = {"leanest": "", "one object more": OBJECT, **FEATURES}
    times = {name: [] for name in scenes}
    pixels, used = {}, {}
    with tempfile.TemporaryDirectory(prefix="features-") as folder:
        white_png(os.path.join(folder, "white.png"))
        for name, extra in scenes.items():
            with open(os.path.join(folder, name + ".lua"), "w") as file:
                file.write(SCENE % extra)
        for _ in range(arguments.rounds):
            for name in scenes:
                seconds, used[name], pixels[name] = render(arguments.project, folder, name, arguments.spp)
                times[name].append(seconds)
    row = "| %s | %s | %s |" if arguments.markdown else "%-24s %-24s %s"
    print(row % ("forced on, though unused", "time, of that without", "same picture"))
    if arguments.markdown:
        print("| --- | --: | --: |")
    for name in list(scenes)[1:]:
        if name in FEATURES and name not in used[name] and name not in ("spot lights", "patterns"):
            sys.exit("feature_costs.py: the scene does not use %s" % name)
        base = "one object more" if "root:add_child" in scenes[name] and name != "one object more" else "leanest"
        ratio = statistics.median(a / b for a, b in zip(times[name], times[base]))
        print(row % (name, "%.3f" % ratio, "yes" if pixels[name] == pixels[base] else "no"))


if __name__ == "__main__":
    main()
