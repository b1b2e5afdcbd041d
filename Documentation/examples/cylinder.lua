-- gr.cylinder: radius 1, from y = -1 to y = 1.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local drum = gr.cylinder('drum')
drum:scale(0.9, 0.9, 0.9)
drum:translate(0, 0.9, 0)
root:add_child(drum, stage.green)
stage.show(root)
