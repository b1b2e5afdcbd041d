-- Reflection: a tall mirror, a perfect mirror ball and a half mirror between coloured things.
-- Look at: the mirror shows the backs of the things before it and the brick pillars behind the camera;
-- the ball bends all of it, the mirror included; the plum ball mixes half its own colour with what it
-- mirrors.

local chalk = gr.material({0.72, 0.70, 0.66}, {0.05, 0.05, 0.05}, 10)
local black = gr.material({0.02, 0.02, 0.02}, {0.60, 0.60, 0.60}, 200)
local plum = gr.material({0.45, 0.12, 0.30}, {0.60, 0.60, 0.60}, 120)
local coral = gr.material({0.85, 0.35, 0.25}, {0.20, 0.20, 0.20}, 30)
local teal = gr.material({0.10, 0.48, 0.50}, {0.25, 0.25, 0.25}, 40)
local amber = gr.material({0.88, 0.60, 0.18}, {0.30, 0.30, 0.30}, 50)
local frame = gr.material({0.32, 0.20, 0.11}, {0.20, 0.20, 0.20}, 30)

local root = gr.node('root')

local floor = gr.mesh('floor', 'ground.obj')
floor:scale(160, 160, 160)
floor:rotate('y', 20)
root:add_child(floor, nil, gr.texture('checker.png', {0.1, 0.1, 0.1}, 20))

-- The mirror stands behind the things, a little turned.
local stand = gr.node('stand')
local glass = gr.nh_box('glass', {-2.6, 0.15, -0.05}, {5.2, 3.1, 0.05})
glass:set_reflection(0)
stand:add_child(glass, black)
stand:add_child(gr.nh_box('left', {-2.8, 0, -0.1}, {0.2, 3.45, 0.15}), frame)
stand:add_child(gr.nh_box('right', {2.6, 0, -0.1}, {0.2, 3.45, 0.15}), frame)
stand:add_child(gr.nh_box('top', {-2.6, 3.25, -0.1}, {5.2, 0.2, 0.15}), frame)
stand:add_child(gr.nh_box('bottom', {-2.6, 0, -0.1}, {5.2, 0.15, 0.15}), frame)
stand:rotate('y', 10)
stand:translate(0.3, 0, -3)
root:add_child(stand)

local chrome = gr.nh_sphere('chrome', {-1.9, 1, 0.1}, 1)
chrome:set_reflection(0)
root:add_child(chrome, black)

local half = gr.nh_sphere('half', {1.9, 0.8, 0.5}, 0.8)
half:set_reflection(0.5)
root:add_child(half, plum)

root:add_child(gr.nh_cylinder('drum', {0.2, 0, -0.9}, 1.3, 0.45), teal)
root:add_child(gr.nh_sphere('pearl', {0.35, 0.3, 1.3}, 0.3), amber)
local cone = gr.nh_cone('cone', {0, 0, 0}, 1.5, 0.5)
cone:rotate('x', 180)
cone:translate(2.6, 1.5, -1.3)
root:add_child(cone, coral)
root:add_child(gr.nh_box('block', {-0.9, 0, 1.4}, {0.5, 0.5, 0.5}), chalk)

-- Behind the camera: what only mirrors see.
local bricks = gr.texture('bricks.png', {0.05, 0.05, 0.05}, 10)
for i, x in ipairs({-9, -4.5, 4.5, 9}) do
    local pillar = gr.nh_box('pillar ' .. i, {x - 0.9, 0, 11}, {1.8, 7, 1.8})
    root:add_child(pillar, nil, bricks)
end
root:add_child(gr.nh_box('lintel', {-11, 7, 10.8}, {22, 1, 2.2}), chalk)

gr.background({0.80, 0.80, 0.78}, {0.35, 0.50, 0.72})
gr.render(root, 'reflection.png', 800, 450, {-0.6, 2.3, 7.2}, {0.07, -0.19, -1}, {0, 1, 0}, 40,
          {0.30, 0.30, 0.32}, {gr.light({-5, 9, 6}, {0.75, 0.72, 0.66}, {1, 0, 0}, 0.8)})
