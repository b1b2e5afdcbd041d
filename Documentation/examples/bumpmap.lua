-- A wall without and with the relief of its bricks, and studs on a ball.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local bricks = gr.texture('bricks.png', {0.1, 0.1, 0.1}, 20)
root:add_child(gr.nh_box('plain', {-2.7, 0, -0.4}, {1.7, 1.7, 0.4}), nil, bricks)
root:add_child(gr.nh_box('relief', {-0.8, 0, -0.4}, {1.7, 1.7, 0.4}), nil, bricks, gr.bumpmap('bricks_normal.png'))
root:add_child(gr.nh_sphere('studs', {1.9, 0.8, 0}, 0.8), stage.gold, nil, gr.bumpmap('studs_normal.png'))
stage.show(root)
