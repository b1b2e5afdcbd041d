-- A stair whose number of steps -D steps=N sets, from 1 to 20.
local stage = require 'stage'
local steps = gr.param('steps', 9, {min = 1, max = 20, doc = 'steps of the stair'})
local root = gr.node('root')
stage.floor(root)
for i = 0, steps - 1 do
  local step = gr.nh_box('step ' .. i, {0.3, 0.22 * i, -0.3}, {0.9, 0.2, 0.6})
  step:rotate('y', 32 * i)
  root:add_child(step, i % 2 == 0 and stage.gold or stage.blue)
end
root:add_child(gr.nh_cylinder('pole', {0, 0, 0}, 0.22 * steps + 0.2, 0.12), stage.white)
stage.show(root)
