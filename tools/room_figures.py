#!/usr/bin/env python3
"""room_figures.py: counts what scenes/room.lua holds and what its picture shows. Run it in the root.

The scene is run with some of its calls replaced. Masks: mirrors, glass and water are white in a black world, so the
picture's mean is their share. Depth: a light in the eye that falls off with the distance, on white things, whose
brightness of 1 does away with angles, so a pixel's value is 1 / distance. PROJECT is the program.
"""
import json, math, os, struct, subprocess, sys, tempfile

PROJECT = os.environ.get("PROJECT", "./Project")
WIDTH, HEIGHT = 1280, 720

LUA = """
package.path = 'scenes/?.lua;' .. package.path
local what = gr.param('what', 'count')
local add_child, set_reflection, set_refraction = gr.add_child, gr.set_reflection, gr.set_refraction
local texture, bumpmap, mesh, render = gr.texture, gr.bumpmap, gr.mesh, gr.render
local function flat(v) return gr.material({v, v, v}, {0, 0, 0}, 1) end
local black, white = flat(0), flat(1)
local children, triangles, marked, textures, bumps = {}, {}, {}, {}, {}

function gr.texture(file, ...) textures[file] = true return texture(file, ...) end
function gr.bumpmap(file) bumps[file] = true return bumpmap(file) end
function gr.mesh(name, file, ...)
    local node = mesh(name, file, ...)
    triangles[node] = file
    return node
end
function gr.set_reflection(node, f) if f < 0.5 then marked[node] = true else marked[node] = 'partly' end end
function gr.set_refraction(node, index, f) if index ~= 1 then marked[node] = true end end
function gr.add_child(parent, child, material, texture, bump)
    children[parent] = children[parent] or {}
    table.insert(children[parent], child)
    if not (material or texture) then return add_child(parent, child) end
    local shown = what == 'depth' or marked[child] == (what == 'partly' and 'partly' or true)
    add_child(parent, child, shown and white or black)
end

local function places(node, use)
    if triangles[node] then use(triangles[node]) end
    for _, child in ipairs(children[node] or {}) do places(child, use) end
end
local function count(map)
    local n = 0
    for _ in pairs(map) do n = n + 1 end
    return n
end

function gr.render(root, file, w, h, eye, view, up, fov, ambient, lights, focus)
    if what == 'count' then
        local n = {}
        places(root, function(mesh) n[mesh] = (n[mesh] or 0) + 1 end)
        for mesh, times in pairs(n) do print('mesh', mesh, times) end
        print('textures', count(textures))
        print('bumps', count(bumps))
        print('lights', #lights)
        print('view', view[1], view[2], view[3], fov)
        print('eye', eye[1], eye[2], eye[3])
    end
    gr.background({0, 0, 0})
    if what == 'depth' then
        return render(root, file, w, h, eye, view, up, fov, {0, 0, 0}, {gr.light(eye, {1, 1, 1}, {0, 1, 0}, 0, 1)})
    end
    render(root, file, w, h, eye, view, up, fov, {1, 1, 1}, {gr.light(eye, {0, 0, 0}, {1, 0, 0})})
end

local focal = gr.focal
function gr.focal(p, f, a)
    if what == 'count' then print('lens', p[1], p[2], p[3], a) end
    return focal(p, f, a)
end
dofile('scenes/room.lua')
"""


def run(what, output, *options):
    done = subprocess.run([PROJECT, "-", "-q", "-D", "what=" + what, "--size", "%dx%d" % (WIDTH, HEIGHT), "-o", output,
                           *options], input=LUA.encode(), capture_output=True)
    if done.returncode != 0:
        sys.exit(done.stderr.decode())
    return done.stdout.decode()


def pixels(path):
    """The red channel, the top row first."""
    with open(path, "rb") as f:
        f.readline()
        width, height = map(int, f.readline().split())
        f.readline()
        values = struct.unpack("<%df" % (3 * width * height), f.read())[::3]
    return [values[width * y:width * (y + 1)] for y in range(height)][::-1]


def triangles_of(name):
    """Of Assets/Model/NAME, polygons as fans."""
    with open(os.path.join("Assets", "Model", os.path.basename(name))) as f:
        return sum(len(line.split()) - 3 for line in f if line.startswith("f "))


def blur_radii(depth, said):
    """The radius of each pixel's blur circle, in pixels: h/2 a |p - D| / (D p tan(fov/2))."""
    view, fov = [float(x) for x in said["view"][:3]], math.radians(float(said["view"][3]))
    eye, focus = [float(x) for x in said["eye"]], [float(x) for x in said["lens"][:3]]
    length = math.sqrt(sum(x * x for x in view))
    plane = sum((f - e) * v / length for f, e, v in zip(focus, eye, view))
    tangent = math.tan(fov / 2)
    for y, row in enumerate(depth):
        for x, value in enumerate(row):
            u = (x + 0.5 - WIDTH / 2) / (HEIGHT / 2) * tangent
            v = (y + 0.5 - HEIGHT / 2) / (HEIGHT / 2) * tangent
            # Where nothing is hit the distance is infinite, and the circle has its limit.
            share = plane * value * math.sqrt(1 + u * u + v * v)
            yield HEIGHT / 2 * float(said["lens"][3]) * abs(share - 1) / (plane * tangent)


def main():
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        out = run("count", os.path.join(folder, "x.pfm"), "--spp", "1", "--stats", stats, "-j", "1")
        lines = [line.split("\t") for line in out.splitlines()]
        said = {line[0]: line[1:] for line in lines if line[0] != "mesh"}
        triangles = sum(triangles_of(line[1]) * int(line[2]) for line in lines if line[0] == "mesh")
        with open(stats) as f:
            render = json.load(f)["renders"][0]
        print("%d triangles after instancing, in %d places of meshes" %
              (triangles, sum(int(line[2]) for line in lines if line[0] == "mesh")))
        print("%d objects in all, %s lights" % (render["instances"], said["lights"][0]))
        print("%s textures, %s bump maps" % (said["textures"][0], said["bumps"][0]))
        for what, text in ("mask", "mirror, glass or water"), ("partly", "lacquer and tea, which reflect in part"):
            path = os.path.join(folder, what + ".pfm")
            run(what, path, "--spp", "16")
            share = sum(map(sum, pixels(path))) / (WIDTH * HEIGHT)
            print("%.1f %% of the pixels show %s" % (100 * share, text))
        path = os.path.join(folder, "depth.pfm")
        run("depth", path, "--spp", "1", "--sampler", "grid")
        radii = list(blur_radii(pixels(path), said))
        for least in 1, 1.5, 2, 3:
            share = sum(radius >= least for radius in radii) / len(radii)
            print("%.1f %% of the pixels show something with a blur circle %g pixels wide or more" % (100 * share, 2 * least))


if __name__ == "__main__":
    main()
