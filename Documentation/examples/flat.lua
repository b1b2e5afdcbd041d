-- The half ball, the disc and the quad as they are, on a plane that was moved down.
local stage = require 'stage'
local root = gr.node('root')
local ground = gr.plane('ground')
ground:translate(0, -0.01, 0)
root:add_child(ground, stage.white)
local function at(x, node, material)
  node:translate(x, 0.2, 0)
  root:add_child(node, material)
end
at(-2.2, gr.hemisphere('half'), stage.red)
at(0.2, gr.disc('disc'), stage.gold)
at(1.8, gr.quad('quad'), stage.green)
stage.show(root)
