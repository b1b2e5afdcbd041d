-- Primitives: a toy locomotive of boxes, cylinders, cones, spheres and tori.
-- Look at: round rims and clean joints where solids meet; the chain of smoke; the tori of the wheels.
-- Without: every solid becomes the box around it.   ./Project scenes/objectives/primitives.lua -D without=true

local without = gr.param('without', false, {doc = 'boxes only'})

local red = gr.material({0.70, 0.13, 0.10}, {0.42, 0.38, 0.36}, 70)
local green = gr.material({0.10, 0.34, 0.22}, {0.40, 0.42, 0.40}, 70)
local black = gr.material({0.06, 0.06, 0.07}, {0.40, 0.40, 0.42}, 60)
local brass = gr.material({0.66, 0.46, 0.15}, {0.55, 0.47, 0.28}, 60)
local cream = gr.material({0.86, 0.80, 0.66}, {0.22, 0.22, 0.20}, 40)
local wood = gr.texture('room_cedar.png', {0.10, 0.10, 0.08}, 20)
local smoke = gr.material({0.86, 0.85, 0.84}, {0, 0, 0}, 1)

local root = gr.node('root')
local count = 0
local function name(word) count = count + 1; return word .. ' ' .. count end

local function box(parent, low, high, look, texture)
    parent:add_child(gr.nh_box(name('box'), low, {high[1] - low[1], high[2] - low[2], high[3] - low[3]}), look, texture)
end
local function ball(parent, c, r, look)
    if without then return box(parent, {c[1] - r, c[2] - r, c[3] - r}, {c[1] + r, c[2] + r, c[3] + r}, look) end
    parent:add_child(gr.nh_sphere(name('ball'), c, r), look)
end
-- Cylinder, cone and torus about an axis, 'x', 'y' or 'z'.
local function turned(parent, solid, half, axis, c, look)
    local node = without and gr.nh_box(name('box'), {-half[1], -half[2], -half[1]}, {2 * half[1], 2 * half[2], 2 * half[1]}) or solid
    if axis == 'x' then node:rotate('z', -90) elseif axis == 'z' then node:rotate('x', 90) end
    node:translate(c[1], c[2], c[3])
    parent:add_child(node, look)
end
local function rod(parent, axis, c, length, r, look)
    turned(parent, gr.nh_cylinder(name('rod'), {0, -length / 2, 0}, length, r), {r, length / 2}, axis, c, look)
end
local function cone(parent, axis, c, length, r, look)
    turned(parent, gr.nh_cone(name('cone'), {0, -length / 2, 0}, length, r), {r, length / 2}, axis, c, look)
end
local function ring(parent, axis, c, big, small, look)
    local torus = gr.torus(name('ring'), big, small)
    torus:rotate('x', 90)
    turned(parent, torus, {big + small, small}, axis, c, look)
end

local function wheel(parent, x, z, r)
    ring(parent, 'z', {x, r, z}, r - 0.035, 0.035, black)
    rod(parent, 'z', {x, r, z}, 0.05, 0.055, brass)
    for k = 0, 2 do
        local spoke = gr.nh_box(name('spoke'), {-0.013, -(r - 0.04), -0.012}, {0.026, 2 * (r - 0.04), 0.024})
        spoke:rotate('z', 60 * k)
        spoke:translate(x, r, z)
        parent:add_child(spoke, red)
    end
end

local engine = gr.node('engine')
rod(engine, 'x', {0.15, 0.80, 0}, 1.50, 0.34, green)
rod(engine, 'x', {0.98, 0.80, 0}, 0.18, 0.37, black)
ball(engine, {1.07, 0.80, 0}, 0.10, brass)
for _, x in ipairs{-0.45, 0.0, 0.45} do ring(engine, 'x', {x, 0.80, 0}, 0.345, 0.018, brass) end
rod(engine, 'y', {0.72, 1.28, 0}, 0.40, 0.10, black)
cone(engine, 'y', {0.72, 1.50, 0}, 0.34, 0.21, black)
ring(engine, 'y', {0.72, 1.665, 0}, 0.205, 0.022, brass)
ball(engine, {0.05, 1.13, 0}, 0.17, brass)
rod(engine, 'y', {-0.33, 1.16, 0}, 0.16, 0.07, brass)
box(engine, {-1.15, 0.40, -0.42}, {-0.55, 1.30, 0.42}, red)
box(engine, {-0.98, 0.92, -0.425}, {-0.70, 1.18, 0.425}, cream)
box(engine, {-1.28, 1.30, -0.52}, {-0.44, 1.37, 0.52}, black)
box(engine, {-1.20, 0.32, -0.34}, {1.15, 0.46, 0.34}, red)
cone(engine, 'x', {1.22, 0.34, 0}, 0.30, 0.26, red)
for side = -1, 1, 2 do
    for _, x in ipairs{-0.80, -0.22, 0.36} do wheel(engine, x, 0.40 * side, 0.27) end
    wheel(engine, 0.86, 0.40 * side, 0.18)
    rod(engine, 'x', {-0.22, 0.21, 0.45 * side}, 1.2, 0.025, brass)
end
root:add_child(engine)

local tender = gr.node('tender')
box(tender, {-0.55, 0.32, -0.38}, {0.55, 0.80, 0.38}, green)
box(tender, {-0.57, 0.78, -0.40}, {0.57, 0.83, 0.40}, brass)
for k = 0, 33 do
    ball(tender, {-0.44 + 0.11 * (k % 9), 0.84 + 0.05 * ((k * 7) % 3) / 2, -0.27 + 0.18 * (k // 9)}, 0.085, black)
end
for side = -1, 1, 2 do
    for _, x in ipairs{-0.30, 0.30} do wheel(tender, x, 0.38 * side, 0.20) end
end
tender:translate(-1.95, 0, 0)
root:add_child(tender)
rod(root, 'x', {-1.30, 0.36, 0}, 0.30, 0.03, brass)

-- Smoke, track and floor.
for k = 0, 8 do
    ball(root, {0.70 - 0.06 * k * k * 0.9, 1.80 + 0.20 * k ^ 0.8, 0.04 * math.sin(2 * k)}, 0.10 + 0.022 * k, smoke)
end
for k = -9, 7 do box(root, {0.42 * k - 0.08, -0.10, -0.62}, {0.42 * k + 0.08, -0.05, 0.62}, nil, wood) end
for side = -1, 1, 2 do box(root, {-5, -0.05, 0.40 * side - 0.025}, {4, 0, 0.40 * side + 0.025}, brass) end

root:rotate('y', -32)

-- A floor of planks before a wall.
local room = gr.node('room')
room:add_child(root)
local planks = gr.mesh('planks', 'ground.obj')
planks:scale(128, 128, 128)
planks:rotate('y', 8)
planks:translate(0, -0.10, 0)
room:add_child(planks, nil, gr.texture('planks.png', {0.14, 0.13, 0.12}, 30))
room:add_child(gr.nh_box('wall', {-30, -0.10, -4.6}, {60, 20, 1}), gr.material({0.52, 0.60, 0.58}, {0.02, 0.02, 0.02}, 6))
room:add_child(gr.nh_box('skirting', {-30, -0.10, -3.65}, {60, 0.35, 0.08}), cream)

gr.background({0.62, 0.68, 0.70}, {0.40, 0.55, 0.68})
gr.render(room, 'primitives.png', 1280, 720, {-0.3, 2.0, 6.2}, {-0.07, -0.17, -1}, {0, 1, 0}, 33, {0.27, 0.28, 0.31},
          {gr.light({-5, 8, 6}, {0.70, 0.66, 0.58}, {1, 0, 0}, 0.5), gr.light({6, 4, 5}, {0.16, 0.19, 0.24}, {1, 0, 0}, 1.0)})
