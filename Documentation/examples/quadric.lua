-- An egg, a saddle, a dish with a thick floor and a cooling tower: quadrics, cut by boxes.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local function at(x, solid, material)
  solid:rotate('y', 25)
  solid:translate(x, 0, 0)
  root:add_child(solid, material)
end
at(-2.4, gr.quadric('egg', {xx = 4, yy = 2.2, zz = 4, y = -2.6, c = -0.3}, {-1, 0, -1}, {1, 2, 1}), stage.gold)
-- y <= 0.55 + 0.8 (x^2 - z^2)
at(-0.8, gr.quadric('saddle', {y = 1, xx = -0.8, zz = 0.8, c = -0.55}, {-0.7, 0, -0.7}, {0.7, 1.2, 0.7}), stage.red)
local dish = gr.difference('dish', gr.nh_cylinder('drum', {0, 0, 0}, 0.6, 0.72),
                           gr.quadric('bowl', {xx = 1, zz = 1, y = -1, c = 0.12}, {-0.7, 0, -0.7}, {0.7, 2, 0.7}))
at(0.9, dish, stage.white)
local tower = gr.difference('tower', gr.quadric('outside', {xx = 1, yy = -0.25, zz = 1, y = 0.5, c = -0.36}, {-1, 0, -1}, {1, 1.6, 1}),
                            gr.quadric('inside', {xx = 1, yy = -0.25, zz = 1, y = 0.5, c = -0.30}, {-1, -1, -1}, {1, 3, 1}))
at(2.5, tower, stage.blue)
stage.show(root)
