-- Floor, walls, posts, beams and ceiling. The room is 4.4 wide (x from -2.45 to 1.95), 4.2 deep (z from 0,
-- the wall with the round window, to 4.2) and 2.4 high.

local kit = require 'room.kit'
local m = require 'room.materials'

local left, right, back, front, height = -2.45, 1.95, 0, 4.2, 2.4

local function mat(parent, x, z, along_x)
    local long, short, edge = 1.8, 0.9, 0.036
    local group = kit.group('mat')
    local straw = kit.mesh('straw', 'room_sheet_5x4')
    straw:scale(long, short - 2 * edge, 1)
    straw:rotate('x', -90)
    group:add_child(straw, nil, m.tatami, m.bump.tatami)
    for side = -1, 1, 2 do
        local border = kit.mesh('border', 'room_board_8')
        border:rotate('z', -90)
        border:scale(long, 0.006, edge)
        border:translate(0, -0.002, side * (short - edge) / 2)
        group:add_child(border, nil, m.border)
    end
    if not along_x then
        group:rotate('y', 90)
    end
    group:translate(x, 0, z)
    parent:add_child(group)
end

local function floor(parent)
    kit.box(parent, {-3, -0.5, -0.2}, {6, 0.49, 5}, m.outer_wall)
    -- Mats laid so that no four corners meet.
    local places = {
        {-1.55, 0.45, true}, {0.25, 0.45, true}, {1.60, 0.90, false},
        {-2.00, 1.80, false}, {-1.10, 1.80, false}, {0.25, 1.35, true}, {0.25, 2.25, true}, {1.60, 2.70, false},
        {-1.55, 3.15, true}, {0.25, 3.15, true}, {-1.55, 4.05, true}, {0.25, 4.05, true}, {-2.9, 0.9, false},
    }
    for _, p in ipairs(places) do
        mat(parent, p[1], p[2], p[3])
    end
end

local function plaster_sheet(parent, width, tall, yaw, x, y, z)
    local sheet = kit.mesh('wall', 'room_sheet_4x3')
    sheet:scale(width, tall, 1)
    sheet:rotate('y', yaw)
    sheet:translate(x, y, z)
    parent:add_child(sheet, nil, m.plaster, m.bump.plaster)
end

local function back_wall(parent, window)
    local wall = kit.mesh('wall', 'room_round_window')
    wall:translate(window.x, window.y, back)
    parent:add_child(wall, nil, m.plaster, m.bump.plaster)
    for _, x in ipairs{left, 0.06, right - 0.11} do
        kit.board(parent, {x, 0, -0.03}, {x + 0.11, height, 0.045}, m.post, m.bump.wood)
    end
    kit.board(parent, {left, 1.90, -0.02}, {right, 2.0, 0.05}, m.post, m.bump.wood)
    kit.board(parent, {left, 0, -0.01}, {right, 0.06, 0.03}, m.post, m.bump.wood)
end

-- Seen in the mirror: sliding doors with one painting over both, and a scroll.
local function front_wall(parent)
    local z = front
    for k, painting in ipairs{m.fusuma_left, m.fusuma_right} do
        local x = -1.70 + 0.92 * (2 - k)
        kit.board(parent, {x, 0.03, z - 0.030}, {x + 0.92, 1.83, z - 0.012}, painting)
        local door = gr.nh_box(kit.name('door'), {x + 0.02, 0.05, z - 0.035}, {0.88, 1.76, 0.02})
        parent:add_child(door, nil, painting)
        kit.box(parent, {x, 0.03, z - 0.045}, {0.024, 1.80, 0.03}, m.lacquer)
        kit.box(parent, {x + 0.896, 0.03, z - 0.045}, {0.024, 1.80, 0.03}, m.lacquer)
        local pull = gr.nh_torus(kit.name('pull'), {x + (k == 1 and 0.10 or 0.82), 0.85, z - 0.036}, 0.03, 0.006)
        parent:add_child(pull, m.brass)
    end
    plaster_sheet(parent, 5, height, 180, 0, height / 2, z)
    kit.board(parent, {left, 1.83, z - 0.06}, {right, 1.93, z}, m.post, m.bump.wood)
    for _, x in ipairs{-1.81, 0.14} do
        kit.board(parent, {x, 0, z - 0.06}, {x + 0.11, height, z}, m.post, m.bump.wood)
    end
end

local function left_wall(parent)
    plaster_sheet(parent, front, height, 90, left, height / 2, front / 2)
    local scroll = kit.mesh('scroll', 'room_sheet_1x1')
    scroll:scale(0.48, 0.96, 1)
    scroll:rotate('y', 90)
    scroll:translate(left + 0.012, 1.15, 3.10)
    parent:add_child(scroll, nil, m.scroll, m.bump.washi)
    for _, y in ipairs{0.67, 1.635} do
        kit.bar(parent, {left + 0.018, y, 2.83}, {left + 0.018, y, 3.37}, 0.013, m.lacquer)
    end
    kit.board(parent, {left, 1.90, 0}, {left + 0.05, 2.0, front}, m.post, m.bump.wood)
    kit.board(parent, {left, 0, 2.3}, {left + 0.06, height, 2.41}, m.post, m.bump.wood)
end

local function ceiling(parent)
    for i = 0, 13 do
        local x = left + 0.315 * i
        kit.board(parent, {x, height, -0.1}, {x + 0.312, height + 0.02, front + 0.1}, m.ceiling)
    end
    for i = 0, 8 do
        kit.board(parent, {left, height - 0.03, 0.25 + 0.45 * i}, {right, height, 0.28 + 0.45 * i}, m.post)
    end
end

-- The house around the room: keeps outside light outside, and shades the window.
local function house(parent)
    kit.box(parent, {-4, height + 0.1, -1.3}, {7.2, 0.2, 6.2}, m.outer_wall)
    kit.box(parent, {left - 0.3, -0.5, -0.1}, {0.28, 3.2, 4.6}, m.outer_wall)
    kit.box(parent, {-4, -0.5, front + 0.03}, {7.2, 3.2, 0.2}, m.outer_wall)
end

return function(parent, window)
    local shell = kit.group('shell')
    floor(shell)
    back_wall(shell, window)
    front_wall(shell)
    left_wall(shell)
    ceiling(shell)
    house(shell)
    parent:add_child(shell)
end
