-- Instances: a forest of some 2,000 trees that are eighteen trees; every place in it is an edge of the
-- graph.
-- Look at: no tree is like its neighbour, by turn, size and colour; memory and loading time hardly
-- change with their number (--stats).

local bark = gr.material({0.36, 0.25, 0.16}, {0, 0, 0}, 1)
local meadow = gr.material({0.42, 0.50, 0.24}, {0, 0, 0}, 1)
local greens = {}
for i = 1, 6 do
    local t = (i - 1) / 5
    greens[i] = gr.material({0.14 + 0.30 * t, 0.34 + 0.10 * t, 0.16 - 0.04 * t}, {0.05, 0.05, 0.05}, 10)
end

-- A fir: cones on a trunk. Appearance belongs to edges, so each green needs its own few nodes.
local layer = gr.cone('layer')
local trunk = gr.nh_cylinder('trunk', {0, 0, 0}, 1, 0.1)
local crown = gr.sphere('crown')

local function fir(name, layers, green)
    local tree = gr.node(name)
    tree:add_child(trunk, bark)
    for i = 1, layers do
        local size = 0.75 * (1 - (i - 1) / (layers + 0.6))
        local part = gr.node(name .. ' layer ' .. i)
        part:scale(size, -1.1 * size, size)
        part:translate(0, 0.45 + 1.1 * size + 0.52 * (i - 1) * (4 / layers), 0)
        part:add_child(layer, green)
        tree:add_child(part)
    end
    return tree
end

local function oak(name, green)
    local tree = gr.node(name)
    tree:add_child(trunk, bark)
    for i, c in ipairs({{0, 1.5, 0, 0.62}, {0.42, 1.2, 0.15, 0.45}, {-0.36, 1.25, 0.25, 0.42},
                          {0.02, 1.2, -0.42, 0.44}}) do
        local part = gr.node(name .. ' leaves ' .. i)
        part:scale(c[4], c[4], c[4])
        part:translate(c[1], c[2], c[3])
        part:add_child(crown, green)
        tree:add_child(part)
    end
    return tree
end

local trees = {}
for i, green in ipairs(greens) do
    trees[#trees + 1] = fir('small fir ' .. i, 4, green)
    trees[#trees + 1] = fir('tall fir ' .. i, 5, green)
    trees[#trees + 1] = oak('oak ' .. i, green)
end

local root = gr.node('root')
root:add_child(gr.nh_cylinder('meadow', {0, -1, -40}, 1, 90), meadow)

for row = 0, 48 do
    for column = 0, 40 do
        local x = (column - 20) * 1.7 + 1.1 * (math.random() - 0.5)
        local z = 6 - row * 1.7 + 1.1 * (math.random() - 0.5)
        local path = math.abs(x - 3 * math.sin(z * 0.16))
        if path > 1.6 + 0.9 * math.random() then
            local place = gr.node('place ' .. row .. ' ' .. column)
            local size = 0.75 + 0.6 * math.random()
            place:scale(size, size, size)
            place:rotate('y', 360 * math.random())
            place:translate(x, 0, z)
            place:add_child(trees[math.random(#trees)])
            root:add_child(place)
        end
    end
end

gr.background({0.86, 0.86, 0.80}, {0.36, 0.54, 0.78})
gr.render(root, 'instances.png', 800, 450, {0.6, 7.5, 19}, {0, -0.30, -1}, {0, 1, 0}, 36,
          {0.36, 0.38, 0.42}, {gr.light({-60, 60, 25}, {0.72, 0.68, 0.56}, {1, 0, 0}, 2)})
