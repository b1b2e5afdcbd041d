-- gr.torus: about z, so it stands; R = 1, and r = 0.25 and 0.45.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local thin, thick = gr.torus('thin'), gr.torus('thick', 1, 0.45)
thin:scale(0.75, 0.75, 0.75)
thin:translate(-1.3, 0.94, 0)
thick:scale(0.65, 0.65, 0.65)
thick:rotate('x', 90)
thick:translate(1.3, 0.3, 0)
root:add_child(thin, stage.gold)
root:add_child(thick, stage.red)
stage.show(root)
