-- Twelve balls on their way, by gr.time: with --frames 1-24 each turns once.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
for i = 0, 11 do
  local a = 2 * math.pi * (gr.time + i / 12)
  local ball = gr.nh_sphere('ball ' .. i, {1.9 * math.cos(a), 0.25 + 0.12 * i, 1.2 * math.sin(a)}, 0.24)
  root:add_child(ball, i == 0 and stage.red or stage.gold)
end
stage.show(root)
