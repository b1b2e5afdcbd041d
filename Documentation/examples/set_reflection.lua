-- f = 1, 0.5 and 0: its own colour, half of it, a perfect mirror.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
for i, f in ipairs({1, 0.5, 0}) do
  local ball = gr.nh_sphere('ball ' .. i, {1.8 * (i - 2), 0.8, 0}, 0.8)
  ball:set_reflection(f)
  root:add_child(ball, stage.red)
end
stage.show(root)
