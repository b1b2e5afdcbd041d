-- Primitives: ball, cube, cylinder, cone and torus in the back row, scaled, mirrored, sheared and turned in
-- the middle row, the nh_ forms with their own measures in front.
-- Look at: round rims, caps, no gaps to the floor; the spindle torus in front shows its inner lemon
-- at the dimple; shadows keep to their objects.

local ground = gr.material({0.66, 0.64, 0.60}, {0.03, 0.03, 0.03}, 10)
local back = gr.material({0.24, 0.42, 0.62}, {0.35, 0.35, 0.35}, 50)
local middle = gr.material({0.78, 0.50, 0.20}, {0.35, 0.35, 0.35}, 50)
local front = gr.material({0.66, 0.22, 0.22}, {0.35, 0.35, 0.35}, 50)

local root = gr.node('root')
root:add_child(gr.nh_box('ground', {-40, -1, -40}, {80, 1, 80}), ground)

local function put(node, material, x, y, z)
    node:translate(x, y, z)
    root:add_child(node, material)
end

put(gr.sphere('sphere'), back, -5, 1, -4.5)
put(gr.cube('cube'), back, -2.9, 0, -5)
put(gr.cylinder('cylinder'), back, 0, 1, -4.5)
put(gr.cone('cone'), back, 2.9, 0, -4.5)
local ring = gr.torus('torus')
put(ring, back, 5.6, 1.25, -4.5)

local egg = gr.sphere('egg')
egg:scale(0.5, 0.9, 0.5)
egg:rotate('z', 35)
put(egg, middle, -4.8, 0.79, -0.4)

-- A shear: turned by 45 degrees, scaled, and turned back.
local sheared = gr.cube('sheared')
sheared:translate(-0.5, 0, -0.5)
sheared:rotate('z', 45)
sheared:scale(1, 1.6, 1)
sheared:rotate('z', -32)
put(sheared, middle, -2.8, 0.62, -0.6)

local column = gr.cylinder('column')
column:scale(0.35, 0.8, 0.7)
column:rotate('y', 30)
put(column, middle, -0.9, 0.8, -0.6)

local roof = gr.cone('roof')
roof:scale(0.9, -1.6, 0.9)
put(roof, middle, 1.1, 1.6, -0.6)

local hoop = gr.torus('hoop', 0.7, 0.12)
hoop:scale(1, 0.72, 1)
hoop:rotate('x', -15)
put(hoop, middle, 3.2, 0.6, -0.6)

root:add_child(gr.nh_sphere('nh_sphere', {-4.0, 0.6, 2.6}, 0.6), front)
root:add_child(gr.nh_box('nh_box', {-2.5, 0, 2.2}, {1.3, 0.5, 0.8}), front)
root:add_child(gr.nh_cylinder('nh_cylinder', {-0.1, 0, 2.6}, 0.9, 0.4), front)
local top = gr.nh_cone('nh_cone', {1.6, 0, 2.6}, 1.0, 0.5)
root:add_child(top, front)
local spindle = gr.nh_torus('nh_torus', {0, 0, 0}, 0.3, 0.45)
spindle:rotate('x', -60)
put(spindle, front, 3.6, 0.6, 2.6)

gr.background({0.60, 0.62, 0.66}, {0.36, 0.46, 0.60})
gr.render(root, 'primitives.png', 800, 450, {0, 7.0, 10.5}, {0, -0.62, -1}, {0, 1, 0}, 36,
          {0.32, 0.32, 0.35}, {gr.light({-6, 10, 8}, {0.90, 0.86, 0.76}, {1, 0, 0}, 0.7)})
