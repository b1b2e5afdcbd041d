-- A Menger sponge of 8,000 cubes: three nodes, each with twenty places for the one below.
-- Look at: straight tunnels all the way through, no cracks between the cubes.

stone = gr.material({0.75, 0.65, 0.5}, {0.2, 0.2, 0.2}, 15)
grey = gr.material({0.45, 0.45, 0.5}, {0, 0, 0}, 0)

function sponge(level)
    if level == 0 then
        local cube = gr.cube('cube')
        cube:set_material(stone)
        cube:translate(-0.5, -0.5, -0.5)
        return cube
    end
    local below, node = sponge(level - 1), gr.node('level ' .. level)
    for x = -1, 1 do
        for y = -1, 1 do
            for z = -1, 1 do
                if math.abs(x) + math.abs(y) + math.abs(z) > 1 then
                    local place = gr.node('place ' .. level .. ' ' .. x .. ' ' .. y .. ' ' .. z)
                    place:add_child(below)
                    place:translate(x, y, z)
                    place:scale(1 / 3, 1 / 3, 1 / 3)
                    node:add_child(place)
                end
            end
        end
    end
    return node
end

root = gr.node('root')
thing = sponge(3)
thing:rotate('y', 32)
thing:translate(0, 0.5, 0)
root:add_child(thing)
floor = gr.nh_box('floor', {-10, -20, -10}, 20)
floor:set_material(grey)
root:add_child(floor)

gr.render(root, 'sponge.png', 320, 240, {0, 1.5, 2.4}, {0, -0.44, -1}, {0, 1, 0}, 40, {0.25, 0.25, 0.28},
          {gr.light({-2, 5, 3}, {0.75, 0.72, 0.65}, {1, 0, 0})})
