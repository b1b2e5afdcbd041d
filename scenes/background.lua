-- Backgrounds: a panorama of the whole sky, seen directly, mirrored and through glass.
-- Look at: the sky's seam behind the camera, invisible in the mirror ball; the glass ball turns the
-- sky upside down; the light comes from the sun's place in the picture.

local black = gr.material({0.02, 0.02, 0.02}, {0.50, 0.50, 0.50}, 300)
local clay = gr.material({0.86, 0.36, 0.22}, {0.10, 0.10, 0.10}, 20)
local sand = gr.material({0.84, 0.78, 0.64}, {0, 0, 0}, 1)

local root = gr.node('root')
root:add_child(gr.nh_cylinder('island', {0, -0.6, 0}, 0.6, 4.2), sand)

local chrome = gr.nh_sphere('chrome', {-1.35, 1.2, 0}, 1.2)
chrome:set_reflection(0)
root:add_child(chrome, black)

local glass = gr.nh_sphere('glass', {1.5, 0.9, 0.7}, 0.9)
glass:set_refraction(1.5, 0)
glass:set_fresnel(true)
root:add_child(glass, black)

root:add_child(gr.nh_cylinder('post', {0.7, 0, -1.8}, 1.5, 0.25), clay)
root:add_child(gr.nh_sphere('knob', {0.7, 1.75, -1.8}, 0.38), clay)

-- The panorama's sun: 43.2 degrees right of -z, 24 degrees high.
local a, h = math.rad(43.2), math.rad(24)
local far = 200
local sun = {far * math.sin(a) * math.cos(h), far * math.sin(h), -far * math.cos(a) * math.cos(h)}

gr.background('sky.png')
gr.render(root, 'background.png', 800, 450, {-0.2, 1.7, 7.5}, {0.06, -0.03, -1}, {0, 1, 0}, 44,
          {0.46, 0.48, 0.52}, {gr.light(sun, {0.85, 0.80, 0.66}, {1, 0, 0}, 4)})
