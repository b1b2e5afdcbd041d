-- A lens of radius 0.15 that is focused on the red ball.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
for i, material in ipairs({stage.blue, stage.green, stage.red, stage.gold, stage.blue}) do
  local ball = gr.nh_sphere('ball ' .. i, {0.9 * (i - 3), 0.5, 2.8 - 1.6 * (i - 1) + 0.4}, 0.5)
  root:add_child(ball, material)
end
stage.show(root, nil, gr.focal({0, 0.5, 0.5}, 0.05, 0.15))
