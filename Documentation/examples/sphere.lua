-- gr.sphere: radius 1 about the origin, here moved up to stand on the floor.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local ball = gr.sphere('ball')
ball:translate(0, 1, 0)
root:add_child(ball, stage.red)
stage.show(root)
