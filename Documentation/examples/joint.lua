-- An arm of two joints, each 40 degrees about x and turned a little about y.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)

local upper = gr.joint('shoulder', {-90, 40, 90}, {-90, 60, 90})
upper:add_child(gr.nh_cylinder('upper arm', {0, 0, 0}, 1.4, 0.18), stage.blue)
upper:add_child(gr.nh_sphere('socket', {0, 0, 0}, 0.3), stage.gold)

local lower = gr.joint('elbow', {0, 40, 90}, {0, 0, 0})
lower:add_child(gr.nh_cylinder('lower arm', {0, 0, 0}, 1.2, 0.14), stage.blue)
lower:add_child(gr.nh_sphere('elbow ball', {0, 0, 0}, 0.25), stage.gold)
lower:add_child(gr.nh_sphere('hand', {0, 1.3, 0}, 0.26), stage.red)
lower:translate(0, 1.4, 0)
upper:add_child(lower)
upper:translate(-1, 0.3, 0)
root:add_child(upper)
stage.show(root)
