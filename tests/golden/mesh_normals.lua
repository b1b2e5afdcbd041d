-- One ball of 80 triangles: flat, with computed normals, with the normals of its file; and a concave
-- polygon from tables.
-- Right, because: all outlines are the same polygon; the flat ball shows faces of one colour each, the
-- other two do not; these two agree but for faint edges in the computed one, where faces that meet at a
-- corner lie more than 40 degrees apart and are not averaged; the arrow has its notch, which a fan from
-- a corner beside it would fill.

gr.options{spp = 16}

local m = gr.material({0.6, 0.6, 0.6}, {0.4, 0.4, 0.4}, 30)
local root = gr.node('root')
local balls = {gr.mesh('flat', 'ball80_plain.obj', {smooth = false}), gr.mesh('computed', 'ball80_plain.obj'),
               gr.mesh('given', 'ball80.obj')}
for i, ball in ipairs(balls) do
    ball:translate(2.2 * (i - 2) - 1.1, 0, 0)
    root:add_child(ball, m)
end
local arrow = gr.mesh('arrow', {{0, -1, 0}, {0.8, 1, 0}, {0, 0.4, 0}, {-0.8, 1, 0}}, {{0, 1, 2, 3}})
arrow:translate(3.2, 0, 0)
root:add_child(arrow, gr.material({0.7, 0.4, 0.2}, {0, 0, 0}, 1))

gr.render(root, 'mesh_normals.png', 160, 48, {0, 0, 30}, {0, 0, -1}, {0, 1, 0}, 5.1, {0.2, 0.2, 0.2},
          {gr.light({-25, 25, 30}, {0.8, 0.8, 0.8}, {1, 0, 0})})
