-- A panorama, seen directly and in a mirror ball.
local stage = require 'stage'
local root = gr.node('root')
local ball = gr.nh_sphere('ball', {0, 1.2, 0}, 1.1)
ball:set_reflection(0)
root:add_child(ball, stage.clear)
gr.background('sky.png')
root:render('example.png', 240, 135, {0, 1.2, 6}, {0, 0.05, -1}, {0, 1, 0}, 40, {0.3, 0.3, 0.3}, {stage.sun})
