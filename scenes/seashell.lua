-- A seashell from a handful of parameters: a circle that grows while it is turned and moved down (D. Fowler,
-- H. Meinhardt, P. Prusinkiewicz, Modeling Seashells, 1992). The mesh is a table of the script.
-- Try: -D growth=1.9 -D translate=0.4 (a snail), -D growth=3.2 -D translate=0 -D turns=3 (a nautilus),
--      -D growth=1.35 -D translate=3.4 -D turns=9 (a spire); --list-params says what there is.

local growth = gr.param('growth', 1.48, {min = 1.05, max = 20, doc = 'how much it grows with each turn'})
local turns = gr.param('turns', 8, {min = 0.5, max = 20, doc = 'number of turns'})
local translate = gr.param('translate', 2.6, {min = 0, max = 8, doc = 'how far it moves along its axis'})
local mouth = gr.param('mouth', 1.05, {min = 0.2, max = 3, doc = 'radius of the mouth'})
local ribs = gr.param('ribs', 17, {min = 0, max = 60, doc = 'ribs to a turn'})
local detail = gr.param('detail', 90, {min = 8, max = 600, doc = 'points round the mouth'})

local steps = math.floor(turns * detail * 1.6)
local points, bands = {}, {{}, {}, {}}
for i = 0, steps do
    local a = 2 * math.pi * turns * (i / steps - 1)
    local size = growth ^ (a / (2 * math.pi))
    local rib = ribs > 0 and 0.035 * math.max(0, math.cos(ribs * a)) ^ 2 or 0
    for k = 0, detail - 1 do
        local b = 2 * math.pi * k / detail
        local ridge = 1 + rib + 0.012 * math.cos(9 * b)
        local r = size * (1 + mouth * ridge * math.cos(b))
        points[#points + 1] = {r * math.cos(a), size * (mouth * 1.1 * ridge * math.sin(b) - translate), r * math.sin(a)}
    end
end
-- Three colours, in stripes that run with the growth.
for i = 0, steps - 1 do
    for k = 0, detail - 1 do
        local n, here, there = (k + 1) % detail, i * detail, (i + 1) * detail
        local wave = math.sin(2 * math.pi * 6 * k / detail) + 0.4 * math.sin(2 * math.pi * 14 * k / detail)
        local band = bands[wave > 0.45 and 1 or wave > -0.1 and 2 or 3]
        band[#band + 1] = {here + k, there + k, there + n, here + n}
    end
end

local root, shell = gr.node('root'), gr.node('shell')
local looks = {gr.material({0.58, 0.27, 0.14}, {0.35, 0.33, 0.30}, 60), gr.material({0.86, 0.62, 0.42}, {0.35, 0.33, 0.30}, 60),
               gr.material({0.93, 0.86, 0.74}, {0.35, 0.33, 0.30}, 60)}
for k, faces in ipairs(bands) do
    if #faces > 0 then shell:add_child(gr.mesh('band ' .. k, points, faces, {smooth = 60}), looks[k]) end
end
-- Brought to a size of 2, whatever the parameters are, and laid on its side.
local low, high = {1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}
for _, p in ipairs(points) do
    for axis = 1, 3 do low[axis], high[axis] = math.min(low[axis], p[axis]), math.max(high[axis], p[axis]) end
end
local size = math.max(high[1] - low[1], high[2] - low[2], high[3] - low[3])
shell:translate(-(low[1] + high[1]) / 2, -(low[2] + high[2]) / 2, -(low[3] + high[3]) / 2)
shell:scale(2.4 / size, 2.4 / size, 2.4 / size)
shell:rotate('y', 20)
shell:rotate('z', 98)
shell:rotate('y', -28)
shell:translate(0, 0.86, 0)
root:add_child(shell)

local sand = gr.mesh('sand', 'ground.obj')
sand:scale(90, 90, 90)
root:add_child(sand, nil, gr.texture('room_plaster.png', {0.02, 0.02, 0.02}, 4), gr.bumpmap('room_plaster_normal.png'))
for k = 1, 60 do
    local a, r, s = 2 * math.pi * math.random(), 1.3 + 3.2 * math.random(), 0.03 + 0.08 * math.random() ^ 2
    local pebble = gr.sphere('pebble ' .. k)
    pebble:scale(s, s * 0.6, s * 0.8)
    pebble:rotate('y', 360 * math.random())
    pebble:translate(r * math.cos(a), s * 0.3, r * math.sin(a))
    local grey = 0.35 + 0.4 * math.random()
    root:add_child(pebble, gr.material({grey, grey * 0.96, grey * 0.90}, {0.15, 0.15, 0.15}, 20))
end

gr.background({0.80, 0.84, 0.84}, {0.46, 0.62, 0.76})
gr.render(root, 'seashell.png', 1280, 720, {0, 2.0, 4.7}, {0, -0.28, -1}, {0, 1, 0}, 34, {0.30, 0.30, 0.33},
          {gr.light({-4, 4.5, 3}, {0.78, 0.70, 0.56}, {1, 0, 0}, 0.35), gr.light({5, 4, 4}, {0.18, 0.21, 0.27}, {1, 0, 0}, 1)},
          gr.focal({0.1, 0.8, 0.6}, 0.05, 0.03))
