-- Two lenses and a thick tumbler of glass, each one solid made of several.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local function glass(solid, x, y, z, absorption)
  solid:set_refraction(1.5, 0)
  solid:set_fresnel(true)
  solid:set_absorption(absorption)
  solid:translate(x, y, z)
  root:add_child(solid, stage.clear)
end
glass(gr.intersection('burning glass', gr.nh_sphere('front', {0, 0, 1.55}, 1.8), gr.nh_sphere('back', {0, 0, -1.55}, 1.8)),
      -2, 0.95, 0, {0, 0, 0})
glass(gr.difference('concave', gr.nh_box('block', {-0.8, -0.8, -0.2}, {1.6, 1.6, 0.4}),
                    gr.nh_sphere('hollow in front', {0, 0, 1.3}, 1.2), gr.nh_sphere('hollow behind', {0, 0, -1.3}, 1.2)), 0.1, 0.85, 0, {0, 0, 0})
glass(gr.difference('tumbler', gr.nh_cylinder('outside', {0, 0, 0}, 1.4, 0.65), gr.nh_cylinder('inside', {0, 0.3, 0}, 2, 0.55)),
      2.1, 0.001, 0, {1.2, 0.4, 0.9})
for i = -3, 3 do root:add_child(gr.nh_sphere('ball ' .. i, {i, 0.25, -2.2}, 0.25), i % 2 == 0 and stage.red or stage.blue) end
stage.show(root)
