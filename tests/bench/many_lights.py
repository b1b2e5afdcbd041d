#!/usr/bin/env python3
"""many_lights.py [--program ./Project] [--most 100000] [--error 0.01] [--out FILE]: what a picture costs whose light
comes from 1, 10, 100 ... lamps of the same power together.

A floor of balls under lamps at random places. Times are processor seconds of one thread, to the same estimated error;
"true error" is against 256 samples of every light, for up to 100 lamps. With --out, the scene's pictures are kept in
that folder.
"""
import argparse, json, os, subprocess, tempfile

SCENE = """
local n = gr.param('lamps', 1000)
math.randomseed(7)
local lamps = {}
for i = 1, n do
    local x, y, z = 20 * math.random() - 10, 0.5 + 2.5 * math.random(), 20 * math.random() - 10
    local hue, power = 6.2832 * math.random(), 160 / n
    local function channel(k) return power * (0.6 + 0.4 * math.cos(hue - 2.0944 * k)) end
    lamps[i] = gr.light({x, y, z}, {channel(0), channel(1), channel(2)}, {0, 0, 1}, 0.05)
end
local white = gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 1)
local shiny = gr.material({0.5, 0.5, 0.55}, {0.3, 0.3, 0.3}, 30)
local root = gr.node('root')
root:add_child(gr.nh_box('floor', {-12, -0.1, -12}, {24, 0.1, 24}), white)
for i = -4, 4 do
    for j = -4, 4 do
        root:add_child(gr.nh_sphere('ball ' .. i .. ' ' .. j, {2.2 * i, 0.45, 2.2 * j}, 0.45), (i + j) % 2 == 0 and white or shiny)
    end
end
gr.render(root, 'lamps.png', 160, 90, {0, 7, 14}, {0, -0.45, -1}, {0, 1, 0}, 45, {0.02, 0.02, 0.02}, lamps)
"""


def render(program, folder, lamps, image, *options):
    scene, stats = os.path.join(folder, "lamps.lua"), os.path.join(folder, "stats.json")
    with open(scene, "w") as file:
        file.write(SCENE)
    subprocess.run([program, scene, "-q", "-o", image, "--stats", stats, "-D", "lamps=%d" % lamps, "--threads", "1",
                    "--bits", "16", *options],
                   check=True, cwd=folder)
    with open(stats) as file:
        return json.load(file)["renders"][0]


def difference(program, one, other):
    return float(subprocess.run([program, "compare", one, other], capture_output=True, text=True).stdout.split()[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="./Project")
    parser.add_argument("--most", type=int, default=100000)
    parser.add_argument("--error", default="0.01")
    parser.add_argument("--out")
    given = parser.parse_args()
    program = os.path.abspath(given.program)
    print("| lamps | CPU seconds | samples a pixel | shadow rays a sample | estimated error | true error |")
    print("| --: | --: | --: | --: | --: | --: |")
    with tempfile.TemporaryDirectory(prefix="lamps-") as folder:
        lamps = 1
        while lamps <= given.most:
            image, truth = (os.path.join(given.out or folder, "%s_%d.png" % (kind, lamps)) for kind in ("lamps", "truth"))
            stats = render(program, folder, lamps, image, "--error", given.error)
            samples = stats["spp_mean"]
            shadow = stats["rays"]["shadow"] / max(stats["rays"]["camera"], 1)
            true = "-"
            if lamps <= 100:
                render(program, folder, lamps, truth, "--reference", "--spp", "256", "--seed", "5")
                true = "%.4f" % difference(program, image, truth)
            print("| %d | %.2f | %.1f | %.1f | %.4f | %s |" % (lamps, stats["cpu_seconds"], samples, shadow, stats["error_estimate"], true),
                  flush=True)
            lamps *= 10


if __name__ == "__main__":
    main()
