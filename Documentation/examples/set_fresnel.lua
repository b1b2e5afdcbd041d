-- Glass without and with Fresnel's reflection; a pool that mirrors more the flatter the view.
local stage = require 'stage'
local root = gr.node('root')
local bottom = gr.mesh('bottom', 'ground.obj')
bottom:scale(128, 128, 128)
bottom:rotate('y', 30)
bottom:translate(0, -0.8, 0)
root:add_child(bottom, nil, stage.checks)
local pool = gr.nh_box('pool', {-90, -0.9, -90}, {180, 0.9, 180})
pool:set_refraction(1.33, 0)
pool:set_fresnel(true)
root:add_child(pool, stage.clear)
for i = 1, 2 do
  local ball = gr.nh_sphere('ball ' .. i, {2.2 * (i - 1.5), 0.85, 0}, 0.75)
  ball:set_refraction(1.5, 0)
  ball:set_fresnel(i == 2)
  root:add_child(ball, stage.clear)
end
root:add_child(gr.nh_sphere('float', {0, 0.2, -2.5}, 0.6), stage.red)
stage.show(root)
