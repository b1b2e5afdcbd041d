-- A frustum, half a ball, a disc, a quad with an image, on a plane that goes on to the horizon.
local stage = require 'stage'
local root = gr.node('root')
root:add_child(gr.nh_plane('ground', {0, 0, 0}, {0, 1, 0}), nil, stage.checks)
root:add_child(gr.nh_frustum('frustum', {-2.4, 0, 0}, 1.1, 0.55, 0.25), stage.red)
root:add_child(gr.nh_hemisphere('half', {-0.9, 0, 0}, 0.7), stage.gold)
root:add_child(gr.nh_disc('disc', {0.75, 0.7, 0}, {-0.3, 0.35, 1}, 0.65), stage.blue)
root:add_child(gr.nh_quad('quad', {1.7, 0.05, 0.2}, {1.1, 0, -0.5}, {0, 1.2, 0}), nil, stage.grid)
stage.show(root)
