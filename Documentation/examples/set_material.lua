-- A node's own appearance: a material, a texture, a bump map.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local one, two, three = gr.sphere('one'), gr.sphere('two'), gr.sphere('three')
one:set_material(stage.blue)
two:set_texture(stage.grid)
three:set_material(stage.gold)
three:set_bumpmap(gr.bumpmap('studs_normal.png'))
for i, ball in ipairs({one, two, three}) do
  ball:scale(0.75, 0.75, 0.75)
  ball:translate(1.8 * (i - 2), 0.75, 0)
  root:add_child(ball)
end
stage.show(root)
