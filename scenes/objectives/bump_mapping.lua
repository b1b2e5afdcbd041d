-- Bump mapping: an iron kettle, a leather ball and a mat before a wall of bricks, in light that grazes.
-- Look at: joints, hail dots, studs and straw that catch the light on one side and lose it on the other, while
-- every outline stays what it was.
-- Without: the same textures, flat.   ./Project scenes/objectives/bump_mapping.lua -D without=true

local without = gr.param('without', false, {doc = 'no bump maps'})
local function bump(file) return not without and gr.bumpmap(file) or nil end

local root = gr.node('root')

local bricks, relief = gr.texture('bricks.png', {0.08, 0.08, 0.08}, 12), bump('bricks_normal.png')
for k = -2, 2 do
    root:add_child(gr.nh_box('wall ' .. k, {0.7 * k - 0.35, 0, -0.62}, {0.7, 0.7, 0.1}), nil, bricks, relief)
end

local straw = gr.mesh('mat', 'room_sheet_5x4.obj')
straw:scale(2.4, 1.9, 1)
straw:rotate('x', -90)
straw:translate(0, 0, 0.40)
root:add_child(straw, nil, gr.texture('room_tatami.png', {0.08, 0.08, 0.06}, 10), bump('room_tatami_normal.png'))

local iron, hail = gr.texture('room_iron.png', {0.34, 0.34, 0.36}, 24), bump('room_iron_normal.png')
local kettle = gr.node('kettle')
kettle:add_child(gr.mesh('body', 'room_kettle.obj'), nil, iron, hail)
for _, part in ipairs{'lid', 'spout', 'handle'} do
    kettle:add_child(gr.mesh(part, 'room_kettle_' .. part .. '.obj'), nil, iron)
end
kettle:scale(1.25, 1.25, 1.25)
kettle:rotate('y', 28)
kettle:translate(-0.20, 0, -0.12)
root:add_child(kettle)

local ball = gr.sphere('ball')
ball:scale(0.115, 0.115, 0.115)
ball:rotate('x', 30)
ball:rotate('y', -40)
ball:translate(0.19, 0.115, -0.06)
root:add_child(ball, gr.material({0.60, 0.23, 0.12}, {0.38, 0.33, 0.30}, 40), nil, bump('studs_normal.png'))

local log = gr.cylinder('log')
log:scale(0.052, 0.15, 0.052)
log:rotate('x', 90)
log:rotate('y', 62)
log:translate(0.28, 0.052, 0.22)
root:add_child(log, nil, gr.texture('room_bark.png', {0.05, 0.05, 0.05}, 8), bump('room_bark_normal.png'))

local cushion = gr.mesh('cushion', 'room_cushion.obj', {smooth = 60})
cushion:scale(0.30, 0.42, 0.30)
cushion:rotate('y', 22)
cushion:translate(-0.36, 0.034, 0.15)
root:add_child(cushion, nil, gr.texture('room_indigo.png', {0.04, 0.04, 0.04}, 6), bump('room_weave_normal.png'))

gr.background({0.20, 0.18, 0.17}, {0.46, 0.48, 0.52})
gr.render(root, 'bump_mapping.png', 1280, 720, {0.0, 0.40, 1.12}, {-0.02, -0.27, -1}, {0, 1, 0}, 31, {0.20, 0.20, 0.22},
          {gr.light({-1.9, 0.95, -0.05}, {0.95, 0.80, 0.58}, {0.5, 0, 0.16}, 0.10),
           gr.light({1.4, 1.6, 1.6}, {0.22, 0.25, 0.31}, {1, 0, 0}, 0.3)})
