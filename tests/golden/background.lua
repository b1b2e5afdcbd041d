-- The grid as a panorama all around, with a mirror ball in its middle.
-- Right, because: red grows with u from left to right and green with v upwards; the picture's centre
-- looks along -z, so the two strong lines u = 1/2 and v = 1/2 cross there; 90 degrees are seen from top to
-- bottom, which is half of v: green goes from 0.25 to 0.75. Lines of equal latitude bend. In the ball's
-- middle is the seam at +z, u = 0 beside u = 1.

gr.options{spp = 16}

local ball = gr.nh_sphere('ball', {0, 0, -6}, 1.2)
ball:set_reflection(0)
local root = gr.node('root')
root:add_child(ball, gr.material({0, 0, 0}, {0, 0, 0}, 1))

gr.background('uv_grid.png')
gr.render(root, 'background.png', 128, 96, {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90, {0, 0, 0},
          {gr.light({0, 9, 0}, {1, 1, 1}, {1, 0, 0})})
