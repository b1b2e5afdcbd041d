-- The right wall: four paper doors in a frame, one of them slid open to the afternoon. Paper lets half of
-- what lies behind it through, straight, and so half of the light.

local kit = require 'room.kit'
local m = require 'room.materials'

local x, top = 1.95, 1.80

local function door(parent, z, depth, width)
    local group = kit.group('door')
    local function wood(z0, y0, z1, y1, thick)
        kit.board(group, {-thick, y0, z0}, {thick, y1, z1}, m.cedar)
    end
    wood(0, 0, 0.035, top, 0.014)
    wood(width - 0.035, 0, width, top, 0.014)
    wood(0.035, 0, width - 0.035, 0.05, 0.014)
    wood(0.035, top - 0.045, width - 0.035, top, 0.014)
    wood(0.035, 0.05, width - 0.035, 0.34, 0.006)
    wood(0.035, 0.34, width - 0.035, 0.37, 0.014)
    for i = 1, 3 do
        local at = 0.035 + (width - 0.07) * i / 4
        wood(at - 0.006, 0.37, at + 0.006, top - 0.045, 0.008)
    end
    for j = 1, 5 do
        local at = 0.37 + (top - 0.415) * j / 6
        wood(0.035, at - 0.006, width - 0.035, at + 0.006, 0.0079)
    end
    local paper = gr.nh_box(kit.name('paper'), {0.0085, 0.37, 0.035}, {0.001, top - 0.415, width - 0.07})
    paper:set_refraction(1, 0.5)
    group:add_child(paper, nil, m.washi)
    group:translate(x + depth, 0.02, z)
    parent:add_child(group)
end

return function(parent)
    local wall = kit.group('paper doors')
    door(wall, 0.06, 0.018, 0.92)
    door(wall, 0.10, -0.018, 0.92)
    door(wall, 2.84, 0.018, 0.92)
    door(wall, 2.90, -0.018, 0.92)
    kit.board(wall, {x - 0.05, top + 0.02, 0}, {x + 0.06, top + 0.10, 4.2}, m.post, m.bump.wood)
    kit.board(wall, {x - 0.05, -0.02, 0}, {x + 0.06, 0.02, 4.2}, m.cedar, m.bump.wood)
    kit.board(wall, {x - 0.05, 0, 3.82}, {x + 0.06, 2.4, 3.93}, m.post, m.bump.wood)
    kit.box(wall, {x, top + 0.10, -0.1}, {0.08, 0.6, 4.4}, m.outer_wall)
    kit.box(wall, {x, -0.1, 3.93}, {0.08, 2.6, 0.4}, m.outer_wall)
    -- The veranda.
    for i = 0, 5 do
        kit.board(wall, {x + 0.09 + 0.15 * i, -0.08, -0.2}, {x + 0.235 + 0.15 * i, -0.04, 4.4}, m.cedar)
    end
    parent:add_child(wall)
end
