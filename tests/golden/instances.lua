-- One gem in nine places, through three groups of three, each place with a material of its own edge.
-- Right, because: the rows are red, green and blue, since the appearance of an edge overrides the
-- gem's own grey; the grey one in the corner hangs there without; all have the same faces, columns
-- differ in turn only, and the last row is mirrored.

gr.options{spp = 16}

local colours = {{0.8, 0.2, 0.2}, {0.2, 0.7, 0.3}, {0.25, 0.35, 0.8}}
local gem = gr.mesh('gem', 'dodecahedron.obj')
gem:set_material(gr.material({0.5, 0.5, 0.5}, {0.3, 0.3, 0.3}, 20))

local root = gr.node('root')
for row = 1, 3 do
    local material = gr.material(colours[row], {0.3, 0.3, 0.3}, 20)
    local line = gr.node('line ' .. row)
    for column = 1, 3 do
        local place = gr.node('place ' .. row .. column)
        place:rotate('y', 24 * column)
        place:translate(2.2 * (column - 2), 0, 0)
        place:add_child(gem, material)
        line:add_child(place)
    end
    if row == 3 then line:scale(-1, 1, 1) end
    line:translate(0, 2.2 * (2 - row), 0)
    root:add_child(line)
end
local corner = gr.node('corner')
corner:scale(0.4, 0.4, 0.4)
corner:translate(-3.4, -2.9, 0)
corner:add_child(gem)
root:add_child(corner)

gr.render(root, 'instances.png', 100, 90, {0, 0, 30}, {0, 0, -1}, {0, 1, 0}, 13, {0.3, 0.3, 0.3},
          {gr.light({-20, 20, 30}, {0.7, 0.7, 0.7}, {1, 0, 0})})
