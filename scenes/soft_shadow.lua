-- Soft shadows: a warm light of radius 1.2 and a cool one of radius 0.5.
-- Look at: each shadow is sharp where it touches its object and wider the farther it falls; the warm
-- light's shadows are the softer and cooler ones; the lattice's bars melt into each other far away.

local plaster = gr.material({0.86, 0.84, 0.80}, {0.00, 0.00, 0.00}, 1)
local clay = gr.material({0.84, 0.36, 0.20}, {0.25, 0.25, 0.25}, 30)
local sage = gr.material({0.42, 0.62, 0.40}, {0.25, 0.25, 0.25}, 30)
local ink = gr.material({0.16, 0.26, 0.50}, {0.30, 0.30, 0.30}, 50)

local root = gr.node('root')
root:add_child(gr.nh_box('ground', {-30, -1, -30}, {60, 1, 60}), plaster)
root:add_child(gr.nh_box('wall', {-30, 0, -5}, {60, 20, 1}), plaster)

root:add_child(gr.nh_sphere('ball', {-1.2, 0.7, 0.4}, 0.7), clay)
root:add_child(gr.nh_cylinder('pole', {-3.0, 0, -1.0}, 2.6, 0.12), ink)
root:add_child(gr.nh_sphere('knob', {-3.0, 2.75, -1.0}, 0.25), clay)

local bar = gr.nh_cylinder('bar', {0, 0, 0}, 2.2, 0.05)
local lattice = gr.node('lattice')
for i = 0, 7 do
    local place = gr.node('place ' .. i)
    place:add_child(bar, ink)
    place:translate(0.28 * i, 0, 0)
    lattice:add_child(place)
end
local rail = gr.nh_box('rail', {-0.12, 2.15, -0.08}, {2.2, 0.12, 0.16})
lattice:add_child(rail, ink)
lattice:rotate('y', -25)
lattice:translate(0.9, 0, -1.2)
root:add_child(lattice)

local ring = gr.torus('ring', 0.55, 0.14)
ring:rotate('y', 35)
ring:translate(1.1, 0.69, 1.2)
root:add_child(ring, sage)

gr.render(root, 'soft_shadow.png', 800, 450, {-0.3, 3.2, 7.6}, {0.02, -0.29, -1}, {0, 1, 0}, 34,
          {0.17, 0.17, 0.19},
          {gr.light({-5, 7, 6}, {0.80, 0.70, 0.54}, {1, 0, 0}, 1.2),
           gr.light({4.5, 6, 5}, {0.30, 0.40, 0.56}, {1, 0, 0}, 0.5)})
