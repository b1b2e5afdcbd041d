-- Three balls under one node, which is turned as a whole.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)

local group = gr.node('group')
for i, material in ipairs({stage.red, stage.gold, stage.blue}) do
  local ball = gr.nh_sphere('ball ' .. i, {1.4 * (i - 2), 0.6, 0}, 0.6)
  group:add_child(ball, material)
end
group:rotate('y', 35)
root:add_child(group)
stage.show(root)
