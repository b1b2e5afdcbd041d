-- Bump maps: the same brick wall without (left) and with (right) its normal map, studs on a ball, and
-- ripples, a height map, on a pond that mirrors.
-- Look at: the bricks' edges catch the light from the upper left; the shapes' outlines stay as they
-- are; the reflections in the pond are broken by ripples that are not there.

local bricks = gr.texture('bricks.png', {0.10, 0.10, 0.10}, 20)
local relief = gr.bumpmap('bricks_normal.png')
local studs = gr.bumpmap('studs_normal.png')
local ripples = gr.bumpmap('ripples_height.png')

local brass = gr.material({0.70, 0.50, 0.18}, {0.55, 0.50, 0.35}, 60)
local deep = gr.material({0.06, 0.14, 0.18}, {0.40, 0.40, 0.40}, 150)
local cap = gr.material({0.62, 0.60, 0.56}, {0.05, 0.05, 0.05}, 10)

local root = gr.node('root')

root:add_child(gr.nh_box('flat wall', {-4.2, 0, -1.4}, {4.0, 4.0, 0.4}), nil, bricks)
root:add_child(gr.nh_box('bumpy wall', {0.2, 0, -1.4}, {4.0, 4.0, 0.4}), nil, bricks, relief)
root:add_child(gr.nh_box('pier', {-0.2, 0, -1.5}, {0.4, 4.2, 0.6}), cap)

local ball = gr.sphere('ball')
ball:rotate('y', 20)
ball:scale(0.85, 0.85, 0.85)
ball:translate(1.7, 0.95, 0.6)
root:add_child(ball, brass, nil, studs)

local plain = gr.sphere('plain ball')
plain:scale(0.85, 0.85, 0.85)
plain:translate(-1.9, 0.95, 0.6)
root:add_child(plain, brass)

local pond = gr.mesh('pond', 'ground.obj')
pond:scale(100, 100, 100)
pond:translate(0, -0.01, 0)
pond:set_reflection(0.45)
root:add_child(pond, deep, nil, ripples)

root:add_child(gr.nh_cylinder('left foot', {-1.9, -0.1, 0.6}, 0.25, 0.5), cap)
root:add_child(gr.nh_cylinder('right foot', {1.7, -0.1, 0.6}, 0.25, 0.5), cap)

gr.background({0.70, 0.74, 0.78}, {0.36, 0.52, 0.76})
gr.render(root, 'bump_map.png', 800, 450, {-0.4, 2.2, 7.6}, {0.05, -0.09, -1}, {0, 1, 0}, 36,
          {0.30, 0.31, 0.34}, {gr.light({-6, 7, 5}, {0.75, 0.72, 0.66}, {1, 0, 0}, 0.4)})
