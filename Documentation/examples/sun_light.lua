-- The shadows of a colonnade in the sun, its disc four times its real size.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
for i = 0, 6 do
  root:add_child(gr.nh_cylinder('column ' .. i, {0.8 * i - 2.6, 0, -0.8}, 1.5, 0.12), stage.white)
end
root:add_child(gr.nh_box('beam', {-3, 1.5, -1}, {5.6, 0.2, 0.4}), stage.white)
stage.show(root, {gr.sun_light{direction = {1, -0.75, -0.7}, colour = {0.7, 0.66, 0.56}, angle = 1.1}})
