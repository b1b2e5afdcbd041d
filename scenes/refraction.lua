-- Refraction: a glass ball, and a glass of water with a straw in it.
-- Look at: the ball shows the scene upside down; the straw breaks at the water's surface; the water
-- makes the straw and the checks behind it wider; shadows of glass are lighter, and darker at the rim.

local clear = gr.material({0.02, 0.02, 0.02}, {0.70, 0.70, 0.70}, 400)
local red = gr.material({0.80, 0.16, 0.12}, {0.30, 0.30, 0.30}, 40)
local blue = gr.material({0.18, 0.34, 0.66}, {0.30, 0.30, 0.30}, 40)
local green = gr.material({0.30, 0.55, 0.25}, {0.20, 0.20, 0.20}, 30)

local root = gr.node('root')

local top = gr.nh_box('table', {-5.2, -0.3, -5.2}, {10.4, 0.3, 10.4})
top:rotate('y', 28)
root:add_child(top, nil, gr.texture('checker.png', {0, 0, 0}, 1))

local ball = gr.nh_sphere('ball', {-1.5, 0.95, 0.2}, 0.95)
ball:set_refraction(1.5, 0)
ball:set_fresnel(true)
root:add_child(ball, clear)

local straw = gr.cylinder('straw')
straw:scale(0.045, 0.95, 0.045)
straw:rotate('z', -22)
straw:translate(-0.015, 1.035, 0.05)

-- The water is created before the glass: where the two overlap, the index of glass holds.
local drink = gr.node('drink')
local water = gr.mesh('water', 'water.obj')
water:set_refraction(1.33, 0)
water:set_fresnel(true)
local tumbler = gr.mesh('tumbler', 'tumbler.obj')
tumbler:set_refraction(1.5, 0)
tumbler:set_fresnel(true)
drink:add_child(water, clear)
drink:add_child(tumbler, clear)
drink:add_child(straw, red)
drink:scale(1.4, 1.4, 1.4)
drink:translate(1.35, 0, 0.3)
root:add_child(drink)

root:add_child(gr.nh_sphere('blue', {-2.9, 0.7, -3.2}, 0.7), blue)
root:add_child(gr.nh_sphere('green', {0.1, 0.5, -2.6}, 0.5), green)
root:add_child(gr.nh_box('red', {2.6, 0, -4.2}, {1.3, 1.3, 1.3}), red)

gr.background({0.82, 0.82, 0.80}, {0.40, 0.55, 0.75})
gr.render(root, 'refraction.png', 800, 450, {0, 2.0, 6.6}, {0, -0.17, -1}, {0, 1, 0}, 38,
          {0.35, 0.35, 0.37}, {gr.light({-5, 8, 3}, {0.68, 0.66, 0.60}, {1, 0, 0}, 0.6)})
