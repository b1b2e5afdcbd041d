-- A mesh given by tables: a helper module reads house.obj with io.lines. The extra true and 'smooth'
-- at the ends of calls never meant anything: one warning for each place.
-- Look at: flat walls and sharp ridges; every house is the same mesh in another material.

readobj = require('readobj')
vertices, faces = readobj.read('house.obj')

house = gr.mesh('house', vertices, faces)

walls = {gr.material({0.85, 0.8, 0.7}, {0.1, 0.1, 0.1}, 10), gr.material({0.8, 0.45, 0.35}, {0.1, 0.1, 0.1}, 10),
         gr.material({0.5, 0.6, 0.75}, {0.1, 0.1, 0.1}, 10)}
grass = gr.material({0.35, 0.55, 0.25}, {0, 0, 0}, 0, 'smooth')
leaf = gr.material({0.15, 0.4, 0.15}, {0.1, 0.1, 0.1}, 5)

scene = gr.node('scene', true)
ground = gr.nh_box('ground', {-60, -120, -60}, 120)
ground:set_material(grass)
scene:add_child(ground)

crown = gr.nh_sphere('crown', {0, 1.1, 0}, 0.8)
n = 0
for row = 0, 2 do
    for column = -2, 2 do
        n = n + 1
        place = gr.node('place ' .. n)
        place:rotate('y', 37 * n)
        place:translate(4.2 * column + (row % 2) * 1.5, 0, -5 * row)
        if n % 4 == 0 then
            place:add_child(crown, leaf)
        else
            place:add_child(house, walls[n % 3 + 1])
        end
        scene:add_child(place)
    end
end

sun = gr.light({-40, 60, 50}, {0.8, 0.78, 0.7}, {1, 0, 0})
gr.render(scene, 'village.png', 320, 200, {0, 6, 15}, {0, -0.34, -1}, {0, 1, 0}, 36, {0.3, 0.3, 0.35}, {sun})
