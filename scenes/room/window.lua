-- The round window: a ring of wood, a sparse lattice, a wind chime; behind it a maple, hills, sea and clouds.

local kit = require 'room.kit'
local m = require 'room.materials'

local window = {x = 0.98, y = 1.04, radius = 0.52}

local function frame(parent)
    local group = kit.group('frame')
    local outer = gr.torus(kit.name('frame'), window.radius + 0.004, 0.026)
    group:add_child(outer, gr.material({0.20, 0.115, 0.065}, {0.20, 0.18, 0.16}, 40))
    -- Upright bamboo, two crossing bars, tied.
    for _, x in ipairs{-0.30, 0.30} do
        local reach = math.sqrt(window.radius ^ 2 - x ^ 2)
        kit.bar(group, {x, -reach, -0.05}, {x, reach, -0.05}, 0.009, m.bamboo)
        for y = -2, 2 do
            kit.ring(group, {x, y * 0.17 + 0.04, -0.05}, 0.0085, 0.0022, m.bamboo)
        end
    end
    local reach = math.sqrt(window.radius ^ 2 - 0.26 ^ 2)
    kit.bar(group, {-reach, -0.26, -0.064}, {reach, -0.26, -0.064}, 0.008, m.bamboo)
    group:translate(window.x, window.y, 0)
    parent:add_child(group)
end

local function chime(parent)
    local group = kit.group('chime')
    local bell = kit.mesh('bell', 'room_chime', {smooth = 60})
    bell:set_refraction(1.5, 0)
    bell:set_fresnel(true)
    group:add_child(bell, m.clear)
    kit.bar(group, {0, 0, 0}, {0, 0.5, 0}, 0.0008, m.thread)
    kit.bar(group, {0, -0.20, 0}, {0, -0.006, 0}, 0.0006, m.thread)
    kit.ball(group, {0, -0.045, 0}, 0.006, m.red_lacquer)
    local strip = gr.nh_box(kit.name('strip'), {-0.020, -0.20, -0.0004}, {0.040, 0.145, 0.0008})
    strip:rotate('y', 24)
    strip:rotate('z', 4)
    group:add_child(strip, nil, m.strip)
    group:scale(1.6, 1.6, 1.6)
    group:translate(window.x + 0.15, window.y + 0.25, 0.10)
    parent:add_child(group)
end

-- Limbs that fork, leaves at their ends; `random` makes every tree its own.
local function maple(parent, root, direction, length, lean, random, tints)
    local leaf = kit.mesh('leaf', 'room_leaf', {smooth = 180})
    local function place_leaf(p)
        local node = kit.group('leaf')
        node:add_child(leaf, m.leaves[tints[1 + math.floor(random() * #tints)]])
        local size = 0.065 + 0.035 * random()
        node:scale(size, size, size)
        node:rotate('x', -70 - 70 * random())
        node:rotate('z', 50 * (random() - 0.5))
        node:rotate('y', 360 * random())
        node:translate(p[1] + 0.10 * (random() - 0.5), p[2] + 0.07 * (random() - 0.5), p[3] + 0.10 * (random() - 0.5))
        parent:add_child(node)
    end
    local function limb(p, d, size, radius, level)
        local q = {p[1] + d[1] * size, p[2] + d[2] * size, p[3] + d[3] * size}
        kit.bar(parent, p, q, radius, nil, m.bark)
        kit.ball(parent, q, radius, gr.material({0.27, 0.20, 0.15}, {0, 0, 0}, 1))
        if level <= 3 then
            for _ = 1, level == 1 and 12 or 7 do
                local t = random()
                place_leaf({p[1] + d[1] * size * t, p[2] + d[2] * size * t, p[3] + d[3] * size * t})
            end
        end
        if level == 0 then return end
        for _ = 1, level > 3 and 2 or 3 do
            local e = {d[1] + 1.2 * (random() - 0.5), d[2] + 0.75 * (random() - 0.5) - lean * d[2], d[3] + 1.2 * (random() - 0.5)}
            local s = math.sqrt(e[1] ^ 2 + e[2] ^ 2 + e[3] ^ 2)
            limb(q, {e[1] / s, e[2] / s, e[3] / s}, size * (0.68 + 0.2 * random()), radius * 0.62, level - 1)
        end
    end
    limb(root, direction, length, 0.035, 5)
end

-- A garden lantern of stone: foot, shaft, fire box, roof, finial.
local function stone_lantern(parent, x, z)
    local group = kit.group('stone lantern')
    local stone = gr.material({0.50, 0.50, 0.48}, {0.03, 0.03, 0.03}, 6)
    local dark = gr.material({0.10, 0.09, 0.08}, {0, 0, 0}, 1)
    local function drum(y, tall, radius) group:add_child(gr.nh_cylinder(kit.name('drum'), {0, y, 0}, tall, radius), stone) end
    drum(0, 0.10, 0.24)
    drum(0.10, 0.52, 0.10)
    drum(0.62, 0.07, 0.21)
    kit.box(group, {-0.13, 0.69, -0.13}, {0.26, 0.24, 0.26}, stone)
    kit.box(group, {-0.06, 0.73, -0.131}, {0.12, 0.15, 0.262}, dark)
    local roof = gr.cone(kit.name('roof'))
    roof:scale(0.34, -0.24, 0.34)
    roof:translate(0, 1.17, 0)
    group:add_child(roof, stone)
    kit.ring(group, {0, 0.935, 0}, 0.32, 0.022, stone)
    kit.ball(group, {0, 1.18, 0}, 0.055, stone)
    group:rotate('y', 25)
    group:translate(x, -0.62, z)
    parent:add_child(group)
end

-- Clipped bushes: leaves all over ellipsoids.
local function bush(parent, x, y, z, wide, tall, count, random)
    local leaf = kit.mesh('leaf', 'room_leaf', {smooth = 180})
    local heart = gr.sphere(kit.name('bush'))
    heart:scale(wide * 0.93, tall * 0.93, wide * 0.93)
    heart:translate(x, y, z)
    parent:add_child(heart, nil, m.moss)
    for _ = 1, count do
        local up, a = random(), 6.2832 * random()
        local r = math.sqrt(1 - up * up)
        local node = kit.group('leaf')
        node:add_child(leaf, m.leaves[1 + math.floor(2.2 * random())])
        node:scale(0.08, 0.08, 0.08)
        node:rotate('x', -90 * random())
        node:rotate('y', 360 * random())
        node:translate(x + wide * r * math.cos(a), y + tall * up, z + wide * r * math.sin(a))
        parent:add_child(node)
    end
end

local function garden(parent)
    local group = kit.group('garden')
    local view = kit.mesh('view', 'room_sheet_1x1')
    view:scale(7.6, 5.7, 1)
    view:translate(4.35, 1.60, -14)
    group:add_child(view, nil, m.view)
    maple(group, {2.45, 1.36, -1.9}, {-0.95, 0.22, 0.1}, 0.52, 0.25, kit.random(6), {1, 2, 2, 3, 3, 4})
    local ground = gr.nh_box(kit.name('ground'), {-3, -0.9, -13.9}, {14, 0.3, 12.6})
    group:add_child(ground, nil, m.moss)
    stone_lantern(group, 1.52, -3.3)
    bush(group, 2.75, -0.65, -4.2, 0.75, 0.72, 620, kit.random(21))
    bush(group, 0.55, -0.65, -4.4, 0.60, 0.62, 520, kit.random(22))
    bush(group, 4.2, -0.65, -6.2, 1.10, 0.85, 420, kit.random(23))
    -- A neighbour's wall, out of sight: it keeps the sun off the picture of the hills.
    kit.box(group, {3.5, -1, -4.1}, {6, 9, 0.1}, m.outer_wall)
    parent:add_child(group)
end

function window.build(parent)
    frame(parent)
    chime(parent)
    garden(parent)
end

return window
