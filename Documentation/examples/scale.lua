-- A ball, wider, taller, and a cone that a negative factor turns over.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local function put(node, x, y, material)
  node:translate(x, y, 0)
  root:add_child(node, material)
end
local plain, wide, tall, cone = gr.sphere('plain'), gr.sphere('wide'), gr.sphere('tall'), gr.cone('cone')
plain:scale(0.5, 0.5, 0.5)
wide:scale(0.8, 0.4, 0.4)
tall:scale(0.4, 0.9, 0.4)
cone:scale(0.6, -1.4, 0.6)
put(plain, -2.2, 0.5, stage.blue)
put(wide, -0.7, 0.4, stage.blue)
put(tall, 0.7, 0.9, stage.blue)
put(cone, 2.1, 1.4, stage.red)
stage.show(root)
