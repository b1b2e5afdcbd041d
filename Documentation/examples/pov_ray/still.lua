-- still.pov, line by line: see from_pov_ray.md.
local scene = gr.node('scene')
local function matt(c, highlight, size)
  local d = {0.8 * c[1], 0.8 * c[2], 0.8 * c[3]}
  return gr.material(d, {highlight or 0, highlight or 0, highlight or 0}, size or 40)
end

scene:add_child(gr.nh_plane('plane', {0, 0, 0}, {0, 1, 0}), matt{0.7, 0.68, 0.62})

local egg = gr.sphere('egg')
egg:scale(0.8, 1.1, 0.8)
egg:translate(-2, 1.1, -0.5)
scene:add_child(egg, matt({0.8, 0.25, 0.15}, 0.5, 40))

local box = gr.nh_box('box', {-0.6, 0, -0.6}, {1.2, 1.4, 1.2})
box:rotate('y', -30)
box:translate(0.1, 0, -1.6)
box:set_reflection(0.6)
scene:add_child(box, gr.material({0.2 * 0.5 / 0.6, 0.35 * 0.5 / 0.6, 0.7 * 0.5 / 0.6}, {0, 0, 0}, 1))

local cone = gr.nh_cone('cone', {0, 0, 0}, 1.8, 0.7)
cone:scale(1, -1, 1)
cone:translate(2, 1.8, 0)
scene:add_child(cone, matt{0.85, 0.65, 0.2})

local ring = gr.torus('ring', 0.6, 0.2)
ring:rotate('x', 90)
ring:rotate('x', -70)
ring:rotate('y', 25)
ring:translate(-0.6, 0.65, 1.2)
scene:add_child(ring, matt{0.3, 0.6, 0.35})

local glass = gr.nh_sphere('glass', {0.9, 0.7, 1.4}, 0.7)
glass:set_refraction(1.5, 0)
glass:set_fresnel(true)
glass:set_absorption{(1 - 0.9) / 0.5, (1 - 0.6) / 0.5, (1 - 0.3) / 0.5}
scene:add_child(glass, gr.material({0, 0, 0}, {0, 0, 0}, 1))

gr.background({0.35, 0.45, 0.60})
local fov = 2 * math.deg(math.atan(math.tan(math.rad(50 / 2)) * 3 / 4))
gr.render(scene, 'still.png', 480, 360, {0, 2.2, 7}, {0, -1.4, -7}, {0, 1, 0}, fov, {0.25, 0.25, 0.25},
          {gr.light({-5, 8, 6}, {0.9, 0.9, 0.9}, {1, 0, 0}, 0.7),
           gr.light({6, 3, 4}, {1.6, 1.6, 1.6}, {1, 0, 1 / 25})})
