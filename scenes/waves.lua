-- An animation that closes: waves run in rings over a field of columns, one period in 48 frames.
--     ./Project scenes/waves.lua --frames 1-48 -o waves_##.png
-- Look at: frame 48 is one step before frame 1; the pearl keeps its place on top of the middle.

local half = gr.param('half', 24, {min = 2, max = 60, doc = 'columns from the middle to each side'})

-- gr.time is 0 at the first frame and 1 at the last; one step less, so that the last frame is not the first again.
local phase = 2 * math.pi * (gr.frame - 1) / gr.param('period', 48, {min = 1, doc = 'frames to a period'})

local function height(r) return 1.2 + 0.62 * math.sin(1.05 * r - phase) * math.exp(-r * 0.055) end

local looks = {}
for k = 0, 31 do
    local t = k / 31
    looks[k] = gr.material({0.10 + 0.80 * t ^ 1.5, 0.24 + 0.55 * t, 0.44 + 0.30 * t ^ 2}, {0.30, 0.30, 0.30}, 50)
end

local root = gr.node('root')
local column = gr.cylinder('column')
for i = -half, half do
    for j = -half, half do
        local x, z = i + 0.5 * (j % 2), j * math.sqrt(3) / 2
        local r = math.sqrt(x * x + z * z)
        if r < half * 0.86 then
            local h = height(r)
            local place = gr.node('place ' .. i .. ' ' .. j)
            place:add_child(column, looks[math.floor(math.min(31, math.max(0, (h - 0.55) / 1.3 * 31)))])
            place:scale(0.47, h, 0.47)
            place:translate(x, h, z)
            root:add_child(place)
        end
    end
end

local pearl = gr.nh_sphere('pearl', {0, 2 * height(0) + 1.0, 0}, 1.0)
pearl:set_reflection(0.35)
root:add_child(pearl, gr.material({0.80, 0.74, 0.70}, {0.6, 0.6, 0.6}, 200))
root:add_child(gr.nh_box('floor', {-300, -1, -300}, {600, 1, 600}), gr.material({0.16, 0.20, 0.28}, {0.05, 0.05, 0.05}, 10))

gr.background({0.42, 0.44, 0.52}, {0.20, 0.26, 0.40})
gr.render(root, 'waves.png', 1280, 720, {0, 15, 23}, {0, -0.66, -1}, {0, 1, 0}, 36, {0.22, 0.23, 0.28},
          {gr.light({-14, 16, -4}, {0.95, 0.80, 0.60}, {1, 0, 0}, 1.6), gr.light({16, 14, 16}, {0.26, 0.30, 0.40}, {1, 0, 0}, 2)})
