-- One ball under five places, each with an appearance of its own.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local ball = gr.nh_sphere('ball', {0, 0.5, 0}, 0.5)
local looks = {{stage.red}, {stage.gold}, {nil, stage.grid}, {stage.blue},
               {stage.gold, nil, gr.bumpmap('studs_normal.png')}}
for i = 1, 5 do
  local place = gr.node('place ' .. i)
  place:add_child(ball, looks[i][1], looks[i][2], looks[i][3])
  place:translate(1.15 * (i - 3), 0, 0)
  root:add_child(place)
end
stage.show(root)
