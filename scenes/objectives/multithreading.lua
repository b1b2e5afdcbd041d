-- Multithreading: a heap of glass and mirror marbles, where neighbouring pixels cost very different work.
-- Look at: nothing of the tiles that the threads took in turn; the file has the same bytes for any number of
-- threads. Without: one thread.   ./Project scenes/objectives/multithreading.lua -j 1

local count = gr.param('count', 260, {min = 10, max = 2000, doc = 'marbles'})

local root = gr.node('root')
root:add_child(gr.nh_box('floor', {-30, -1, -30}, {60, 1, 60}), nil, gr.texture('plaster.png', {0, 0, 0}, 1))

local tints = {{0.10, 0.42, 0.55}, {0.62, 0.20, 0.16}, {0.70, 0.50, 0.14}, {0.22, 0.46, 0.22}, {0.42, 0.24, 0.54}}

-- Marbles are dropped one by one onto the lowest of a few places where they touch nothing.
local placed = {}
local function drop(r)
    local best
    for _ = 1, 24 do
        local a, d = 2 * math.pi * math.random(), 2.1 * math.sqrt(math.random())
        local x, z, y = d * math.cos(a), d * math.sin(a), r
        for _, p in ipairs(placed) do
            local reach, gap = r + p.r, (x - p.x) ^ 2 + (z - p.z) ^ 2
            if gap < reach * reach then y = math.max(y, p.y + math.sqrt(reach * reach - gap)) end
        end
        local score = y + 0.22 * d * d
        if not best or score < best.score then best = {x = x, y = y, z = z, r = r, score = score} end
    end
    placed[#placed + 1] = best
    return best
end

for k = 1, count do
    local p = drop(0.13 + 0.13 * math.random() ^ 2)
    local marble = gr.nh_sphere('marble ' .. k, {p.x, p.y, p.z}, p.r)
    local tint = tints[math.random(#tints)]
    if k % 4 == 0 then
        marble:set_reflection(0.25)
        root:add_child(marble, gr.material({0.5 * tint[1], 0.5 * tint[2], 0.5 * tint[3]}, {0.5, 0.5, 0.5}, 200))
    elseif k % 4 == 1 then
        root:add_child(marble, gr.material(tint, {0.5, 0.5, 0.5}, 120))
    else
        marble:set_refraction(1.5, 0.12)
        marble:set_fresnel(true)
        root:add_child(marble, gr.material(tint, {0.6, 0.6, 0.6}, 400))
    end
end

gr.background('sky.png')
gr.render(root, 'multithreading.png', 1280, 720, {0, 2.2, 5.2}, {0, -0.34, -1}, {0, 1, 0}, 36, {0.30, 0.30, 0.32},
          {gr.light({-4, 7, 4}, {0.66, 0.62, 0.54}, {1, 0, 0}, 0.6)})
