-- A box and a ball: both together, what they have in common, and the box less the ball and three drills.
local stage = require 'stage'
local root = gr.node('root')
stage.floor(root)
local box = gr.nh_box('box', {-0.6, -0.6, -0.6}, 1.2)
box:set_material(stage.gold)
local ball = gr.nh_sphere('ball', {0, 0, 0}, 0.78)
ball:set_material(stage.red)
local function drill(axis, angle)
  local hole = gr.nh_cylinder('hole along ' .. (axis or 'y'), {0, -2, 0}, 4, 0.3)
  if axis then hole:rotate(axis, angle) end
  hole:set_material(stage.blue)
  return hole
end

local function at(x, solid)
  solid:rotate('y', 28)
  solid:translate(x, 0.6, 0)
  root:add_child(solid)
end
at(-2.1, gr.union('both', box, ball))
at(0, gr.intersection('common', box, ball))
at(2.1, gr.difference('drilled', gr.intersection('rounded', box, ball), drill(), drill('x', 90), drill('z', 90)))
stage.show(root)
