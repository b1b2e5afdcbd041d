-- A checkered floor to the horizon: seen directly, in a mirror, in a mirror ball, and through a slab and
-- a ball of glass.
-- Look at: the checks end in an even grey, without sparkle or moire, also in the mirror and through the
-- slab, which shifts them and leaves them as sharp; near the camera their edges are crisp.

local checks = gr.texture('checker.png', {0.05, 0.05, 0.05}, 20)
local frame = gr.material({0.45, 0.28, 0.16}, {0.20, 0.20, 0.20}, 30)
local silver = gr.material({0.8, 0.8, 0.82}, {0.4, 0.4, 0.4}, 120)
local clear = gr.material({0.8, 0.9, 0.9}, {0.5, 0.5, 0.5}, 120)

local root = gr.node('root')
local floor = gr.mesh('floor', 'ground.obj')
floor:scale(320, 320, 320)
floor:rotate('y', 24)
root:add_child(floor, nil, checks)

local stand = gr.node('mirror')
local pane = gr.nh_box('pane', {-1.5, 0.15, 0}, {3.0, 2.3, 0.05})
pane:set_reflection(0.06)
stand:add_child(pane, silver)
stand:add_child(gr.nh_box('left', {-1.65, 0, -0.05}, {0.15, 2.6, 0.15}), frame)
stand:add_child(gr.nh_box('right', {1.5, 0, -0.05}, {0.15, 2.6, 0.15}), frame)
stand:add_child(gr.nh_box('top', {-1.5, 2.45, -0.05}, {3.0, 0.15, 0.15}), frame)
stand:add_child(gr.nh_box('bottom', {-1.5, 0, -0.05}, {3.0, 0.15, 0.15}), frame)
stand:rotate('y', 28)
stand:translate(-3.4, 0, -1.2)
root:add_child(stand)

local slab = gr.nh_box('slab', {-0.6, 0, -0.35}, {1.2, 2.2, 0.7})
slab:set_refraction(1.5, 0.04)
slab:rotate('y', -30)
slab:translate(0.4, 0, 0.2)
root:add_child(slab, clear)

local ball = gr.nh_sphere('ball', {2.5, 0.9, 0.4}, 0.9)
ball:set_reflection(0.08)
root:add_child(ball, silver)

local drop = gr.nh_sphere('drop', {1.35, 0.45, 2.2}, 0.45)
drop:set_refraction(1.5, 0.04)
root:add_child(drop, clear)

gr.background({0.86, 0.87, 0.88}, {0.40, 0.56, 0.80})
gr.render(root, 'textured_floor.png', 800, 450, {0, 1.7, 7.5}, {-0.02, -0.07, -1}, {0, 1, 0}, 38,
          {0.40, 0.40, 0.42}, {gr.light({-5, 9, 7}, {0.60, 0.58, 0.54}, {1, 0, 0}, 0.6)})
