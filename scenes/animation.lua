-- Animation: Newton's cradle over one period, by gr.time, which goes from 0 to 1:
--     ./Project scenes/animation.lua --frames 1-24 -o cradle_##.png
-- Look at: the left ball falls, the right one rises to the same height, the middle ones stay.

local steel = gr.material({0.30, 0.31, 0.33}, {0.70, 0.70, 0.70}, 200)
local wood = gr.texture('planks.png', {0.15, 0.15, 0.15}, 40)
local rod = gr.material({0.62, 0.52, 0.30}, {0.50, 0.50, 0.40}, 80)
local thread = gr.material({0.20, 0.20, 0.22}, {0, 0, 0}, 1)

local size, length = 0.42, 2.3
local swing = 38 * math.cos(2 * math.pi * gr.time)

local root = gr.node('root')
local floor = gr.mesh('floor', 'ground.obj')
floor:scale(80, 80, 80)
floor:rotate('y', 20)
root:add_child(floor, nil, wood)

local ball = gr.sphere('ball')
ball:scale(size, size, size)
ball:translate(0, -length, 0)
ball:set_reflection(0.35)

-- Two threads to each ball, from the two bars at z = -0.8 and 0.8.
local string = gr.cylinder('string')
local reach = math.sqrt(length * length + 0.8 * 0.8)
string:scale(0.012, reach / 2, 0.012)
string:translate(0, -reach / 2, 0)
local tilt = math.deg(math.atan(0.8, length))

local function pendulum(x, angle)
    local arm = gr.node('arm at ' .. x)
    arm:add_child(ball, steel)
    for _, side in ipairs({-1, 1}) do
        local place = gr.node('side ' .. side .. ' of ' .. x)
        place:rotate('x', side * tilt)
        place:translate(0, 0, side * 0.8)
        place:add_child(string, thread)
        arm:add_child(place)
    end
    arm:rotate('z', angle)
    arm:translate(x, 3.1, 0)
    root:add_child(arm)
end

for i = -2, 2 do
    local angle = i == -2 and math.min(-swing, 0) or i == 2 and math.max(-swing, 0) or 0
    pendulum(2 * size * i, angle)
end

for _, z in ipairs({-0.8, 0.8}) do
    local bar = gr.cylinder('bar at ' .. z)
    bar:scale(0.05, 2.35, 0.05)
    bar:rotate('z', 90)
    bar:translate(0, 3.1, z)
    root:add_child(bar, rod)
    for _, x in ipairs({-2.35, 2.35}) do
        root:add_child(gr.nh_cylinder('post ' .. x .. ' ' .. z, {x, 0, z}, 3.1, 0.05), rod)
        root:add_child(gr.nh_sphere('corner ' .. x .. ' ' .. z, {x, 3.1, z}, 0.09), rod)
    end
end

gr.background({0.74, 0.74, 0.72}, {0.44, 0.54, 0.68})
gr.render(root, 'animation.png', 640, 360, {1.0, 2.6, 7.6}, {-0.14, -0.12, -1}, {0, 1, 0}, 34,
          {0.34, 0.34, 0.36}, {gr.light({-5, 8, 5}, {0.70, 0.67, 0.60}, {1, 0, 0}, 0.6)})
