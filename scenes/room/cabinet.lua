-- The low chest with iron fittings; on it the mirror, the cat that looks into it, a glass of water with a
-- bellflower, a doll and a few books.

local kit = require 'room.kit'
local m = require 'room.materials'

local chest = {left = -1.78, right = -0.10, front = 0.50, back = 0.05, top = 0.46}

local function drawer(parent, x, y, width, tall)
    local z = chest.front
    kit.board(parent, {x + 0.006, y + 0.006, z - 0.02}, {x + width - 0.006, y + tall - 0.006, z + 0.008}, m.tansu, m.bump.wood)
    -- A round plate with a ring, and iron on the corners.
    local cx, cy = x + width / 2, y + tall / 2
    local plate = gr.nh_cylinder(kit.name('plate'), {0, 0, 0}, 0.004, 0.026)
    plate:rotate('x', 90)
    plate:translate(cx, cy, z + 0.008)
    parent:add_child(plate, m.black_iron)
    local pull = gr.torus(kit.name('pull'), 0.022, 0.0035)
    pull:rotate('x', -14)
    pull:translate(cx, cy - 0.020, z + 0.018)
    parent:add_child(pull, m.black_iron)
    for _, sx in ipairs{0, 1} do
        for _, sy in ipairs{0, 1} do
            local px = sx == 0 and x + 0.006 or x + width - 0.006 - 0.035
            local py = sy == 0 and y + 0.006 or y + tall - 0.006 - 0.035
            kit.box(parent, {px, py, z + 0.0078}, {0.035, 0.035, 0.002}, m.black_iron)
        end
    end
end

local function body(parent)
    kit.board(parent, {chest.left - 0.02, chest.top - 0.03, chest.back - 0.02}, {chest.right + 0.02, chest.top, chest.front + 0.025},
              m.tansu, m.bump.wood)
    kit.board(parent, {chest.left, 0.02, chest.back}, {chest.right, chest.top - 0.03, chest.front - 0.012}, m.tansu, m.bump.wood)
    kit.board(parent, {chest.left - 0.01, 0, chest.back}, {chest.right + 0.01, 0.045, chest.front + 0.012}, m.post, m.bump.wood)
    local widths = {0.42, 0.42, 0.42, 0.42}
    local x = chest.left
    for k, width in ipairs(widths) do
        if k == 2 then
            drawer(parent, x, 0.05, width * 2, 0.185)
        elseif k ~= 3 then
            drawer(parent, x, 0.05, width, 0.185)
        end
        drawer(parent, x, 0.24, width, 0.185)
        x = x + width
    end
end

local function mirror(parent)
    local width, tall, edge = 1.16, 0.94, 0.042
    local group = kit.group('mirror')
    local pane = gr.nh_box(kit.name('pane'), {-width / 2, 0, 0}, {width, tall, 0.008})
    pane:set_reflection(0.03)
    group:add_child(pane, m.silver)
    for side = -1, 1, 2 do
        local x = side * (width + edge) / 2
        kit.board(group, {x - edge / 2, -edge, -0.02}, {x + edge / 2, tall + edge, 0.022}, m.post, m.bump.wood)
    end
    kit.board(group, {-width / 2, -edge, -0.019}, {width / 2, 0, 0.021}, m.post, m.bump.wood)
    kit.board(group, {-width / 2 - 0.06, tall, -0.019}, {width / 2 + 0.06, tall + edge, 0.024}, m.post, m.bump.wood)
    group:rotate('x', -2.5)
    group:rotate('y', 7)
    group:translate(-0.93, chest.top + 0.05, 0.13)
    parent:add_child(group)
end

local function cat(parent)
    local group = kit.group('cat')
    group:add_child(kit.mesh('cat', 'room_cat', {smooth = 180}), nil, m.fur, m.bump.fur)
    for side = -1, 1, 2 do
        local eye = gr.sphere(kit.name('eye'))
        eye:rotate('y', 8 * side)
        eye:scale(0.0125, 0.0125, 0.0125)
        eye:translate(0.0235 * side, 0.2905, 0.0800)
        group:add_child(eye, nil, m.eye)
        for k = -1, 1 do
            kit.bar(group, {0.014 * side, 0.266 + 0.003 * k, 0.094}, {0.075 * side, 0.264 + 0.014 * k, 0.098}, 0.0005, m.whisker)
        end
    end
    local nose = gr.sphere(kit.name('nose'))
    nose:scale(0.0056, 0.0040, 0.0042)
    nose:translate(0, 0.2735, 0.0985)
    group:add_child(nose, m.nose)
    -- A red collar with a bell.
    local collar = gr.torus(kit.name('collar'), 0.046, 0.006)
    collar:rotate('x', 90 + 18)
    collar:translate(0, 0.236, 0.028)
    group:add_child(collar, m.red_lacquer)
    kit.ball(group, {0, 0.218, 0.079}, 0.010, m.brass)
    group:rotate('y', 168)
    group:scale(1.25, 1.25, 1.25)
    group:translate(-1.10, chest.top, 0.41)
    parent:add_child(group)
end

local function water_glass(parent)
    local group = kit.group('glass')
    -- The water comes first: where the two overlap, glass holds.
    local water = kit.mesh('water', 'room_water')
    water:set_refraction(1.33, 0.05)
    water:set_fresnel(true)
    group:add_child(water, m.tumbler)
    local glass = kit.mesh('tumbler', 'room_tumbler')
    glass:set_refraction(1.5, 0.08)
    glass:set_fresnel(true)
    group:add_child(glass, m.tumbler)
    -- A bellflower leans in it: a stem, two leaves, five petals.
    local low, high = {-0.018, 0.016, 0.004}, {0.052, 0.185, -0.012}
    kit.bar(group, low, high, 0.0016, m.stem)
    kit.ball(group, high, 0.0040, m.stem)
    local flower = kit.group('flower')
    local petal = kit.mesh('petal', 'room_petal', {smooth = 180})
    for k = 0, 4 do
        local node = kit.group('petal')
        node:add_child(petal, m.petal)
        node:rotate('x', 18)
        node:rotate('z', 72 * k)
        flower:add_child(node)
    end
    local heart = gr.nh_sphere(kit.name('heart'), {0, 0, 0.05}, 0.10)
    flower:add_child(heart, m.heart)
    local eye = gr.nh_cone(kit.name('pistil'), {0, 0, 0}, 0.30, 0.05)
    eye:rotate('x', 90)
    flower:add_child(eye, m.heart)
    flower:scale(0.042, 0.042, 0.042)
    flower:rotate('x', -28)
    flower:rotate('y', 22)
    flower:translate(0.054, 0.190, -0.010)
    group:add_child(flower)
    for side = -1, 1, 2 do
        local leaf = gr.sphere(kit.name('leaf'))
        leaf:scale(0.006, 0.026, 0.0012)
        leaf:rotate('z', -24 - 42 * side)
        leaf:rotate('y', 30 * side)
        leaf:translate(0.028 + 0.020 * side, 0.140 + 0.008 * side, -0.006)
        group:add_child(leaf, m.stem)
    end
    group:scale(1.65, 1.65, 1.65)
    group:translate(-0.42, chest.top + 0.002, 0.36)
    parent:add_child(group)
end

-- A cloth of white cotton under the glass, to show its shadow on.
local function cloth(parent)
    local node = gr.nh_box(kit.name('cloth'), {-0.27, 0, -0.115}, {0.44, 0.002, 0.23})
    node:rotate('y', -7)
    node:translate(-0.46, chest.top, 0.365)
    parent:add_child(node, nil, m.washi, m.bump.weave)
end

local function doll(parent)
    local group = kit.group('doll')
    group:add_child(kit.mesh('body', 'room_doll'), nil, m.doll)
    local head = gr.nh_sphere(kit.name('head'), {0, 0.110, 0}, 0.026)
    group:add_child(head, nil, m.face)
    group:scale(1.25, 1.25, 1.25)
    group:rotate('y', 20)
    group:translate(-0.20, chest.top, 0.24)
    parent:add_child(group)
end

local function books(parent)
    local group = kit.group('books')
    local row = gr.nh_box(kit.name('books'), {0, 0, 0}, {0.30, 0.19, 0.13})
    group:add_child(row, nil, m.books)
    kit.board(group, {-0.014, 0, -0.01}, {-0.002, 0.15, 0.14}, m.cedar)
    group:rotate('y', 14)
    group:translate(-1.76, chest.top, 0.16)
    parent:add_child(group)
end

return function(parent)
    local group = kit.group('cabinet')
    body(group)
    mirror(group)
    cat(group)
    cloth(group)
    water_glass(group)
    doll(group)
    books(group)
    parent:add_child(group)
end
