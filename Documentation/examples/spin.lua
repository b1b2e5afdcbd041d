-- A propeller at rest, one that turns by 30 degrees, and one by a whole turn.
local stage = require 'stage'
local root = gr.node('root')
stage.board(root)
local function propeller(x, degrees, paint)
  local it = gr.node('propeller by ' .. degrees)
  it:add_child(gr.nh_sphere('hub by ' .. degrees, {0, 0, 0}, 0.16), stage.gold)
  for blade = 0, 2 do
    local tip = gr.sphere('blade ' .. blade .. ' by ' .. degrees)
    tip:scale(0.2, 0.44, 0.03)
    tip:translate(0, 0.5, 0)
    tip:rotate('z', 120 * blade)
    it:add_child(tip, paint)
  end
  it:spin('z', degrees)
  it:translate(x, 1.05, 0)
  root:add_child(it)
end
propeller(-2.2, 0, stage.red)
propeller(0, 30, stage.red)
propeller(2.2, 360, stage.red)
stage.show(root)
