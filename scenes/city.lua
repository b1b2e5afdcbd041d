-- A procedural city: blocks, streets, towers that set back as they rise, parks, a river; all of it from a few rules and
-- the sequence of math.random.
-- Look at: no two towers alike; windows are instances of one box. -D blocks sets the size, -D seed another city.

local blocks = gr.param('blocks', 22, {min = 2, max = 60, doc = 'blocks along each side'})
local seed = gr.param('seed', 7, {min = 0, doc = 'another city'})
math.randomseed(seed)
local random = math.random

local root, count = gr.node('root'), 0
local function name(word) count = count + 1; return word .. ' ' .. count end

local facades = {}
for _, c in ipairs{{0.72, 0.62, 0.50}, {0.60, 0.38, 0.30}, {0.66, 0.66, 0.66}, {0.50, 0.53, 0.58}, {0.78, 0.73, 0.62}, {0.45, 0.33, 0.28}} do
    facades[#facades + 1] = gr.material(c, {0.10, 0.10, 0.10}, 20)
end
local panes = gr.material({0.10, 0.13, 0.17}, {0.60, 0.60, 0.60}, 120)
local lit = gr.material({2.6, 1.9, 0.9}, {0.3, 0.3, 0.3}, 60)
local roof = gr.material({0.34, 0.33, 0.33}, {0.03, 0.03, 0.03}, 6)
local asphalt = gr.material({0.24, 0.24, 0.26}, {0.03, 0.03, 0.03}, 6)
local pavement = gr.material({0.52, 0.51, 0.49}, {0.03, 0.03, 0.03}, 6)
local grass = gr.material({0.28, 0.40, 0.16}, {0, 0, 0}, 1)
local greens = {gr.material({0.20, 0.36, 0.13}, {0, 0, 0}, 1), gr.material({0.31, 0.44, 0.15}, {0, 0, 0}, 1)}
local spire = gr.material({0.55, 0.53, 0.48}, {0.5, 0.5, 0.5}, 60)

local unit = gr.cube('unit')
local trunk, crown = gr.nh_cylinder('trunk', {0, 0, 0}, 0.5, 0.06), gr.sphere('crown')

local function box(parent, x, y, z, a, b, c, look)
    local node = gr.node(name('box'))
    node:add_child(unit, look)
    node:scale(a, b, c)
    node:translate(x, y, z)
    parent:add_child(node)
end

-- Bands of glass between floors, on all four sides, a few of their windows lit.
local function storey(parent, x, y, z, a, c, look)
    box(parent, x, y, z, a, 0.30, c, look)
    box(parent, x + 0.02, y + 0.06, z - 0.004, a - 0.04, 0.16, c + 0.008, panes)
    box(parent, x - 0.004, y + 0.06, z + 0.02, a + 0.008, 0.16, c - 0.04, panes)
    if random() < 0.5 then
        box(parent, x + (a - 0.25) * random(), y + 0.06, z - 0.006, 0.2, 0.16, c + 0.012, lit)
    end
end

local function tower(x, z, a, c, storeys)
    local group, look = gr.node(name('tower')), facades[random(#facades)]
    local y, left = 0, storeys
    while left > 0 do
        local n = math.min(left, 3 + random(6))
        for _ = 1, n do
            storey(group, x, y, z, a, c, look)
            y = y + 0.30
        end
        box(group, x - 0.02, y, z - 0.02, a + 0.04, 0.04, c + 0.04, look)
        left = left - n
        local inset = 0.06 + 0.14 * random()
        if a - 2 * inset < 0.5 or c - 2 * inset < 0.5 then break end
        x, z, a, c = x + inset, z + inset, a - 2 * inset, c - 2 * inset
    end
    box(group, x + 0.1, y, z + 0.1, a - 0.2, 0.12, c - 0.2, roof)
    if storeys > 22 then
        group:add_child(gr.nh_cylinder(name('mast'), {x + a / 2, y, z + c / 2}, 1.6, 0.03), spire)
    elseif random() < 0.4 then
        group:add_child(gr.nh_cylinder(name('tank'), {x + a * 0.3, y + 0.1, z + c * 0.3}, 0.3, 0.14), facades[6])
        local lid = gr.nh_cone(name('lid'), {0, 0, 0}, 0.14, 0.16)
        lid:rotate('x', 180)
        lid:translate(x + a * 0.3, y + 0.54, z + c * 0.3)
        group:add_child(lid, roof)
    end
    root:add_child(group)
end

local function park(x, z, size)
    box(root, x, 0, z, size, 0.03, size, grass)
    for _ = 1, 26 do
        local px, pz, s = x + size * random(), z + size * random(), 0.14 + 0.16 * random()
        local tree = gr.node(name('tree'))
        tree:add_child(trunk, facades[6])
        local top = gr.node(name('top'))
        top:add_child(crown, greens[random(2)])
        top:scale(0.32, 0.38, 0.32)
        top:translate(0, 0.72, 0)
        tree:add_child(top)
        tree:scale(s * 2.4, s * 2.4, s * 2.4)
        tree:translate(px, 0, pz)
        root:add_child(tree)
    end
end

local pitch, street = 3.4, 0.9
local middle = blocks / 2
local function river(z) return 2.6 * math.sin(z * 0.13) + 9 end

local water = gr.nh_box('water', {-3000, -0.08, -3000}, {6000, 0.04, 6000})
water:set_reflection(0.4)
root:add_child(water, gr.material({0.22, 0.36, 0.44}, {0.4, 0.4, 0.4}, 80))
for i = 0, blocks - 1 do
    for j = 0, blocks - 1 do
        local x, z = (i - middle) * pitch, (j - middle) * pitch
        if math.abs(x + 1.2 - river(z)) > 2.6 then
            box(root, x - street / 2, -0.2, z - street / 2, pitch, 0.2, pitch, asphalt)
            box(root, x, -0.1, z, pitch - street, 0.12, pitch - street, pavement)
            local away = math.sqrt((i - middle + 3) ^ 2 + (j - middle + 1) ^ 2) / middle
            if random() < 0.08 then
                park(x, z, pitch - street)
            else
                local tall = 5 + 34 * math.max(0, 1 - away) ^ 2 * (0.5 + random())
                local half = (pitch - street - 0.1) / 2
                if random() < 0.45 then
                    tower(x + 0.1, z + 0.1, 2 * half - 0.1, 2 * half - 0.1, math.floor(tall * 1.1))
                else
                    for p = 0, 1 do
                        for q = 0, 1 do
                            tower(x + 0.08 + p * half, z + 0.08 + q * half, half - 0.08, half - 0.08, math.floor(tall * (0.5 + 0.6 * random())) + 1)
                        end
                    end
                end
            end
        end
    end
end

gr.background({1.95, 1.25, 0.66}, {0.18, 0.40, 0.78})
gr.render(root, 'city.png', 1280, 720, {27, 10.5, 29}, {-0.86, -0.17, -1}, {0, 1, 0}, 32, {0.34, 0.35, 0.42},
          {gr.light({150, 75, -20}, {1.05, 0.78, 0.48}, {1, 0, 0}, 3), gr.light({-40, 120, 200}, {0.26, 0.30, 0.40}, {1, 0, 0}, 12)})
