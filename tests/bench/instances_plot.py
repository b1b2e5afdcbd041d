#!/usr/bin/env python3
"""instances_plot.py [--program ./Project] [--most 1000000] [--out Documentation/images/instances_cost.png]

Renders clouds of 10, 100 ... copies of a mesh and of a torus, and plots what a sample costs (processor time) and how
much memory a render takes at its peak. A cloud is ten smaller clouds, so that it fills the same space whatever its
number, and its script is short; the copies together cover the same area. A sample's cost is the difference of two renders of 4 and 12 samples a pixel.
Needs Matplotlib.
"""
import argparse, json, os, subprocess, tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SIZE = 256

SCENE = """
local levels, kind = %d, '%s'
math.randomseed(5)
local stone = gr.material({0.7, 0.65, 0.6}, {0.1, 0.1, 0.1}, 10)
local thing = gr.node('thing')
local shape = kind == 'mesh' and gr.mesh('ball', '%s') or gr.torus('ring', 1, 0.35)
local radius = 0.43 * 10 ^ ((1 - levels) / 6)
shape:scale(radius, radius, radius)
thing:add_child(shape, stone)
for level = 1, levels do
    local cloud = gr.node('cloud ' .. level)
    for i = 1, 10 do
        local place = gr.node('place ' .. level .. ' ' .. i)
        local size = 10 ^ (-1 / 3)
        place:scale(size, size, size)
        place:rotate('y', 360 * math.random())
        place:rotate('x', 360 * math.random())
        place:translate(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5)
        place:add_child(thing)
        cloud:add_child(place)
    end
    thing = cloud
end
local root = gr.node('root')
root:add_child(thing)
gr.render(root, 'cloud.png', %d, %d, {0, 0, 4}, {0, 0, -1}, {0, 1, 0}, 16, {0.3, 0.3, 0.3},
          {gr.light({5, 8, 10}, {0.8, 0.8, 0.8}, {1, 0, 0})})
"""


def render(program, folder, levels, kind, spp, image):
    scene, stats = os.path.join(folder, "cloud.lua"), os.path.join(folder, "stats.json")
    mesh = os.path.join(TOP, "Assets/Model/ball80.obj")
    with open(scene, "w") as file:
        file.write(SCENE % (levels, kind, mesh, SIZE, SIZE))
    subprocess.run([program, scene, "--trust", "-q", "-o", image or os.path.join(folder, "cloud.png"), "--stats", stats, "--spp",
                    str(spp), "--threads", "1"], check=True, cwd=folder)
    with open(stats) as file:
        return json.load(file)["renders"][0]


def measure(program, kind, most, image_folder):
    rows, levels = [], 1
    with tempfile.TemporaryDirectory(prefix="instances-") as folder:
        while 10 ** levels <= most:
            image = image_folder and os.path.join(image_folder, "%s_%d.png" % (kind, 10 ** levels))
            few, many = (render(program, folder, levels, kind, spp, image) for spp in (4, 12))
            cost = 1e9 * (many["cpu_seconds"] - few["cpu_seconds"]) / (8 * SIZE * SIZE)
            rows.append((many["instances"], cost, many["peak_rss_bytes"] / 1e6, many["build_seconds"]))
            print("%-5s %8d copies: %7.0f ns a sample, %6.0f MB, built in %.2f s" % ((kind,) + rows[-1]), flush=True)
            levels += 1
    return rows


def plot(results, out):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.6))
    for kind, rows in results.items():
        counts = [row[0] for row in rows]
        left.semilogx(counts, [row[1] for row in rows], "o-", label=kind)
        right.loglog(counts, [row[2] for row in rows], "o-", label=kind)
    left.set(xlabel="copies", ylabel="ns a sample (camera and shadow ray)", ylim=(0, None))
    right.set(xlabel="copies", ylabel="peak memory of the program, MB")
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend()
    figure.tight_layout()
    figure.savefig(out, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(TOP, "Project"))
    parser.add_argument("--most", type=int, default=1000000)
    parser.add_argument("--out", default=os.path.join(TOP, "Documentation/images/instances_cost.png"))
    parser.add_argument("--images", help="keep the renders in this folder")
    arguments = parser.parse_args()
    results = {"mesh": measure(arguments.program, "mesh", arguments.most, arguments.images),
               "torus": measure(arguments.program, "torus", min(arguments.most, 100000), arguments.images)}
    plot(results, arguments.out)


if __name__ == "__main__":
    main()
