-- A half-infinite screen between the floor and a light of radius 1, seen straight from above.
-- Right, because: the light's centre is 8 above the floor at x = 0 and the screen's edge 4 above it at
-- x = 0, so the penumbra reaches from x = -1 to 1, a quarter of the picture's 8, with half the
-- light at x = 0; the right part is black but for the ambient 0.1, the left one has no shadow.
-- The ball on the left is lit as by a point light.

gr.options{spp = 16}

local m = gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 1)
local root = gr.node('root')
root:add_child(gr.nh_box('floor', {-50, -1, -50}, {100, 1, 100}), m)
root:add_child(gr.nh_box('screen', {0, 4, -50}, {60, 0.001, 100}), m)
root:add_child(gr.nh_sphere('ball', {-2.6, 0.8, 0}, 0.8), gr.material({0.8, 0.3, 0.2}, {0.3, 0.3, 0.3}, 20))

gr.render(root, 'soft_shadow.png', 128, 64, {0, 3.9, 0}, {0, -1, 0}, {0, 0, -1}, 54.34, {0.1, 0.1, 0.1},
          {gr.light({0, 8, 0}, {1, 1, 1}, {1, 0, 0}, 1)})
