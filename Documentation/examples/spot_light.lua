-- A spot with a wide fade from the left, and a sharp one from the right.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
root:add_child(gr.nh_sphere('ball', {-0.8, 0.7, 0}, 0.7), stage.white)
root:add_child(gr.nh_cylinder('post', {1, 0, 0}, 1.6, 0.12), stage.white)
stage.show(root, {gr.spot_light{position = {-3, 4, 3}, direction = {2.4, -4, -3}, colour = {0.85, 0.72, 0.45},
                                inner = 6, outer = 24},
                  gr.spot_light{position = {4, 5, 4}, direction = {-2.8, -4.6, -4}, colour = {0.25, 0.4, 0.7},
                                inner = 13, outer = 13}})
