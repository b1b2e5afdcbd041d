-- The camera looks down and is tilted by its up vector; fov is 50 degrees.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
root:add_child(gr.nh_sphere('ball', {0, 0.7, 0}, 0.7), stage.red)
root:add_child(gr.nh_box('box', {1, 0, -1.5}, {1, 1.6, 1}), stage.blue)
root:add_child(gr.nh_cone('cone', {-1.6, 0, -1}, 1.4, 0.6), stage.gold)
gr.background({0.78, 0.79, 0.80}, {0.42, 0.54, 0.70})
root:render('example.png', 240, 135, {1.5, 5, 5}, {-1.5, -4.4, -5}, {0.25, 1, 0}, 50, {0.30, 0.30, 0.32}, {stage.sun})
