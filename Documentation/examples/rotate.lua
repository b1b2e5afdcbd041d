-- One box, turned by 0, 30 and 60 degrees about y; the red one about z as well.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
for i = 0, 2 do
  local box = gr.nh_box('box ' .. i, {-0.5, 0, -0.5}, {1, 1.4, 1})
  box:rotate('y', 30 * i)
  if i == 2 then box:rotate('z', -20) end
  box:translate(1.9 * (i - 1), 0, 0)
  root:add_child(box, i == 2 and stage.red or stage.blue)
end
stage.show(root)
