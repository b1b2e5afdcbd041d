-- Texture mapping: things that are plain solids but for the pictures on them.
-- Look at: the doll's face on a ball, the band of waves round the bowl, the spines of the books, grain that runs along
-- every board. Without: one colour each.   ./Project scenes/objectives/texture_mapping.lua -D without=true

local without = gr.param('without', false, {doc = 'one colour instead of each picture'})

-- A texture, or a material of the picture's middle colour.
local function look(file, colour, specular, exponent)
    specular = specular or {0.1, 0.1, 0.1}
    if without then return gr.material(colour, specular, exponent or 20), nil end
    return nil, gr.texture(file, specular, exponent or 20)
end

local root, count = gr.node('root'), 0
local function name(word) count = count + 1; return word .. ' ' .. count end
local function put(node, material, texture) root:add_child(node, material, texture) end

local shelf = gr.mesh('shelf', 'room_board_3.obj')
shelf:rotate('z', -90)
shelf:scale(3, 0.05, 0.7)
shelf:translate(0, -0.025, 0.05)
put(shelf, look('room_cedar.png', {0.66, 0.47, 0.29}))
local wall = gr.mesh('wall', 'room_sheet_4x3.obj')
wall:scale(4, 3, 1)
wall:translate(0, 0.5, -0.28)
put(wall, look('room_plaster.png', {0.69, 0.61, 0.46}, {0.02, 0.02, 0.02}, 4))

local scroll = gr.mesh('scroll', 'room_sheet_1x1.obj')
scroll:scale(0.36, 0.72, 1)
scroll:translate(-0.33, 0.40, -0.27)
put(scroll, look('room_scroll.png', {0.55, 0.55, 0.48}, {0.05, 0.05, 0.05}))

-- Two dolls.
for k, at in ipairs{{-0.30, 0.10, 1.7, 18}, {-0.16, 0.14, 1.25, 4}} do
    local doll = gr.node('doll ' .. k)
    doll:add_child(gr.mesh(name('body'), 'room_doll.obj'), look('room_kokeshi.png', {0.84, 0.68, 0.46}, {0.25, 0.25, 0.25}, 50))
    doll:add_child(gr.nh_sphere(name('head'), {0, 0.110, 0}, 0.026), look('room_kokeshi_face.png', {0.84, 0.68, 0.50}, {0.25, 0.25, 0.25}, 50))
    doll:scale(at[3], at[3], at[3])
    doll:rotate('y', at[4])
    doll:translate(at[1], 0, at[2])
    put(doll)
end

local books = gr.nh_box('books', {0, 0, 0}, {0.36, 0.23, 0.15})
books:rotate('y', -12)
books:translate(0.22, 0, -0.12)
put(books, look('room_books.png', {0.34, 0.27, 0.20}))

local bowl = gr.mesh('bowl', 'room_bowl.obj')
bowl:scale(1.3, 1.3, 1.3)
bowl:translate(0.10, 0, 0.16)
put(bowl, look('room_waves.png', {0.72, 0.76, 0.84}, {0.55, 0.55, 0.55}, 140))

local cup = gr.mesh('cup', 'room_teacup.obj')
cup:rotate('y', 130)
cup:translate(0.30, 0, 0.20)
put(cup, look('room_raku.png', {0.26, 0.42, 0.38}, {0.45, 0.45, 0.45}, 80))

-- A ball in cloth, a box in cloth, a fan that leans on the books.
local globe = gr.sphere('globe')
globe:rotate('z', 20)
globe:scale(0.075, 0.075, 0.075)
globe:translate(-0.53, 0.075, 0.13)
put(globe, look('room_crimson.png', {0.56, 0.16, 0.12}, {0.3, 0.3, 0.3}, 50))

local chest = gr.nh_box('chest', {0, 0, 0}, {0.20, 0.13, 0.16})
chest:rotate('y', 24)
chest:translate(-0.74, 0, -0.10)
put(chest, look('room_indigo.png', {0.24, 0.30, 0.46}, {0.04, 0.04, 0.04}, 8))

local fan = gr.node('fan')
local disc = gr.nh_cylinder('disc', {0, 0, 0}, 0.003, 0.125)
disc:rotate('x', 90)
fan:add_child(disc, look('room_fan.png', {0.90, 0.89, 0.84}))
local rim = gr.torus('rim', 0.125, 0.003)
fan:add_child(rim, gr.material({0.62, 0.53, 0.29}, {0.2, 0.2, 0.2}, 40))
local handle = gr.nh_cylinder('handle', {0, -0.22, 0.002}, 0.20, 0.006)
fan:add_child(handle, gr.material({0.62, 0.53, 0.29}, {0.2, 0.2, 0.2}, 40))
fan:rotate('x', -14)
fan:rotate('y', -16)
fan:translate(0.70, 0.22, 0.00)
put(fan)

gr.render(root, 'texture_mapping.png', 1280, 720, {0.0, 0.46, 1.75}, {0, -0.13, -1}, {0, 1, 0}, 32, {0.28, 0.27, 0.28},
          {gr.light({-1.5, 1.9, 1.8}, {0.72, 0.64, 0.52}, {1, 0, 0}, 0.18), gr.light({1.8, 1.2, 1.8}, {0.20, 0.23, 0.30}, {1, 0, 0}, 0.3)})
