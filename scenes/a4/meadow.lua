-- A meadow with a herd: one animal of spheres, placed many times, before a henge of instanced columns.
-- Look at: all animals are alike but for turn and size; the henge closes its circle.

stone = gr.material({0.8, 0.7, 0.7}, {0.0, 0.0, 0.0}, 0)
grass = gr.material({0.1, 0.7, 0.1}, {0.0, 0.0, 0.0}, 0)
hide = gr.material({0.84, 0.6, 0.53}, {0.3, 0.3, 0.3}, 20)
dark = gr.material({0.2, 0.15, 0.15}, {0.3, 0.3, 0.3}, 20)

scene = gr.node('scene')
scene:rotate('X', 18)

plane = gr.nh_box('plane', {-1, -1, -1}, 2)
plane:scale(40, 0.01, 40)
plane:translate(0, -0.01, 0)
plane:set_material(grass)
scene:add_child(plane)

-- Parts: centre, radii, material.
parts = {
    {{0, 1.15, 0}, {0.9, 0.55, 0.5}, hide}, {{0.95, 1.55, 0}, {0.38, 0.3, 0.3}, hide},
    {{1.28, 1.45, 0}, {0.18, 0.16, 0.18}, dark}, {{0.9, 1.85, 0.24}, {0.06, 0.16, 0.06}, dark},
    {{0.9, 1.85, -0.24}, {0.06, 0.16, 0.06}, dark}, {{0.55, 0.45, 0.25}, {0.13, 0.5, 0.13}, hide},
    {{0.55, 0.45, -0.25}, {0.13, 0.5, 0.13}, hide}, {{-0.6, 0.45, 0.25}, {0.13, 0.5, 0.13}, hide},
    {{-0.6, 0.45, -0.25}, {0.13, 0.5, 0.13}, hide}, {{-0.95, 1.1, 0}, {0.06, 0.4, 0.06}, dark}}
animal = gr.node('animal')
for i, p in ipairs(parts) do
    local part = gr.sphere('part ' .. i)
    part:scale(unpack(p[2]))
    part:translate(unpack(p[1]))
    part:set_material(p[3])
    animal:add_child(part)
end

for i, p in ipairs({{-4, 9, 20, 1}, {1.5, 10.5, 160, 0.9}, {5.5, 8, -40, 1.1}, {-8, 6, 90, 1}, {9.5, 5, 210, 0.9},
                    {3, 4.5, -100, 0.8}, {-2, 5, 60, 0.6}}) do
    local copy = gr.node('animal ' .. i)
    copy:add_child(animal)
    copy:scale(p[4], p[4], p[4])
    copy:rotate('Y', p[3])
    copy:translate(p[1], 0, p[2])
    scene:add_child(copy)
end

column = gr.cylinder('column')
column:set_material(stone)
column:scale(0.45, 2, 0.45)
column:translate(0, 2, 0)
lintel = gr.cube('lintel')
lintel:set_material(stone)
lintel:translate(-0.5, 0, -0.5)
lintel:scale(4.6, 0.6, 0.8)
lintel:translate(0, 4.3, 0)
arc = gr.node('arc')
arc:add_child(lintel)
for _, side in ipairs({-1, 1}) do
    local post = gr.node('post ' .. side)
    post:add_child(column)
    post:translate(side * 1.5, 0, 0)
    arc:add_child(post)
end
arc:translate(0, 0, -9)
for i = 1, 12 do
    local place = gr.node('arc ' .. i)
    place:rotate('Y', i * 30)
    place:add_child(arc)
    place:translate(0, 0, -4)
    scene:add_child(place)
end

gr.render(scene, 'meadow.png', 320, 200, {0, 2, 30}, {0, -0.06, -1}, {0, 1, 0}, 36, {0.4, 0.4, 0.4},
          {gr.light({200, 202, 430}, {0.8, 0.8, 0.8}, {1, 0, 0})})
