-- Supersampling: a suspension bridge at dusk, whose hangers and lattice are thinner than a pixel for most of its
-- length. Look at: cables that fade with the distance and never break into dots, railings that end in an even tone.
-- Without: one ray through the middle of each pixel.   ./Project scenes/objectives/supersampling.lua -D without=true

local without = gr.param('without', false, {doc = 'one sample in the middle of each pixel'})
if without then gr.options{spp = 1, sampler = 'grid'} end

local steel = gr.material({0.56, 0.19, 0.13}, {0.18, 0.16, 0.15}, 30)
local cable = gr.material({0.50, 0.18, 0.12}, {0.10, 0.10, 0.10}, 20)
local road = gr.material({0.17, 0.17, 0.19}, {0.05, 0.05, 0.05}, 10)
local lamp = gr.material({6, 4.4, 2.4}, {0, 0, 0}, 1)
local water = gr.material({0.05, 0.10, 0.14}, {0.30, 0.26, 0.22}, 40)

local root, count = gr.node('root'), 0
local function name(word) count = count + 1; return word .. ' ' .. count end
local function box(x, y, z, a, b, c, look) root:add_child(gr.nh_box(name('box'), {x, y, z}, {a, b, c}), look) end
local function bar(p, q, r, look)
    local d = {q[1] - p[1], q[2] - p[2], q[3] - p[3]}
    local length = math.sqrt(d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2)
    local node = gr.nh_cylinder(name('bar'), {0, 0, 0}, length, r)
    node:rotate('z', -math.deg(math.acos(d[2] / length)))
    node:rotate('y', -math.deg(math.atan(d[3], d[1])))
    node:translate(p[1], p[2], p[3])
    root:add_child(node, look)
end

-- Spans of 60 along -z; the deck at y = 8, towers 15 above it. x: the two sides at -4 and 4.
local span, deck, rise = 60, 8, 15
box(-4.6, deck - 0.5, -6 * span, 9.2, 0.5, 6 * span + 20, road)
for s = -1, 6 do
    local z = -s * span
    for side = -1, 1, 2 do
        box(4 * side - 0.7, -1, z - 0.9, 1.4, deck + rise + 1, 1.8, steel)
    end
    for _, y in ipairs{deck - 2, deck + 6.5, deck + rise - 1} do box(-4, y, z - 0.6, 8, 1.0, 1.2, steel) end
end
for s = -1, 5 do
    for side = -1, 1, 2 do
        local x, old = 4 * side, nil
        for k = 0, 40 do
            local t = k / 40
            local y = deck + 1.2 + (rise - 1.2) * (2 * t - 1) ^ 2
            local p = {x, y, -(s + t) * span}
            if old then bar(old, p, 0.16, cable) end
            if k > 0 and k < 40 then bar({x, deck, p[3]}, p, 0.035, cable) end
            if k % 8 == 4 then root:add_child(gr.nh_sphere(name('lamp'), {x * 0.96, deck + 2.6, p[3]}, 0.16), lamp) end
            old = p
        end
        -- The lattice below the deck and the railing above.
        for k = 0, 29 do
            local z = -(s + k / 30) * span
            bar({x, deck - 0.5, z}, {x, deck - 2.6, z - 1}, 0.07, steel)
            bar({x, deck - 2.6, z - 1}, {x, deck - 0.5, z - 2}, 0.07, steel)
        end
        for k = 0, 119 do bar({x, deck, -(s + k / 120) * span}, {x, deck + 1.0, -(s + k / 120) * span}, 0.022, steel) end
        box(x - 0.04, deck + 0.98, -(s + 1) * span, 0.08, 0.08, span, steel)
        box(x - 0.15, deck - 2.8, -(s + 1) * span, 0.3, 0.25, span, steel)
    end
end

local sea = gr.nh_box('sea', {-900, -2, -900}, {1800, 1, 1000})
sea:set_reflection(0.45)
root:add_child(sea, water, nil, nil)
for k = 0, 24 do
    local hill = gr.sphere(name('hill'))
    hill:scale(60 + 40 * math.random(), 14 + 26 * math.random(), 40)
    hill:translate(-620 + 52 * k, -4, -560 - 60 * math.random())
    root:add_child(hill, gr.material({0.36, 0.33, 0.44}, {0, 0, 0}, 1))
end

gr.background({1.75, 1.05, 0.46}, {0.16, 0.26, 0.52})
gr.render(root, 'supersampling.png', 1280, 720, {24, 13.5, 44}, {-0.40, -0.08, -1}, {0, 1, 0}, 32, {0.34, 0.30, 0.34},
          {gr.light({-400, 130, -200}, {1.0, 0.66, 0.40}, {1, 0, 0}), gr.light({300, 300, 300}, {0.40, 0.40, 0.46}, {1, 0, 0})})
