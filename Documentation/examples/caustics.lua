-- A ball of glass and a ring of brass in low light; -D caustics=false shows what they are without.
local stage = require 'stage'
local caustics = gr.param('caustics', true, {doc = 'whether light is bent and thrown'})
gr.options{caustics = caustics}
local root = gr.node('root')
root:add_child(gr.nh_box('floor', {-60, -1, -60}, {120, 1, 120}), gr.material({0.62, 0.60, 0.56}, {0, 0, 0}, 1))
local ball = gr.nh_sphere('ball', {-1.1, 0.86, 0}, 0.85)
ball:set_refraction(1.5, 0)
ball:set_fresnel(true)
root:add_child(ball, stage.clear)
-- The ring is a mesh: an open tube with a wall inside and out.
local points, faces = {}, {}
local n, height, inner, outer = 96, 0.55, 0.95, 1.02
for i = 0, n - 1 do
  local a = 2 * math.pi * i / n
  for _, r in ipairs{inner, outer} do
    for _, y in ipairs{0, height} do points[#points + 1] = {r * math.cos(a), y, r * math.sin(a)} end
  end
  local p, q = 4 * i, 4 * ((i + 1) % n)
  faces[#faces + 1] = {p, p + 1, q + 1, q}
  faces[#faces + 1] = {q + 2, q + 3, p + 3, p + 2}
  faces[#faces + 1] = {p + 1, p + 3, q + 3, q + 1}
  faces[#faces + 1] = {q, q + 2, p + 2, p}
end
local ring = gr.mesh('ring', points, faces)
ring:translate(1.35, 0.002, 0.4)
ring:set_reflection(0.25)
root:add_child(ring, gr.material({0.8, 0.55, 0.2}, {0.4, 0.35, 0.2}, 80))
stage.show(root, {gr.light({-6, 5, -2}, {0.75, 0.72, 0.64}, {1, 0, 0}, 0.3)})
