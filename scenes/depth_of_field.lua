-- Depth of field: a lens of radius 0.12, focused on the red ball in the middle of the row.
-- Look at: the checks are sharp along one line only; small bright beads far away become discs with
-- an even brightness and a clear edge, whose size hardly grows any more with the distance.

local root = gr.node('root')

local floor = gr.mesh('floor', 'ground.obj')
floor:scale(128, 128, 128)
floor:rotate('y', 45)
root:add_child(floor, nil, gr.texture('checker.png', {0, 0, 0}, 1))

local eye = {0, 1.9, 6}
local view = {0, -0.24, -1}

local colours = {{0.20, 0.45, 0.75}, {0.25, 0.60, 0.45}, {0.80, 0.20, 0.15}, {0.90, 0.60, 0.15},
                 {0.50, 0.30, 0.60}}
local balls = {}
for i, c in ipairs(colours) do
    local ball = gr.nh_sphere('ball ' .. i, {-1.7 + 0.85 * (i - 1), 0.5, 3.2 - 1.9 * (i - 1)}, 0.5)
    root:add_child(ball, gr.material(c, {0.4, 0.4, 0.4}, 60))
end

-- Beads that glow by themselves: a diffuse colour far above 1 under the ambient light.
local glow = {gr.material({9, 6, 2.5}, {0, 0, 0}, 1), gr.material({3, 5, 9}, {0, 0, 0}, 1)}
for i = 0, 33 do
    local far = -9 - 0.7 * i
    local across = (2 * ((i * 0.618034) % 1) - 1) * 0.52 * (6 - far)
    local bead = gr.nh_sphere('bead ' .. i, {across, 1.2 + (0.10 + 0.03 * (i % 5)) * (6 - far) * 0.35, far}, 0.07)
    root:add_child(bead, glow[i % 2 + 1])
end

gr.background({0.10, 0.11, 0.16}, {0.03, 0.04, 0.08})
gr.render(root, 'depth_of_field.png', 800, 450, eye, view, {0, 1, 0}, 38, {0.30, 0.30, 0.33},
          {gr.light({-5, 8, 6}, {0.70, 0.66, 0.60}, {1, 0, 0}, 0.6)},
          gr.focal({0, 0.5, -0.6}, 0.05, 0.12))
