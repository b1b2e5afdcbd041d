-- Hills by a function, a relief from an image, a pool from a table: each closed by a base.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local function at(x, solid, height, material)
  solid:translate(-0.5, 0, -0.5)
  solid:scale(1.9, height, 1.9)
  solid:rotate('y', 32)
  solid:translate(x, 0, 0)
  root:add_child(solid, material)
end
at(-2.4, gr.height_field('hills', function(x, z)
  local dome = math.sin(math.pi * x) * math.sin(math.pi * z)
  return 0.3 + 0.5 * dome + 0.08 * math.sin(17 * x + 3) * math.cos(13 * z)
end, {base = 0}), 1.5, stage.green)
at(0.1, gr.height_field('relief', 'ripples_height.png', {base = -0.6}), 0.22, stage.gold)
local waves = {}
for j = 0, 64 do
  waves[j + 1] = {}
  for i = 0, 64 do waves[j + 1][i + 1] = 0.5 + 0.03 * math.sin(i / 3) * math.sin(j / 4 + i / 9) end
end
local pool = gr.height_field('pool', waves, {base = 0})
pool:set_refraction(1.33, 0)
pool:set_fresnel(true)
pool:set_absorption({0.9, 0.3, 0.2})
at(2.3, pool, 1, stage.clear)
for i = 0, 2 do root:add_child(gr.nh_sphere('ball ' .. i, {1.9 + 0.4 * i, 0.12, -0.2 + 0.25 * (i % 2)}, 0.12), stage.red) end
stage.show(root)
