-- Spheres and boxes under transforms, two images from one script, the second from above; they go to a
-- subfolder that is made. Lights fall off with the distance.

a = gr.material({0.8, 0.3, 0.3}, {0.6, 0.6, 0.6}, 50)
b = gr.material({0.3, 0.8, 0.4}, {0.2, 0.2, 0.2}, 10)
c = gr.material({0.35, 0.35, 0.8}, {0.4, 0.4, 0.4}, 30)

root = gr.node('root')
tower = gr.node('tower')
for i = 0, 4 do
    local step = gr.cube('step ' .. i)
    step:translate(-0.5, 0, -0.5)
    step:scale(3 - 0.5 * i, 0.5, 3 - 0.5 * i)
    step:rotate('y', 12 * i)
    step:translate(0, 0.5 * i, 0)
    step:set_material(i % 2 == 0 and c or b)
    tower:add_child(step)
end
top = gr.sphere('top')
top:scale(0.5, 0.5, 0.5)
top:translate(0, 3, 0)
top:set_material(a)
tower:add_child(top)
root:add_child(tower)

for i = 0, 5 do
    local ball = gr.sphere('ball ' .. i)
    ball:scale(0.4, 0.4, 0.4)
    ball:translate(2.6, 0.4, 0)
    ball:rotate('y', 60 * i + 20)
    ball:set_material(a)
    root:add_child(ball)
end
base = gr.cube('base')
base:translate(-0.5, -1, -0.5)
base:scale(9, 0.3, 9)
base:set_material(b)
root:add_child(base)

lamp = gr.light({4, 7, 6}, {9, 9, 8}, {1, 0.2, 0.08})
gr.render(root, 'a4_images/simple_1.png', 240, 180, {0, 4, 9}, {0, -0.35, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.2}, {lamp})
gr.render(root, 'a4_images/simple_2.png', 240, 180, {0, 11, 0.01}, {0, -1, 0}, {0, 0, -1}, 40, {0.2, 0.2, 0.2}, {lamp})
