-- Phong's model: nine balls in front of a point light far behind the camera, so l = v = (0, 0, 1).
-- Right, because: at a ball's centre n.l = r.v = 1, so its value is kd ambient + kd + ks: from left to
-- right kd = 0.2, 0.4, 0.6 with ambient 0.25 gives 0.25, 0.5, 0.75 (64, 128, 191) in the top row, to
-- which the lower rows add ks = 0.2 with exponent 5 and 50: up to 51 steps at the centre, the middle
-- row's highlight the wider.

gr.options{spp = 16}

local root = gr.node('root')
for row = 1, 3 do
    for column = 1, 3 do
        local kd, ks = 0.2 * column, row == 1 and 0 or 0.2
        local ball = gr.nh_sphere('ball ' .. row .. column, {2.2 * (column - 2), 2.2 * (2 - row), 0}, 1)
        root:add_child(ball, gr.material({kd, kd, kd}, {ks, ks, ks}, row == 3 and 50 or 5))
    end
end
gr.render(root, 'shading.png', 96, 96, {0, 0, 4000}, {0, 0, -1}, {0, 1, 0}, 0.1, {0.25, 0.25, 0.25},
          {gr.light({0, 0, 5000}, {1, 1, 1}, {1, 0, 0})})
