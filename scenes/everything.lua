-- Everything at once: a mirror, a cup of tea, a glass of water, textures and bumps, two sphere lights, a spot,
-- a lens, meshes, instances, a die of combined solids and a panorama.
-- Look at: the focus lies on the cup; the mirror shows the table's other side, out of focus; both
-- lights' shadows are soft, those of the glass light; the wall's bricks are bumps only.

local root = gr.node('root')

local wood = gr.texture('planks.png', {0.12, 0.12, 0.12}, 30)
local bricks = gr.texture('bricks.png', {0.05, 0.05, 0.05}, 10)
local china = gr.material({0.82, 0.81, 0.78}, {0.50, 0.50, 0.50}, 120)
local glaze = gr.material({0.16, 0.34, 0.46}, {0.55, 0.55, 0.55}, 90)
local tea = gr.material({0.40, 0.16, 0.04}, {0.60, 0.60, 0.60}, 200)
local clear = gr.material({0.02, 0.02, 0.02}, {0.70, 0.70, 0.70}, 400)
local silver = gr.material({0.03, 0.03, 0.03}, {0.60, 0.60, 0.60}, 300)
local gilt = gr.material({0.66, 0.48, 0.18}, {0.55, 0.48, 0.30}, 60)
local rose = gr.material({0.76, 0.24, 0.30}, {0.45, 0.45, 0.45}, 60)
local jade = gr.material({0.24, 0.50, 0.36}, {0.55, 0.55, 0.55}, 70)
local brass = gr.material({0.70, 0.50, 0.18}, {0.55, 0.50, 0.35}, 60)

local table_top = gr.mesh('table', 'ground.obj')
table_top:scale(96, 96, 96)
table_top:rotate('y', 8)
root:add_child(table_top, nil, wood)

-- A wall of squares of 2.5, each with the whole image.
local relief = gr.bumpmap('bricks_normal.png')
for i = -3, 3 do
    for j = 0, 1 do
        local wall = gr.nh_box('wall ' .. i .. ' ' .. j, {2.5 * i - 1.25, 2.5 * j, -5.4}, {2.5, 2.5, 0.4})
        root:add_child(wall, nil, bricks, relief)
    end
end

-- A mirror in a gilt frame hangs on the wall, its upper edge towards the table.
local mirror = gr.node('mirror')
local pane = gr.nh_box('pane', {-1.15, 0.15, 0}, {2.3, 2.9, 0.06})
pane:set_reflection(0.05)
mirror:add_child(pane, silver)
mirror:add_child(gr.nh_box('left', {-1.3, 0, -0.04}, {0.15, 3.2, 0.14}), gilt)
mirror:add_child(gr.nh_box('right', {1.15, 0, -0.04}, {0.15, 3.2, 0.14}), gilt)
mirror:add_child(gr.nh_box('lower', {-1.15, 0, -0.04}, {2.3, 0.15, 0.14}), gilt)
mirror:add_child(gr.nh_box('upper', {-1.15, 3.05, -0.04}, {2.3, 0.15, 0.14}), gilt)
mirror:scale(1, 0.66, 1)
mirror:rotate('x', 13)
mirror:rotate('y', 12)
mirror:translate(-1.75, 0.8, -4.6)
root:add_child(mirror)

local cup = gr.node('cup')
cup:add_child(gr.mesh('body', 'cup.obj'), china)
cup:add_child(gr.mesh('handle', 'cup_handle.obj'), china)
local drink = gr.mesh('tea', 'tea.obj')
drink:set_refraction(1.33, 0.55)
drink:set_fresnel(true)
drink:set_absorption({0.3, 0.9, 2.4})
cup:add_child(drink, tea)
cup:rotate('y', -28)
local saucer = gr.cone('saucer')
saucer:scale(1.25, 0.16, 1.25)
root:add_child(saucer, china)
cup:translate(0, 0.10, 0)
root:add_child(cup)

local glass = gr.node('glass')
local water = gr.mesh('water', 'water.obj')
water:set_refraction(1.33, 0)
water:set_fresnel(true)
local tumbler = gr.mesh('tumbler', 'tumbler.obj')
tumbler:set_refraction(1.5, 0)
tumbler:set_fresnel(true)
glass:add_child(water, clear)
glass:add_child(tumbler, clear)
glass:scale(1.15, 1.15, 1.15)
glass:translate(2.1, 0, -0.6)
root:add_child(glass)

local vase = gr.mesh('vase', 'vase.obj')
vase:translate(0.95, 0, -3.0)
root:add_child(vase, glaze)

local blob = gr.mesh('blob', 'blob.obj')
blob:rotate('y', 60)
blob:scale(0.42, 0.42, 0.42)
blob:translate(-1.9, 0.42, -0.7)
root:add_child(blob, jade)

local gem = gr.mesh('gem', 'dodecahedron.obj')
gem:rotate('x', 31.717)
gem:rotate('y', 20)
gem:scale(0.4, 0.4, 0.4)
gem:translate(1.35, 0.318, 1.2)
root:add_child(gem, rose)

local studded = gr.sphere('studded')
studded:scale(0.55, 0.55, 0.55)
studded:translate(3.1, 0.55, -2.5)
root:add_child(studded, brass, nil, gr.bumpmap('studs_normal.png'))

-- A die: a cube with its corners rounded by a ball, less its pips. Opposite faces add up to seven.
local pips = gr.node('pips')
local function pip(name, centre, radius) pips:add_child(gr.nh_sphere(name, centre, radius), glaze) end
pip('one', {0, 1.25, 0}, 0.35)
for _, side in ipairs{-0.5, 0.5} do
    pip('two, ' .. side, {1.1, side, side}, 0.22)
    for _, other in ipairs{-0.5, 0.5} do
        pip('five, ' .. side .. other, {-1.1, side, other}, 0.22)
        pip('four, ' .. side .. other, {side, other, -1.1}, 0.22)
    end
    for row = -1, 1 do pip('six, ' .. side .. row, {side, -1.1, 0.55 * row}, 0.22) end
end
for i = -1, 1 do pip('three, ' .. i, {0.55 * i, 0.55 * i, 1.1}, 0.22) end
pip('five, middle', {-1.1, 0, 0}, 0.22)
local cube = gr.nh_box('faces', {-1, -1, -1}, 2)
cube:set_material(china)
local rounding = gr.nh_sphere('corners', {0, 0, 0}, 1.5)
rounding:set_material(china)
local die = gr.difference('die', gr.intersection('rounded', cube, rounding), pips)
die:scale(0.2, 0.2, 0.2)
die:rotate('y', 35)
die:translate(2.35, 0.2, 1.5)
root:add_child(die)

-- A string of pearls, one ball in forty places, lies around the cup; the last one rolls.
local pearl = gr.sphere('pearl')
pearl:scale(0.085, 0.085, 0.085)
for i = 0, 39 do
    local a = math.rad(100 + 3.6 * i)
    local r = 1.75 + 0.12 * math.sin(i * 0.55)
    local place = gr.node('place ' .. i)
    place:translate(r * math.cos(a) - 0.1, 0.085, r * math.sin(a) * 0.9 + 0.15)
    place:add_child(pearl, china)
    if i == 39 then place:move(0.09, 0, 0.03) end
    root:add_child(place)
end

gr.background('sky.png')
gr.render(root, 'everything.png', 1280, 720, {0.35, 2.5, 6.4}, {-0.03, -0.24, -1}, {0, 1, 0}, 35,
          {0.30, 0.30, 0.33},
          {gr.light({-5, 7, 5}, {0.70, 0.64, 0.54}, {1, 0, 0}, 0.9),
           gr.light({5, 5, 3.5}, {0.30, 0.34, 0.42}, {1, 0, 0}, 0.5),
           gr.spot_light{position = {3.2, 4.4, 2.2}, direction = {-1.1, -4.4, -2.8}, colour = {0.55, 0.45, 0.25},
                         inner = 14, outer = 22}},
          gr.focal({0, 0.6, 0.5}, 0.05, 0.05))
