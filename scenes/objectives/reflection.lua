-- Reflection: a sphere with nine smaller ones on it, and on each of them again, over a polished floor.
-- Look at: mirrors in mirrors down to a few pixels, the evening sky bent into every one of them.
-- Without: the same balls, dull.   ./Project scenes/objectives/reflection.lua -D without=true

local without = gr.param('without', false, {doc = 'no mirrors'})
local levels = gr.param('levels', 4, {min = 0, max = 6, doc = 'generations of balls'})

local root = gr.node('root')
local looks = {
    gr.material({0.10, 0.09, 0.10}, {0.6, 0.6, 0.6}, 300), gr.material({0.95, 0.62, 0.18}, {0.6, 0.5, 0.3}, 200),
    gr.material({0.80, 0.22, 0.26}, {0.6, 0.6, 0.6}, 200), gr.material({0.85, 0.55, 0.20}, {0.6, 0.6, 0.6}, 200),
    gr.material({0.90, 0.80, 0.60}, {0.6, 0.6, 0.6}, 200),
}

-- Each generation is one node of balls below the last: six about the middle, three above (E. Haines, A Proposal for
-- Standard Graphics Environments, 1987).
local function flake(level)
    local node = gr.node('flake ' .. level)
    local ball = gr.sphere('ball ' .. level)
    if not without then ball:set_reflection(level == levels and 0.12 or 0.35) end
    node:add_child(ball, looks[(levels - level) % #looks + 1])
    if level > 0 then
        local below = flake(level - 1)
        for k = 0, 8 do
            local place = gr.node('place ' .. level .. ' ' .. k)
            place:scale(1 / 3, 1 / 3, 1 / 3)
            place:translate(0, 4 / 3, 0)
            place:rotate('z', k < 6 and -90 or -36)
            place:rotate('y', k < 6 and 60 * k or 120 * k + 30)
            place:add_child(below)
            node:add_child(place)
        end
    end
    return node
end

local thing = flake(levels)
thing:rotate('x', 12)
thing:rotate('z', -14)
thing:translate(0, 1.70, 0)
root:add_child(thing)

local floor = gr.mesh('floor', 'ground.obj')
floor:scale(160, 160, 160)
floor:rotate('y', 25)
if not without then floor:set_reflection(0.70) end
root:add_child(floor, nil, gr.texture('planks.png', {0.2, 0.2, 0.2}, 60))

gr.background('sky.png')
gr.render(root, 'reflection.png', 1280, 720, {0.3, 2.4, 6.2}, {-0.05, -0.11, -1}, {0, 1, 0}, 37, {0.36, 0.37, 0.42},
          {gr.light({9, 7, -7}, {0.9, 0.78, 0.6}, {1, 0, 0}, 0.5), gr.light({-6, 8, 8}, {0.40, 0.40, 0.44}, {1, 0, 0}, 0.8)})
