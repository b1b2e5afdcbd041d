-- First light: every hand-written primitive on one table, two point lights, hard shadows.
-- Look at: the shadows that meet their objects without a gap, the highlights, the round rims.

local ivory = gr.material({0.75, 0.70, 0.60}, {0.10, 0.10, 0.10}, 20)
local slate = gr.material({0.40, 0.44, 0.50}, {0.05, 0.05, 0.05}, 10)
local brick = gr.material({0.70, 0.25, 0.18}, {0.30, 0.30, 0.30}, 40)
local moss = gr.material({0.30, 0.50, 0.22}, {0.20, 0.20, 0.20}, 25)
local honey = gr.material({0.85, 0.58, 0.15}, {0.60, 0.60, 0.50}, 90)
local sky = gr.material({0.25, 0.45, 0.70}, {0.50, 0.50, 0.50}, 60)

local root = gr.node('root')
root:add_child(gr.nh_box('table', {-8, -1, -8}, {16, 1, 16}), ivory)

root:add_child(gr.nh_sphere('ball', {-2.1, 1.0, -0.6}, 1.0), brick)
root:add_child(gr.nh_cylinder('drum', {0.4, 0.0, -1.6}, 1.6, 0.8), sky)

local cone = gr.cone('cone')
cone:scale(0.9, 1.9, 0.9)
cone:rotate('x', 180)
cone:translate(2.6, 1.9, -0.9)
root:add_child(cone, moss)

local ring = gr.torus('ring', 0.75, 0.25)
ring:rotate('x', 90)
ring:translate(0.9, 0.25, 0.9)
root:add_child(ring, honey)

local cube = gr.cube('cube')
cube:rotate('y', 32)
cube:translate(-1.55, 0, 1.1)
cube:scale(0.9, 0.9, 0.9)
root:add_child(cube, slate)

local pearl = gr.nh_sphere('pearl', {0.9, 0.35, 0.9}, 0.35)
root:add_child(pearl, ivory)

gr.background({0.10, 0.12, 0.16}, {0.35, 0.45, 0.60})

gr.render(root, 'first_light.png', 800, 450,
          {0.3, 3.4, 7.5}, {-0.02, -0.36, -1}, {0, 1, 0}, 36,
          {0.25, 0.25, 0.28},
          {gr.light({-6, 8, 5}, {0.75, 0.70, 0.62}, {1, 0, 0}),
           gr.light({5, 5, 6}, {0.22, 0.26, 0.34}, {1, 0, 0})})
