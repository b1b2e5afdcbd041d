-- A mesh from a file, and a pyramid from tables.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local vase = gr.mesh('vase', 'vase.obj')
vase:scale(0.8, 0.8, 0.8)
vase:translate(-1, 0, 0)
root:add_child(vase, stage.blue)
local pyramid = gr.mesh('pyramid', {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 1.6, 0}},
                        {{0, 1, 2, 3}, {4, 1, 0}, {4, 2, 1}, {4, 3, 2}, {4, 0, 3}})
pyramid:scale(0.8, 0.8, 0.8)
pyramid:rotate('y', 25)
pyramid:translate(1.2, 0, 0)
root:add_child(pyramid, stage.gold)
stage.show(root)
