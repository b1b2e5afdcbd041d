-- The grid, in which red grows with u and green with v, on a box, a ball, a cylinder and a ring; studs
-- from a normal map on a ball, and a height map on a box.
-- Right, because: every face of the box shows one whole square with dark corners at (0,0); on the ball
-- green grows towards the north pole and the strong lines are the equator and two meridians; the
-- studs and ripples are bright on the side of the light, the upper left, as bumps are and dents are
-- not.

gr.options{spp = 16}

local grid = gr.texture('uv_grid.png', {0, 0, 0}, 1)
local m = gr.material({0.7, 0.6, 0.4}, {0.3, 0.3, 0.3}, 30)
local root = gr.node('root')

local function put(node, x, y, ...)
    node:rotate('y', 30)
    node:rotate('x', 25)
    node:translate(x, y, 0)
    root:add_child(node, ...)
end

put(gr.nh_box('box', {-0.75, -0.75, -0.75}, 1.5), -2.6, 1.25, nil, grid)
put(gr.sphere('ball'), 0, 1.25, nil, grid)
local drum = gr.cylinder('drum')
drum:scale(0.8, 0.8, 0.8)
put(drum, 2.6, 1.25, nil, grid)
local ring = gr.torus('ring', 0.75, 0.3)
put(ring, -2.6, -1.25, nil, grid)
put(gr.sphere('studs'), 0, -1.25, m, nil, gr.bumpmap('studs_normal.png'))
put(gr.nh_box('ripples', {-0.75, -0.75, -0.75}, 1.5), 2.6, -1.25, m, nil, gr.bumpmap('ripples_height.png'))

gr.render(root, 'textures.png', 150, 100, {0, 0, 30}, {0, 0, -1}, {0, 1, 0}, 10, {0.35, 0.35, 0.35},
          {gr.light({-20, 20, 30}, {0.7, 0.7, 0.7}, {1, 0, 0})})
