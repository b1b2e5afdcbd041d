-- A Menger sponge of the fourth generation, 160,000 cubes, with a light in its heart.
-- Look at: straight tunnels all the way through, no cracks between cubes, the glow that falls off from tunnel to tunnel.
-- Four nodes hold it, each with twenty places for the one below. -D levels=2 is a coarser one.

local levels = gr.param('levels', 4, {min = 0, max = 5, doc = 'generations'})

local cube = gr.cube('cube')
cube:translate(-0.5, -0.5, -0.5)
local stone = gr.material({0.70, 0.66, 0.60}, {0.08, 0.08, 0.08}, 14)

local function sponge(level)
    if level == 0 then return cube end
    local below, node = sponge(level - 1), gr.node('level ' .. level)
    for x = -1, 1 do
        for y = -1, 1 do
            for z = -1, 1 do
                if math.abs(x) + math.abs(y) + math.abs(z) > 1 then
                    local place = gr.node('place ' .. level .. ' ' .. x .. y .. z)
                    place:add_child(below, level == 1 and stone or nil)
                    place:translate(x, y, z)
                    place:scale(1 / 3, 1 / 3, 1 / 3)
                    node:add_child(place)
                end
            end
        end
    end
    return node
end

local root = gr.node('root')
local thing = gr.node('thing')
thing:add_child(sponge(levels), levels == 0 and stone or nil)
-- It stands on a corner: a third of a turn about its diagonal looks the same.
thing:rotate('y', 45)
thing:rotate('x', math.deg(math.atan(math.sqrt(2))))
thing:rotate('y', 17)
thing:translate(0, 0.868, 0)
root:add_child(thing)

local floor = gr.nh_box('floor', {-60, -1, -60}, {120, 1, 120})
floor:set_reflection(0.72)
root:add_child(floor, gr.material({0.30, 0.31, 0.36}, {0.1, 0.1, 0.1}, 20))

gr.background({0.20, 0.20, 0.26}, {0.05, 0.07, 0.12})
gr.render(root, 'menger.png', 1280, 720, {0, 1.24, 3.0}, {0, -0.13, -1}, {0, 1, 0}, 37, {0.16, 0.16, 0.20},
          {gr.light({0, 0.868, 0}, {1.9, 1.05, 0.42}, {0.3, 0, 1.2}, 0.10),
           gr.light({-4, 5, 4}, {0.66, 0.72, 0.86}, {1, 0, 0}, 0.8),
           gr.light({4, 2.5, 1.5}, {0.46, 0.34, 0.40}, {1, 0, 0}, 0.6)})
