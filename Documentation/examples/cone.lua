-- gr.cone: its apex at the origin, radius 1 at y = 1; the left one as it is, the right one turned over.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local up, down = gr.cone('up'), gr.cone('down')
up:scale(0.9, 1.7, 0.9)
up:translate(-1.2, 0, 0)
down:scale(0.9, -1.7, 0.9)
down:translate(1.2, 1.7, 0)
root:add_child(up, stage.gold)
root:add_child(down, stage.gold)
stage.show(root)
