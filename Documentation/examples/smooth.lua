-- One ball of 80 faces: smooth = false, true and 180.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
for i, smooth in ipairs({false, true, 180}) do
  local ball = gr.mesh('ball ' .. i, 'ball80_plain.obj', {smooth = smooth})
  ball:scale(0.8, 0.8, 0.8)
  ball:translate(1.9 * (i - 2), 0.8, 0)
  root:add_child(ball, stage.white)
end
stage.show(root, {gr.light({-4, 8, 2}, {0.8, 0.78, 0.72}, {1, 0, 0}, 0.4)})
