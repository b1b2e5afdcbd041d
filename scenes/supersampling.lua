-- Supersampling: checks up to the horizon, and rods that become thinner than a pixel.
-- Look at: the checks end in an even grey, without moire or a hard line; the thinnest rods fade
-- instead of breaking into dots; the fan's centre is smooth. Compare with --spp 1 --sampler grid.

local dark = gr.material({0.10, 0.11, 0.14}, {0, 0, 0}, 1)
local red = gr.material({0.70, 0.15, 0.12}, {0.20, 0.20, 0.20}, 30)

local root = gr.node('root')
local floor = gr.mesh('floor', 'ground.obj')
floor:scale(512, 512, 512)
floor:rotate('y', 30)
root:add_child(floor, nil, gr.texture('checker.png', {0, 0, 0}, 1))

-- Rods, each thinner than the one before by 7 %: radius 0.06 to 0.0017, a fifth of a pixel wide.
for i = 0, 49 do
    local rod = gr.nh_cylinder('rod ' .. i, {-6.5 + 0.16 * i, 0, -2.2}, 3.4, 0.06 * 0.93 ^ i)
    root:add_child(rod, dark)
end

local fan = gr.node('fan')
for i = 0, 35 do
    local blade = gr.nh_box('blade ' .. i, {-0.008, 0.1, -0.008}, {0.016, 1.55, 0.016})
    blade:rotate('z', i * 10 + 3)
    fan:add_child(blade, red)
end
fan:translate(3.7, 1.85, -1.8)
root:add_child(fan)

gr.background({0.88, 0.88, 0.86}, {0.55, 0.68, 0.85})
gr.render(root, 'supersampling.png', 800, 450, {0, 2.0, 7}, {0, -0.06, -1}, {0, 1, 0}, 40,
          {0.45, 0.45, 0.45}, {gr.light({-60, 90, 60}, {0.60, 0.58, 0.54}, {1, 0, 0})})
