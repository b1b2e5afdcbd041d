-- Depth of field: paper lanterns along a wet street at night; the third of them is in focus.
-- Look at: lanterns far away become discs of even light with clear edges, whose size hardly grows any more with the
-- distance; their images in the wet stones are as far out of focus as they are.
-- Without: a pinhole.   ./Project scenes/objectives/depth_of_field.lua -D without=true

local without = gr.param('without', false, {doc = 'a pinhole instead of a lens'})
local radius = gr.param('radius', 0.055, {min = 0, max = 0.5, doc = 'radius of the lens'})

local root, count = gr.node('root'), 0
local function name(word) count = count + 1; return word .. ' ' .. count end

local rib = gr.material({0.30, 0.20, 0.10}, {0.1, 0.1, 0.1}, 20)
local cap = gr.material({0.05, 0.03, 0.03}, {0.3, 0.3, 0.3}, 60)
local dark = gr.material({0.10, 0.085, 0.08}, {0.04, 0.04, 0.04}, 10)

-- A lantern is a stack of rings of paper, the brighter the nearer to its flame; each colour is made once.
local function lantern_of(tint)
    local group = gr.node(name('lantern'))
    for k = -8, 8 do
        local y = k / 9
        local r = math.sqrt(1 - y * y)
        local glow = 0.55 + 4.2 * math.exp(-(y + 0.25) ^ 2 * 3.2)
        local band = gr.torus(name('band'), 0.16 * r, 0.020)
        band:rotate('x', 90)
        band:translate(0, 0.19 * y, 0)
        group:add_child(band, gr.material({tint[1] * glow, tint[2] * glow, tint[3] * glow}, {0, 0, 0}, 1))
        if k % 2 == 0 then
            local hoop = gr.torus(name('hoop'), 0.16 * r + 0.019, 0.0028)
            hoop:rotate('x', 90)
            hoop:translate(0, 0.19 * y + 0.0105, 0)
            group:add_child(hoop, rib)
        end
    end
    for side = -1, 1, 2 do group:add_child(gr.nh_cylinder(name('cap'), {0, 0.19 * side - 0.02, 0}, 0.04, 0.075), cap) end
    group:add_child(gr.nh_cylinder(name('cord'), {0, 0.2, 0}, 0.30, 0.004), cap)
    return group
end
local warm, red, white = lantern_of{1.5, 0.85, 0.30}, lantern_of{1.6, 0.24, 0.12}, lantern_of{1.35, 1.12, 0.78}

local lights = {gr.light({-6, 12, 8}, {0.10, 0.12, 0.20}, {1, 0, 0}, 2)}
for k = 0, 27 do
    local side = k % 2 == 0 and -1 or 1
    local z = 0.3 - 1.15 * k
    local place = gr.node(name('place'))
    place:add_child((k % 5 == 2 and red) or (k % 7 == 4 and white) or warm)
    local x, y = side * (0.78 + 0.10 * math.sin(2.3 * k)), 1.62 + 0.08 * math.sin(1.7 * k)
    place:translate(x, y, z)
    root:add_child(place)
    if k < 8 then lights[#lights + 1] = gr.light({x, y - 0.32, z}, {0.46, 0.29, 0.14}, {0.4, 0, 0.9}, 0.08) end
end

-- House fronts: posts, eaves, windows that glow.
local wood = gr.texture('room_post.png', {0.08, 0.08, 0.08}, 16)
local pane = gr.material({1.9, 1.25, 0.55}, {0, 0, 0}, 1)
for k = 0, 16 do
    for side = -1, 1, 2 do
        local z = 2.5 - 2.2 * k
        local x = side * 1.55
        root:add_child(gr.nh_box(name('wall'), {math.min(x, x + side * 0.5), 0, z - 2.2}, {0.5, 3.2, 2.2}), dark)
        root:add_child(gr.nh_box(name('post'), {x - 0.06, 0, z - 0.06}, {0.12, 3.0, 0.12}), nil, wood)
        root:add_child(gr.nh_box(name('eave'), {math.min(x, x - side * 0.55), 2.15, z - 2.2}, {0.55, 0.06, 2.15}), nil, wood)
        if (k * 3 + side) % 4 < 2 then
            root:add_child(gr.nh_box(name('window'), {x - 0.012, 0.75, z - 1.75}, {0.024, 0.95, 1.3}), pane)
            for i = 0, 8 do root:add_child(gr.nh_box(name('bar'), {x - 0.03, 0.70, z - 1.77 + 0.16 * i}, {0.06, 1.05, 0.025}), nil, wood) end
        end
    end
end

local street = gr.nh_box('street', {-1.6, -0.2, -60}, {3.2, 0.2, 70})
street:set_reflection(0.62)
root:add_child(street, gr.material({0.12, 0.12, 0.14}, {0.2, 0.2, 0.2}, 30))

gr.background({0.02, 0.02, 0.04}, {0.03, 0.04, 0.09})
gr.render(root, 'depth_of_field.png', 1280, 720, {0.10, 1.25, 2.6}, {-0.01, 0.02, -1}, {0, 1, 0}, 40, {0.26, 0.26, 0.30}, lights,
          not without and gr.focal({-0.78, 1.62, -2.0}, 0.05, radius) or nil)
