-- Fresnel reflection: a pool 0.8 deep over checks, with balls in it.
-- Look at: near the feet the water is clear and shows the bottom; towards the horizon it becomes a
-- mirror of the sky and the balls. The glass ball on the left does without Fresnel's law, the one on
-- the right follows it: only that one has the bright rim.

local clear = gr.material({0.02, 0.02, 0.02}, {0.70, 0.70, 0.70}, 400)
local orange = gr.material({0.90, 0.42, 0.10}, {0.30, 0.30, 0.30}, 50)
local white = gr.material({0.80, 0.80, 0.78}, {0.20, 0.20, 0.20}, 30)
local stone = gr.material({0.55, 0.54, 0.52}, {0.05, 0.05, 0.05}, 10)

local root = gr.node('root')

local bottom = gr.mesh('bottom', 'ground.obj')
bottom:scale(320, 320, 320)
bottom:rotate('y', 15)
bottom:translate(0, -0.8, 0)
root:add_child(bottom, nil, gr.texture('checker.png', {0, 0, 0}, 1))

local water = gr.nh_box('water', {-600, -0.9, -600}, {1200, 0.9, 1200})
water:set_refraction(1.33, 0)
water:set_fresnel(true)
root:add_child(water, clear)

root:add_child(gr.nh_sphere('float', {0.1, 0.15, -2.4}, 0.6), orange)
root:add_child(gr.nh_sphere('far', {4.8, 0.3, -9}, 0.9), white)
root:add_child(gr.nh_sphere('farther', {-7, 0.3, -16}, 1.2), orange)
root:add_child(gr.nh_cylinder('left stone', {-1.7, -0.85, -0.4}, 1.0, 0.6), stone)
root:add_child(gr.nh_cylinder('right stone', {1.7, -0.85, -0.4}, 1.0, 0.6), stone)

local plain = gr.nh_sphere('plain', {-1.7, 0.75, -0.4}, 0.6)
plain:set_refraction(1.5, 0)
root:add_child(plain, clear)
local real = gr.nh_sphere('real', {1.7, 0.75, -0.4}, 0.6)
real:set_refraction(1.5, 0)
real:set_fresnel(true)
root:add_child(real, clear)

gr.background('sky.png')
gr.render(root, 'fresnel.png', 800, 450, {0, 1.25, 5.2}, {0, -0.19, -1}, {0, 1, 0}, 42,
          {0.40, 0.42, 0.45}, {gr.light({40, 30, -20}, {0.60, 0.57, 0.50}, {1, 0, 0}, 1)})
