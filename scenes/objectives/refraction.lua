-- Refraction: a glass of water with a flower, a crystal ball and a cut gem before a painted door.
-- Look at: the stem that breaks at the water's surface; the door upside down in the ball; the gem's facets, some of
-- which reflect everything from within; shadows of glass that are light, with dark rims.
-- Without: opaque.   ./Project scenes/objectives/refraction.lua -D without=true

local without = gr.param('without', false, {doc = 'nothing lets light through'})

local clear = gr.material(without and {0.45, 0.50, 0.52} or {0.02, 0.03, 0.03}, {0.7, 0.7, 0.7}, 400)
local function glass(node, index)
    if not without then
        node:set_refraction(index, 0.04)
        node:set_fresnel(true)
    end
    return node
end

local root = gr.node('root')
root:add_child(gr.nh_box('table', {-3, -0.1, -1.2}, {6, 0.1, 3}), nil, gr.texture('room_washi.png', {0.05, 0.05, 0.05}, 10))
for k, side in ipairs{'left', 'right'} do
    local door = gr.nh_box(side .. ' door', {1.5 * (k - 2), -0.95, -0.95}, {1.5, 2.6, 0.03})
    root:add_child(door, nil, gr.texture('room_fusuma_' .. side .. '.png', {0.1, 0.08, 0.05}, 12))
end

-- The water is created before the glass: where the two overlap, glass holds.
local drink = gr.node('drink')
drink:add_child(glass(gr.mesh('water', 'room_water.obj'), 1.33), clear)
drink:add_child(glass(gr.mesh('tumbler', 'room_tumbler.obj'), 1.5), clear)
local stem = gr.nh_cylinder('stem', {0, 0, 0}, 0.185, 0.0016)
stem:rotate('z', -24)
stem:translate(-0.019, 0.016, 0.004)
drink:add_child(stem, gr.material({0.20, 0.38, 0.14}, {0.1, 0.1, 0.1}, 20))
local flower, petal = gr.node('flower'), gr.mesh('petal', 'room_petal.obj', {smooth = 180})
for k = 0, 4 do
    local place = gr.node('petal ' .. k)
    place:add_child(petal, gr.material({0.45, 0.34, 0.78}, {0.08, 0.08, 0.1}, 12))
    place:rotate('x', 16)
    place:rotate('z', 72 * k)
    flower:add_child(place)
end
flower:add_child(gr.nh_sphere('heart', {0, 0, 0.05}, 0.1), gr.material({0.9, 0.8, 0.4}, {0.1, 0.1, 0.1}, 20))
flower:scale(0.050, 0.050, 0.050)
flower:rotate('x', -20)
flower:rotate('y', 12)
flower:translate(0.058, 0.188, 0.004)
drink:add_child(flower)
drink:scale(2.6, 2.6, 2.6)
drink:translate(-0.02, 0, 0.05)
root:add_child(drink)

root:add_child(glass(gr.nh_sphere('ball', {-0.42, 0.17, 0.02}, 0.17), 1.52), clear)

local gem = glass(gr.mesh('gem', 'dodecahedron.obj', {smooth = false}), 2.0)
gem:rotate('x', 31.717)
gem:rotate('y', 20)
gem:scale(0.13, 0.13, 0.13)
gem:translate(0.38, 0.104, 0.16)
root:add_child(gem, clear)

for k, c in ipairs{{0.72, 0.16, 0.12}, {0.16, 0.32, 0.60}, {0.86, 0.62, 0.16}} do
    root:add_child(gr.nh_sphere('bead ' .. k, {-0.38 + 0.22 * k, 0.035, 0.42 - 0.03 * k * k}, 0.035), gr.material(c, {0.4, 0.4, 0.4}, 60))
end

gr.background({0.30, 0.27, 0.24}, {0.75, 0.74, 0.72})
gr.render(root, 'refraction.png', 1280, 720, {0, 0.42, 1.75}, {0, -0.12, -1}, {0, 1, 0}, 31, {0.32, 0.31, 0.31},
          {gr.light({-1.6, 2.4, 1.4}, {0.62, 0.58, 0.50}, {1, 0, 0}, 0.12), gr.light({2, 1.6, 2}, {0.20, 0.21, 0.24}, {1, 0, 0}, 0.3)})
