-- Ten thousand tori on a spiral: a galaxy of rings. One torus is stored, the rest are places.
-- Look at: rings that are round however far away, their inner edges, the hue that turns with the arms.
-- -D count=100 for a few, -D arms=5 for another galaxy.

local count = gr.param('count', 10000, {min = 1, max = 100000, doc = 'number of tori'})
local arms = gr.param('arms', 3, {min = 1, max = 9, doc = 'arms of the spiral'})

-- 24 hues, each one node.
local ring = gr.torus('ring', 1, 0.26)
local hues = {}
for k = 0, 23 do
    local function wave(shift) return 0.5 + 0.5 * math.cos(2 * math.pi * (k / 24 - shift)) end
    hues[k] = gr.node('hue ' .. k)
    hues[k]:add_child(ring, gr.material({0.18 + 0.75 * wave(0.06), 0.16 + 0.48 * wave(0.16), 0.24 + 0.62 * wave(0.62)}, {0.55, 0.55, 0.55}, 60))
end

local galaxy = gr.node('galaxy')
for i = 1, count do
    local t = (i - 0.5) / count
    local r = 0.35 + 4.3 * t ^ 0.62
    local spread = (0.06 + 0.24 * (1 - t)) * r
    local angle = 2 * math.pi * (i % arms) / arms + 3.0 * math.log(r + 0.3) + 0.42 * (math.random() + math.random() - 1)
    local place = gr.node('place ' .. i)
    local size = 0.024 + 0.055 * math.random() ^ 3 + 0.022 * t
    place:add_child(hues[math.floor(24 * (1.15 * t + 0.10 * math.random())) % 24])
    place:scale(size, size, size)
    place:rotate('x', 360 * math.random())
    place:rotate('y', 360 * math.random())
    place:translate((r + spread * 0.6 * (math.random() - 0.5)) * math.cos(angle), spread * 0.9 * (math.random() + math.random() - 1),
                    (r + spread * 0.6 * (math.random() - 0.5)) * math.sin(angle))
    galaxy:add_child(place)
end
galaxy:add_child(gr.nh_sphere('heart', {0, 0, 0}, 0.22), gr.material({8, 6.4, 4}, {0, 0, 0}, 1))
galaxy:rotate('z', -14)

gr.background({0.03, 0.03, 0.06}, {0.01, 0.01, 0.03})
gr.render(galaxy, 'tori.png', 1280, 720, {0, 4.6, 7.4}, {0.0, -0.62, -1}, {0, 1, 0}, 38, {0.26, 0.26, 0.31},
          {gr.light({0, 0, 0}, {1.8, 1.45, 1.0}, {0.5, 0, 0.12}, 0.24), gr.light({-9, 12, 10}, {0.66, 0.68, 0.78}, {1, 0, 0}, 1)})
