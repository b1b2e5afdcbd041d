-- Textures: the same grid on every shape; red grows with u, green with v, strong lines mark 0, 1/2, 1.
-- Look at: lines that meet at every seam; the poles of the ball; the inscribed squares on the caps;
-- the planks of the floor, sharp in front and quiet at the back.

local grid = gr.texture('uv_grid.png', {0.25, 0.25, 0.25}, 50)

local root = gr.node('root')
local floor = gr.mesh('floor', 'ground.obj')
floor:scale(96, 96, 96)
floor:rotate('y', 12)
root:add_child(floor, nil, gr.texture('planks.png', {0.10, 0.10, 0.10}, 30))

local function put(node, x, y, z)
    node:translate(x, y, z)
    root:add_child(node, nil, grid)
end

local ball = gr.sphere('ball')
ball:rotate('x', 25)
ball:rotate('y', -60)
put(ball, -3.3, 1, 0)

local box = gr.nh_box('box', {-0.7, 0, -0.7}, {1.4, 1.4, 1.4})
box:rotate('y', 35)
put(box, -1.0, 0, 0.2)

local drum = gr.cylinder('drum')
drum:scale(0.75, 0.8, 0.75)
drum:rotate('y', 40)
put(drum, 1.1, 0.8, 0.1)

local cone = gr.cone('cone')
cone:scale(0.9, 1.9, 0.9)
cone:rotate('x', 180)
cone:rotate('y', 100)
put(cone, 3.3, 1.9, -0.1)

local ring = gr.torus('ring', 0.6, 0.26)
ring:rotate('x', -75)
put(ring, -0.2, 0.42, 2.1)

local vase = gr.mesh('vase', 'vase.obj')
vase:rotate('y', 200)
put(vase, 0.1, 0, -2.2)

gr.background({0.70, 0.72, 0.74}, {0.45, 0.58, 0.75})
gr.render(root, 'texture.png', 800, 450, {0, 3.2, 8.6}, {0, -0.27, -1}, {0, 1, 0}, 36,
          {0.40, 0.40, 0.42}, {gr.light({-4, 9, 7}, {0.62, 0.60, 0.55}, {1, 0, 0}, 0.8)})
