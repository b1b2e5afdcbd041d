-- On a checker: stripes, a gradient, noise, marble and wood.
local stage = require 'stage'
local root = gr.node('root')
local shine = {0.3, 0.3, 0.3}
root:add_child(gr.nh_plane('ground', {0, 0, 0}, {0, 1, 0}), nil,
               gr.checker{first = {0.16, 0.18, 0.24}, second = {0.8, 0.78, 0.72}, size = 0.5})
local function ball(x, pattern)
  root:add_child(gr.nh_sphere('ball at ' .. x, {x, 0.62, 0}, 0.62), nil, pattern)
end
ball(-2.7, gr.stripes{first = {0.85, 0.85, 0.82}, second = {0.7, 0.15, 0.12}, size = 0.18,
                      direction = {0.3, 1, 0}, specular = shine, exponent = 40})
ball(-1.35, gr.gradient{first = {0.1, 0.2, 0.6}, second = {0.95, 0.6, 0.2}, size = 1.24, specular = shine, exponent = 40})
ball(0, gr.noise{first = {0.1, 0.25, 0.1}, second = {0.75, 0.85, 0.4}, size = 0.4, specular = shine, exponent = 40})
ball(1.35, gr.marble{first = {0.2, 0.22, 0.26}, second = {0.9, 0.88, 0.84}, size = 0.6, turbulence = 1.5,
                     direction = {1, 0.6, 0.2}, specular = shine, exponent = 60})
local block = gr.nh_box('block', {-0.5, -0.5, -0.5}, {1, 1, 1})
block:rotate('x', 12)
block:rotate('y', 32)
block:translate(2.75, 0.6, -0.1)
root:add_child(block, nil, gr.wood{first = {0.66, 0.44, 0.24}, second = {0.36, 0.2, 0.09}, size = 0.12,
                                   direction = {0.2, 0.3, 1}, specular = {0.1, 0.1, 0.1}, exponent = 20})
stage.show(root)
