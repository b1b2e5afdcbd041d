-- Half a second of rendering, whatever that is on a machine: the noise differs from run to run.
-- Right, because: seen straight from above, the screen's edge, 4 above the floor, halves the distance to a
-- light of radius 1 at 8, so the penumbra reaches from x = -1 to 1, a quarter of the picture's 8. The ring,
-- 1 above the floor, has penumbrae of about 2/7, 5 pixels at both edges of its shadow, which lies farther
-- from the light than the ring itself.

gr.options{time = 0.5, bits = 16}

local root = gr.node('root')
root:add_child(gr.nh_box('floor', {-50, -1, -50}, {100, 1, 100}), gr.material({0.8, 0.75, 0.7}, {0, 0, 0}, 1))
root:add_child(gr.nh_box('screen', {0, 4, -50}, {60, 0.001, 100}), gr.material({0, 0, 0}, {0, 0, 0}, 1))
local ring = gr.torus('ring', 0.9, 0.15)
ring:rotate('x', 90)
ring:translate(-2.4, 1, 0)
root:add_child(ring, gr.material({0.2, 0.4, 0.7}, {0.3, 0.3, 0.3}, 20))

gr.render(root, 'timed.png', 128, 64, {0, 3.9, 0}, {0, -1, 0}, {0, 0, -1}, 54.34, {0.1, 0.1, 0.1},
          {gr.light({0, 8, 0}, {1, 1, 1}, {1, 0, 0}, 1)})
