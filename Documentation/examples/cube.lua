-- gr.cube: from (0,0,0) to (1,1,1), here turned.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local cube = gr.cube('cube')
cube:translate(-0.5, 0, -0.5)
cube:scale(1.5, 1.5, 1.5)
cube:rotate('y', 30)
root:add_child(cube, stage.blue)
stage.show(root)
