#!/usr/bin/env python3
"""make_terminator_figure.py [PROJECT]: Documentation/images/terminator.png, a coarse smooth ball before and after.

After is the program's picture. Before is composed from it: what lies on facets that turn away from the light is given
the ambient light alone, as if shadow rays started on the facets; a picture of the same ball with flat faces tells which
those are. Run it in the root. Needs numpy and matplotlib.
"""
import os, subprocess, sys, tempfile

import matplotlib.image
import numpy

SCENE = """
local v, f = {{0, 1, 0}}, {}
for i = 1, 7 do for k = 0, 11 do
  local a, b = i * math.pi / 8, k * math.pi / 6
  v[#v + 1] = {math.sin(a) * math.cos(b), math.cos(a), math.sin(a) * math.sin(b)}
end end
v[#v + 1] = {0, -1, 0}
for k = 0, 11 do
  local n = (k + 1) %% 12
  f[#f + 1], f[#f + 2] = {0, 1 + n, 1 + k}, {85, 73 + k, 73 + n}
  for r = 1, 61, 12 do f[#f + 1] = {r + k, r + n, r + 12 + n, r + 12 + k} end
end
local root = gr.node('root')
root:add_child(gr.mesh('ball', v, f, {smooth = %s}), gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 1))
gr.render(root, 'x.pfm', 960, 960, {0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 14, {%s, %s, %s},
          {gr.light({-60, 50, 12}, {1, 1, 1}, {1, 0, 0}, 0, %s)})
"""
AMBIENT, FINER = 0.06, 4


def picture(project, folder, smooth, ambient, brightness):
    script, output = os.path.join(folder, "ball.lua"), os.path.join(folder, "ball.pfm")
    with open(script, "w") as file:
        file.write(SCENE % (smooth, ambient, ambient, ambient, brightness))
    subprocess.run([project, script, "-q", "--spp", "1", "--sampler", "grid", "-o", output], check=True)
    with open(output, "rb") as file:
        width, height = map(int, file.read().split(b"\n", 3)[1].split())
    data = numpy.fromfile(output, "<f4", offset=os.path.getsize(output) - 12 * width * height)
    return data.reshape(height, width, 3)[::-1]


def main():
    project = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "./Project")
    with tempfile.TemporaryDirectory(prefix="terminator-") as folder:
        after = picture(project, folder, 180, AMBIENT, 0)
        faces = picture(project, folder, 0, 0, 1) > 0.1  # lit, at all
    before = numpy.where(faces, after, numpy.minimum(after, 0.8 * AMBIENT))
    both = numpy.concatenate([before, after], 1)
    height, width, _ = both.shape
    small = both.reshape(height // FINER, FINER, width // FINER, FINER, 3).mean(axis=(1, 3))
    matplotlib.image.imsave("Documentation/images/terminator.png", numpy.clip(small, 0, 1))


if __name__ == "__main__":
    main()
