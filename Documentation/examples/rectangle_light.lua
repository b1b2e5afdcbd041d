-- A long lamp above on the left, at right angles to a post.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
root:add_child(gr.nh_sphere('ball', {-0.8, 0.7, 0}, 0.7), stage.white)
root:add_child(gr.nh_cylinder('post', {1, 0, 0}, 1.6, 0.12), stage.white)
stage.show(root, {gr.rectangle_light{corner = {-3, 3, -2.5}, u = {0, 0, 5}, v = {0.3, 0.3, 0},
                                     colour = {9, 8, 6}, falloff = {0, 0, 1}}})
