-- Four samples a pixel on a grid, the way of old programs: compare the edges with the other pictures.
local stage = require 'stage'
gr.options{spp = 4, sampler = 'grid'}
local root = gr.node('root')
stage.board(root)
root:add_child(gr.nh_sphere('ball', {-1.2, 0.8, 0}, 0.8), stage.red)
root:add_child(gr.nh_box('box', {0.5, 0, -0.6}, {1.2, 1.2, 1.2}), stage.blue)
stage.show(root)
