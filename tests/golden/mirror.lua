-- A perfect mirror on the right wall, a half mirror on the floor, a mirror ball, and a red ball.
-- Right, because: the red ball has a twin in the wall, as far behind the wall's edge as it lies before
-- it, at full strength; the floor's twins have half their colour; the mirror ball shows the red ball
-- and its twin in the wall on its right, and the floor in its lower half.

gr.options{spp = 16}

local grey = gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 1)
local root = gr.node('root')
local wall = gr.nh_box('wall', {2, 0, -4}, {0.2, 4, 8})
wall:set_reflection(0)
root:add_child(wall, grey)
local floor = gr.nh_box('floor', {-4, -0.2, -4}, {8, 0.2, 8})
floor:set_reflection(0.5)
root:add_child(floor, grey)
root:add_child(gr.nh_sphere('red', {0.9, 0.6, 0}, 0.6), gr.material({0.8, 0.2, 0.15}, {0.4, 0.4, 0.4}, 30))
local ball = gr.nh_sphere('ball', {-1.3, 1, 0}, 1)
ball:set_reflection(0)
root:add_child(ball, grey)

gr.background({0.15, 0.2, 0.4}, {0.7, 0.8, 0.9})
gr.render(root, 'mirror.png', 120, 80, {-0.6, 2, 8}, {0.08, -0.14, -1}, {0, 1, 0}, 32, {0.4, 0.4, 0.4},
          {gr.light({-4, 6, 6}, {0.6, 0.6, 0.6}, {1, 0, 0})})
