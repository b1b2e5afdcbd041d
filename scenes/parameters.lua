-- Parameters: a sunflower of balls whose number, turn and colours the command line sets:
--     ./Project scenes/parameters.lua -D count=400 -D turn=99.5 -D night=yes
-- Look at: with the golden angle no spokes are seen, with any other turn there are; --list-params says
-- what there is to set.

local count = gr.param('count', 260, {min = 1, max = 5000, doc = 'number of balls'})
local turn = gr.param('turn', 137.50776, {doc = 'degrees from each ball to the next'})
local night = gr.param('night', false, {doc = 'dark ground and cool colours'})

local ground = gr.material(night and {0.10, 0.11, 0.16} or {0.76, 0.73, 0.66}, {0.05, 0.05, 0.05}, 10)
local inner = night and {0.30, 0.70, 0.80} or {0.45, 0.20, 0.10}
local outer = night and {0.45, 0.25, 0.70} or {0.95, 0.68, 0.10}

local root = gr.node('root')
root:add_child(gr.nh_box('ground', {-30, -1, -30}, {60, 1, 60}), ground)

for i = 1, count do
    local t = i / count
    local radius = 2.7 * math.sqrt(t)
    local angle = math.rad(turn * i)
    local size = (1.9 + 0.35 * t) / math.sqrt(count)
    local colour = {}
    for k = 1, 3 do colour[k] = inner[k] + (outer[k] - inner[k]) * t end
    local height = size + 0.9 * (1 - t) * (1 - t)
    root:add_child(gr.nh_sphere('ball ' .. i, {radius * math.cos(angle), height, radius * math.sin(angle)}, size),
                   gr.material(colour, {0.35, 0.35, 0.35}, 60))
end

gr.background({0.55, 0.58, 0.62}, {0.35, 0.42, 0.55})
gr.render(root, 'parameters.png', 800, 450, {0, 5.3, 6.3}, {0, -0.84, -1}, {0, 1, 0}, 36,
          {0.30, 0.30, 0.32}, {gr.light({-5, 8, 3}, {0.72, 0.68, 0.60}, {1, 0, 0}, 0.8)})
