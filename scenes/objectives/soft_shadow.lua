-- Soft shadows: a maple twig, a lattice and a bench before a plaster wall, in a low sun and the glow of the sky.
-- Look at: leaves that touch the wall have sharp shadows, those far from it melt into each other; the lattice's bars
-- lose their edges along the floor. Without: points of light.   ./Project scenes/objectives/soft_shadow.lua -D without=true

local without = gr.param('without', false, {doc = 'lights without a size'})

local root, count = gr.node('root'), 0
local function name(word) count = count + 1; return word .. ' ' .. count end

local plaster = gr.texture('room_plaster.png', {0.02, 0.02, 0.02}, 4)
for i = -1, 1 do
    local wall = gr.mesh(name('wall'), 'room_sheet_2x4.obj')
    wall:scale(1.6, 2.6, 1)
    wall:translate(1.6 * i, 1.3, 0)
    root:add_child(wall, nil, plaster)
end
local floor = gr.mesh(name('floor'), 'room_sheet_5x4.obj')
floor:scale(5, 4, 1)
floor:rotate('x', -90)
floor:translate(0, 0, 2)
root:add_child(floor, nil, gr.texture('plaster.png', {0.03, 0.03, 0.03}, 6))

local wood = gr.texture('room_post.png', {0.12, 0.11, 0.1}, 20)
local cedar = gr.texture('room_cedar.png', {0.12, 0.11, 0.1}, 20)

-- A bench with a kettle and a bowl.
root:add_child(gr.nh_box('seat', {-0.15, 0.34, 0.22}, {1.15, 0.05, 0.36}), nil, cedar)
for _, x in ipairs{-0.05, 0.82} do root:add_child(gr.nh_box(name('leg'), {x, 0, 0.26}, {0.07, 0.34, 0.28}), nil, cedar) end
local kettle = gr.node('kettle')
for _, part in ipairs{'', '_lid', '_spout', '_handle'} do
    kettle:add_child(gr.mesh('iron' .. part, 'room_kettle' .. part .. '.obj'), nil, gr.texture('room_iron.png', {0.25, 0.25, 0.25}, 24))
end
kettle:rotate('y', 200)
kettle:translate(0.60, 0.39, 0.40)
root:add_child(kettle)
local bowl = gr.mesh('bowl', 'room_bowl.obj')
bowl:translate(0.22, 0.39, 0.42)
root:add_child(bowl, nil, gr.texture('room_waves.png', {0.5, 0.5, 0.5}, 120))

-- The lattice stands on the left, turned towards the viewer.
local lattice = gr.node('lattice')
for i = 0, 9 do lattice:add_child(gr.nh_box(name('bar'), {0.09 * i, 0, 0}, {0.022, 1.5, 0.022}), nil, wood) end
for _, y in ipairs{0.12, 0.75, 1.40} do lattice:add_child(gr.nh_box(name('rail'), {-0.03, y, -0.004}, {0.90, 0.04, 0.030}), nil, wood) end
lattice:rotate('y', 52)
lattice:translate(-1.50, 0, 1.15)
root:add_child(lattice)

-- A twig that leans against the wall at its foot and comes away from it.
local bark = gr.material({0.25, 0.18, 0.13}, {0.03, 0.03, 0.03}, 6)
local greens = {gr.material({0.55, 0.20, 0.10}, {0.1, 0.08, 0.06}, 12), gr.material({0.70, 0.36, 0.12}, {0.1, 0.08, 0.06}, 12),
                gr.material({0.62, 0.27, 0.10}, {0.1, 0.08, 0.06}, 12)}
local leaf = gr.mesh('leaf', 'room_leaf.obj', {smooth = 180})
local function twig(p, d, length, radius, level)
    local q = {p[1] + d[1] * length, p[2] + d[2] * length, math.max(0.01, p[3] + d[3] * length)}
    local stick = gr.nh_cylinder(name('stick'), {0, 0, 0}, length, radius)
    stick:rotate('z', -math.deg(math.acos(d[2])))
    stick:rotate('y', -math.deg(math.atan(d[3], d[1])))
    stick:translate(p[1], p[2], p[3])
    root:add_child(stick, bark)
    for _ = 1, level < 3 and 4 or 0 do
        local node = gr.node(name('leaf'))
        node:add_child(leaf, greens[math.random(3)])
        local size = 0.07 + 0.04 * math.random()
        node:scale(size, size, size)
        node:rotate('z', 360 * math.random())
        node:rotate('x', -50 * math.random())
        node:rotate('y', 80 * (math.random() - 0.5))
        node:translate(q[1] + 0.10 * (math.random() - 0.5), q[2] + 0.10 * (math.random() - 0.5), q[3] + 0.03)
        root:add_child(node)
    end
    if level == 0 then return end
    for k = 1, 2 do
        local e = {d[1] + (k == 1 and -0.5 or 0.5) + 0.5 * (math.random() - 0.5), d[2] + 0.4 * (math.random() - 0.5), d[3] + 0.35 * (math.random() - 0.35)}
        local s = math.sqrt(e[1] ^ 2 + e[2] ^ 2 + e[3] ^ 2)
        twig(q, {e[1] / s, e[2] / s, e[3] / s}, length * 0.78, radius * 0.7, level - 1)
    end
end
twig({-0.75, 0.75, 0.06}, {0.15, 0.97, 0.19}, 0.34, 0.012, 4)
-- Another hangs out of sight, between the sun and the wall.
twig({-1.10, 2.02, 1.30}, {0.93, -0.34, 0.10}, 0.34, 0.012, 4)
root:add_child(gr.nh_cylinder('pot', {-0.75, 0, 0.22}, 0.32, 0.11), nil, gr.texture('room_raku.png', {0.4, 0.4, 0.4}, 80))
local trunk = gr.nh_cylinder('trunk', {0, 0, 0}, 0.47, 0.014)
trunk:rotate('x', -20)
trunk:translate(-0.75, 0.31, 0.22)
root:add_child(trunk, bark)

local function light(at, colour, radius) return gr.light(at, colour, {1, 0, 0}, without and 0 or radius) end
gr.render(root, 'soft_shadow.png', 1280, 720, {-0.10, 1.00, 3.35}, {-0.045, -0.06, -1}, {0, 1, 0}, 33, {0.22, 0.22, 0.27},
          {light({-5.2, 3.9, 6.2}, {0.82, 0.66, 0.42}, 0.34), light({3.2, 3.0, 3.6}, {0.26, 0.31, 0.40}, 0.8)})
