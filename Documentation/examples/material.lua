-- Diffuse alone, then highlights of exponent 5, 30 and 200.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local looks = {{0, 1}, {0.5, 5}, {0.5, 30}, {0.8, 200}}
for i, look in ipairs(looks) do
  local s = look[1]
  root:add_child(gr.nh_sphere('ball ' .. i, {1.35 * (i - 2.5), 0.6, 0}, 0.6),
                 gr.material({0.60, 0.18, 0.14}, {s, s, s}, look[2]))
end
stage.show(root)
