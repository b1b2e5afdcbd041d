-- The same ball in seven places.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
for i = 0, 6 do
  local ball = gr.nh_sphere('ball ' .. i, {0, 0.3, 0}, 0.3)
  ball:translate(0.7 * (i - 3), 0.8 * math.abs(math.cos(i * math.pi / 3)), 0)
  root:add_child(ball, stage.gold)
end
stage.show(root)
