-- The solids that take their place and size: sphere, box, cylinder, cone, torus; the last torus is a spindle.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
root:add_child(gr.nh_sphere('sphere', {-2.6, 0.45, 0}, 0.45), stage.red)
root:add_child(gr.nh_box('box', {-1.9, 0, -0.3}, {0.8, 0.9, 0.6}), stage.blue)
root:add_child(gr.nh_cylinder('cylinder', {-0.5, 0, 0}, 1.2, 0.35), stage.green)
root:add_child(gr.nh_cone('cone', {0.55, 0, 0}, 1.2, 0.45), stage.gold)
root:add_child(gr.nh_torus('torus', {1.65, 0.6, 0}, 0.42, 0.14), stage.red)
root:add_child(gr.nh_torus('spindle', {2.75, 0.48, 0}, 0.18, 0.3), stage.blue)
stage.show(root)
