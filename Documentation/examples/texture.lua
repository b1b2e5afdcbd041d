-- One image on a box, a ball, a drum and a cone.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local function put(node, x)
  node:translate(x, 0, 0)
  root:add_child(node, nil, stage.grid)
end
local box = gr.nh_box('box', {-0.5, 0, -0.5}, 1)
box:rotate('y', 30)
put(box, -2.2)
put(gr.nh_sphere('ball', {0, 0.6, 0}, 0.6), -0.7)
put(gr.nh_cylinder('drum', {0, 0, 0}, 1.1, 0.5), 0.75)
local cone = gr.nh_cone('cone', {0, 0, 0}, 1.4, 0.6)
cone:scale(1, -1, 1)
cone:translate(0, 1.4, 0)
put(cone, 2.1)
stage.show(root)
