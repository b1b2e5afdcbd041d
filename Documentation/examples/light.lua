-- A point light from the left, a sphere of radius 1.5 from the right.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
root:add_child(gr.nh_sphere('ball', {-0.8, 0.7, 0}, 0.7), stage.white)
root:add_child(gr.nh_cylinder('post', {1, 0, 0}, 1.6, 0.12), stage.white)
stage.show(root, {gr.light({-6, 6, 5}, {0.50, 0.42, 0.30}, {1, 0, 0}),
                  gr.light({6, 6, 4}, {0.30, 0.38, 0.52}, {1, 0, 0}, 1.5)})
