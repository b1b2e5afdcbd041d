-- The low lacquered table with tea on it, the cushions about it, and the lantern in the corner.

local kit = require 'room.kit'
local m = require 'room.materials'

local function table_top(parent)
    local group = kit.group('table')
    local top = gr.nh_cylinder(kit.name('top'), {0, 0.30, 0}, 0.024, 0.45)
    top:set_reflection(0.80)
    group:add_child(top, m.lacquer)
    local edge = kit.ring(group, {0, 0.312, 0}, 0.45, 0.012, m.lacquer)
    edge:set_reflection(0.80)
    for k = 0, 3 do
        local leg = gr.cone(kit.name('leg'))
        leg:scale(0.042, 0.62, 0.042)
        leg:translate(0, -0.32, 0)
        leg:rotate('z', 8)
        leg:translate(0.30, 0, 0)
        leg:rotate('y', 45 + 90 * k)
        group:add_child(leg, m.lacquer)
    end
    parent:add_child(group)
    return group
end

local function kettle(parent, x, z, yaw)
    local group = kit.group('kettle')
    group:add_child(kit.mesh('body', 'room_kettle'), nil, m.iron, m.bump.iron)
    group:add_child(kit.mesh('lid', 'room_kettle_lid'), nil, m.iron)
    group:add_child(kit.mesh('spout', 'room_kettle_spout'), nil, m.iron)
    group:add_child(kit.mesh('handle', 'room_kettle_handle'), nil, m.iron)
    kit.ring(group, {0, 0.002, 0}, 0.070, 0.006, m.brass)
    group:rotate('y', yaw)
    group:translate(x, 0.330, z)
    parent:add_child(group)
end

local function teacup(parent, x, z, yaw)
    local group = kit.group('cup')
    group:add_child(kit.mesh('cup', 'room_teacup'), nil, m.raku)
    local tea = gr.nh_cylinder(kit.name('tea'), {0, 0.02, 0}, 0.036, 0.0362)
    tea:set_reflection(0.85)
    group:add_child(tea, m.tea)
    group:rotate('y', yaw)
    group:translate(x, 0.324, z)
    parent:add_child(group)
end

local function bowl(parent, x, z)
    local group = kit.group('bowl')
    group:add_child(kit.mesh('bowl', 'room_bowl'), nil, m.waves)
    kit.ring(group, {0, 0.0622, 0}, 0.06975, 0.0013, gr.material({0.16, 0.25, 0.52}, {0.5, 0.5, 0.5}, 120))
    local random = kit.random(5)
    for k = 1, 90 do
        local a, r = 6.2832 * random(), 0.054 * math.sqrt(random())
        local grain = gr.sphere(kit.name('rice'))
        grain:scale(0.0052, 0.0026, 0.0026)
        grain:rotate('z', 60 * (random() - 0.5))
        grain:rotate('y', 360 * random())
        grain:translate(r * math.cos(a), 0.045 + 0.024 * (1 - (r / 0.06) ^ 2), r * math.sin(a))
        group:add_child(grain, m.rice)
    end
    local heap = gr.sphere(kit.name('heap'))
    heap:scale(0.058, 0.024, 0.058)
    heap:translate(0, 0.045, 0)
    group:add_child(heap, m.rice)
    group:translate(x, 0.324, z)
    parent:add_child(group)
end

-- Three rice dumplings on a plate.
local function dumplings(parent, x, z)
    local group = kit.group('plate')
    group:add_child(kit.mesh('plate', 'room_plate'), nil, m.raku)
    for k, material in ipairs{m.rice, m.green_rice, m.pink_rice} do
        local a = 2.0944 * k
        kit.ball(group, {0.030 * math.cos(a), 0.036, 0.030 * math.sin(a)}, 0.026, material)
    end
    group:scale(0.8, 0.8, 0.8)
    group:translate(x, 0.324, z)
    parent:add_child(group)
end

-- Tapering sticks are long cones; their thin ends lie on a rest.
local function chopsticks(parent, x, z, yaw)
    local group = kit.group('chopsticks')
    for k = 0, 1 do
        local stick = gr.nh_cone(kit.name('stick'), {0, -0.08, 0}, 0.31, 0.0042)
        stick:rotate('x', 91.6)
        stick:rotate('y', 2.2 * k)
        stick:translate(0.012 * k, 0.016, -0.105)
        group:add_child(stick, m.red_lacquer)
    end
    local rest = gr.nh_cylinder(kit.name('rest'), {0, -0.026, 0}, 0.052, 0.007)
    rest:rotate('z', 90)
    rest:translate(0.006, 0.006, -0.085)
    group:add_child(rest, nil, m.raku)
    group:rotate('y', yaw)
    group:translate(x, 0.324, z)
    parent:add_child(group)
end

local function cushion(parent, texture, x, z, yaw, size)
    local group = kit.group('cushion')
    local pad = kit.mesh('pad', 'room_cushion', {smooth = 60})
    pad:scale(0.58, 0.60, 0.58)
    group:add_child(pad, nil, texture, m.bump.weave)
    for sx = -1, 1, 2 do
        for sz = -1, 1, 2 do
            local tassel = gr.nh_cone(kit.name('tassel'), {0, 0, 0}, 0.055, 0.010)
            tassel:rotate('z', -98)
            tassel:rotate('y', -math.deg(math.atan(sz, sx)))
            tassel:translate(0.282 * sx, 0.0, 0.282 * sz)
            group:add_child(tassel, m.tassel)
        end
    end
    for k = 0, 3 do
        local a = math.pi / 2 * k + 0.5
        kit.bar(group, {0, 0.034, 0}, {0.022 * math.cos(a), 0.040, 0.022 * math.sin(a)}, 0.0018, m.tassel)
    end
    group:rotate('y', yaw)
    group:translate(x, 0.050, z)
    parent:add_child(group)
end

-- A paper lantern: a barrel of paper over bamboo rings, a glowing core within, and a foot of wood.
local function lantern(parent, at)
    local group = kit.group('lantern')
    local core = gr.nh_sphere(kit.name('core'), {0, 0, 0}, 0.085)
    group:add_child(core, m.glow)
    for k, size in ipairs{1.0, 0.86} do
        local paper = gr.sphere(kit.name('paper'))
        paper:scale(0.15 * size, 0.165 * size, 0.15 * size)
        paper:set_refraction(1, 0.42)
        group:add_child(paper, gr.material({1.5, 1.10, 0.64}, {0, 0, 0}, 1))
    end
    for k = -5, 5 do
        local y = 0.026 * k
        kit.ring(group, {0, y, 0}, 0.15 * math.sqrt(1 - (y / 0.165) ^ 2), 0.0018, m.bamboo)
    end
    for side = -1, 1, 2 do
        local cap = gr.nh_cylinder(kit.name('cap'), {0, side * 0.157 - 0.012, 0}, 0.024, 0.058)
        group:add_child(cap, m.lacquer)
    end
    local foot = gr.nh_cylinder(kit.name('foot'), {0, -0.235, 0}, 0.018, 0.11)
    group:add_child(foot, m.lacquer)
    local stem = gr.nh_cylinder(kit.name('stem'), {0, -0.22, 0}, 0.06, 0.018)
    group:add_child(stem, m.lacquer)
    group:translate(at[1], at[2], at[3])
    parent:add_child(group)
end

local function fan(parent)
    local group = kit.group('fan')
    local disc = gr.nh_cylinder(kit.name('fan'), {0, 0, 0}, 0.0025, 0.13)
    disc:rotate('x', 90)
    group:add_child(disc, nil, m.fan)
    local rim = gr.torus(kit.name('rim'), 0.13, 0.003)
    group:add_child(rim, m.bamboo)
    kit.bar(group, {0, -0.26, 0.001}, {0, -0.02, 0.001}, 0.006, m.bamboo)
    group:rotate('x', -82)
    group:rotate('y', 35)
    group:translate(-0.62, 0.022, 0.83)
    parent:add_child(group)
end

return function(parent, lamp)
    local group = table_top(parent)
    kettle(group, 0.03, -0.19, 200)
    teacup(group, -0.27, -0.02, 40)
    teacup(group, 0.26, 0.02, 160)
    bowl(group, -0.12, 0.20)
    dumplings(group, 0.20, 0.20)
    chopsticks(group, 0.02, 0.20, -24)
    group:scale(0.92, 1, 0.92)
    group:translate(0.84, 0, 0.84)
    cushion(parent, m.indigo, -0.02, 0.86, 12)
    cushion(parent, m.crimson, 0.42, 0.34, -9)
    lantern(parent, lamp)
    fan(parent)
end
