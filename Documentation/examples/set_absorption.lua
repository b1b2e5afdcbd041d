-- Glass that absorbs red and green: a wedge, deeper in colour the thicker; balls of three sizes of one glass.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local function glass(node, absorption)
  node:set_refraction(1.4, 0)
  node:set_fresnel(true)
  node:set_absorption(absorption)
  root:add_child(node, stage.clear)
end
local wedge = gr.mesh('wedge', {{0, 0, 0}, {2.4, 0, 0}, {2.4, 0, 1.2}, {0, 0, 0.05},
                                {0, 1, 0}, {2.4, 1, 0}, {2.4, 1, 1.2}, {0, 1, 0.05}},
                      {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}})
wedge:translate(-2.9, 0.01, -0.6)
glass(wedge, {1.6, 0.5, 0.1})
for i, r in ipairs{0.25, 0.45, 0.75} do
  glass(gr.nh_sphere('ball ' .. i, {({-0.05, 0.75, 2.1})[i], r + 0.01, 0}, r), {0.15, 1.1, 1.3})
end
stage.show(root)
