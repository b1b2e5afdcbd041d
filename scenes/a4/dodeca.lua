-- Dodecahedra: the mesh by a relative path, both orders of the arguments, and as a table of pentagons.
-- Look at: twelve flat faces on each, with hard edges.

red = gr.material({0.8, 0.2, 0.15}, {0.4, 0.4, 0.4}, 25)
gold = gr.material({0.9, 0.8, 0.4}, {0.8, 0.8, 0.4}, 25)
blue = gr.material({0.3, 0.4, 0.8}, {0.5, 0.5, 0.5}, 25)
grey = gr.material({0.6, 0.6, 0.6}, {0, 0, 0}, 0)

scene = gr.node('scene')

one = gr.mesh('one', '../a4/dodeca.obj')
one:set_material(red)
two = gr.mesh('dodeca.obj', 'two')
two:set_material(gold)

g = (1 + math.sqrt(5)) / 2
h = 1 / g
three = gr.mesh('three',
    {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}, {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1},
     {0, h, g}, {0, h, -g}, {0, -h, g}, {0, -h, -g}, {h, g, 0}, {h, -g, 0}, {-h, g, 0}, {-h, -g, 0},
     {g, 0, h}, {g, 0, -h}, {-g, 0, h}, {-g, 0, -h}},
    {{0, 16, 2, 10, 8}, {0, 8, 4, 14, 12}, {16, 17, 1, 12, 0}, {1, 9, 11, 3, 17}, {1, 12, 14, 5, 9},
     {2, 13, 15, 6, 10}, {13, 3, 17, 16, 2}, {3, 11, 7, 15, 13}, {4, 8, 10, 6, 18}, {14, 5, 19, 18, 4},
     {5, 19, 7, 11, 9}, {15, 7, 19, 18, 6}})
three:scale(1 / math.sqrt(3), 1 / math.sqrt(3), 1 / math.sqrt(3))
three:set_material(blue)

for i, solid in ipairs({one, two, three}) do
    solid:rotate('x', 31.717)
    solid:rotate('y', 25 * i)
    solid:translate(2.2 * (i - 2), 0.7947, 0)
    scene:add_child(solid)
end

floor = gr.nh_box('floor', {-20, -40, -20}, 40)
floor:set_material(grey)
scene:add_child(floor)

gr.render(scene, 'dodeca.png', 320, 180, {0, 2.5, 6}, {0, -0.33, -1}, {0, 1, 0}, 40, {0.25, 0.25, 0.25},
          {gr.light({-5, 8, 6}, {0.75, 0.75, 0.75}, {1, 0, 0})})
