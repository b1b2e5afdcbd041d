-- A ball at rest, one that moves to the right, and one that falls.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
root:add_child(gr.nh_sphere('at rest', {-2.1, 0.6, 0}, 0.6), stage.red)
local right = gr.nh_sphere('to the right', {-0.6, 0.6, 0}, 0.6)
right:move(0.9, 0, 0)
root:add_child(right, stage.gold)
local down = gr.nh_sphere('down', {2.3, 1.3, 0}, 0.6)
down:move(0, -0.7, 0)
root:add_child(down, stage.blue)
stage.show(root)
