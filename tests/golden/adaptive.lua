-- Towards an error instead of a number of samples: a textured floor in a mirror, the wide shadow of a
-- ball, and a lens.
-- Right, because: the error that the file states is below 0.01; the floor's lines go on in the mirror
-- behind its lower edge; the shadow is sharp where the ball stands and wide at its far end; the near edge of
-- the floor is out of focus. Where samples go depends on what was seen, and must not depend on threads.

gr.options{error = 0.01}

local root = gr.node('root')
root:add_child(gr.nh_box('floor', {-4, -0.2, -4}, {8, 0.2, 8}), nil, gr.texture('checker.png', {0, 0, 0}, 1))
local mirror = gr.nh_box('mirror', {-3, 0, -2.2}, {6, 2.5, 0.2})
mirror:set_reflection(0.1)
root:add_child(mirror, gr.material({0.3, 0.3, 0.35}, {0, 0, 0}, 1))
root:add_child(gr.nh_sphere('ball', {0.6, 0.7, 0}, 0.7), gr.material({0.75, 0.35, 0.15}, {0.4, 0.4, 0.4}, 30))

gr.background({0.5, 0.6, 0.7}, {0.8, 0.85, 0.9})
gr.render(root, 'adaptive.png', 120, 80, {-0.4, 1.9, 6.5}, {0.06, -0.2, -1}, {0, 1, 0}, 33, {0.3, 0.3, 0.3},
          {gr.light({-4, 5, 4}, {0.7, 0.7, 0.7}, {1, 0, 0}, 0.8)}, gr.focal({0.6, 0.7, 0.7}, 0.05, 0.12))
