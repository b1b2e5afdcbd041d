-- Index 1.05, 1.33 and 1.5; the last with 30 % of its own colour.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
for i, glass in ipairs({{1.05, 0}, {1.33, 0}, {1.5, 0.3}}) do
  local ball = gr.nh_sphere('ball ' .. i, {1.8 * (i - 2), 0.8, 0}, 0.8)
  ball:set_refraction(glass[1], glass[2])
  root:add_child(ball, i == 3 and stage.green or stage.clear)
end
stage.show(root)
