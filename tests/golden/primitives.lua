-- All ten solids, seen from far away with a narrow field of view, lit from the camera by a point light.
-- Right, because: every outline is that of the definition: in the upper row the ball is round and 2
-- high; the cube stands on the ball's centre line and is half as high; the cylinder is as wide as high;
-- the cone stands on its apex; the ring's hole is 1.5 wide and its tube 0.5. The lower row holds the
-- nh_ forms of the same measures, so each stands below its twin with the same shading.

gr.options{spp = 16}

local m = gr.material({0.6, 0.6, 0.6}, {0.3, 0.3, 0.3}, 20)
local root = gr.node('root')
local x = {-5, -2.5, 0, 2.5, 5.2}

local upper = {gr.sphere('ball'), gr.cube('cube'), gr.cylinder('cylinder'), gr.cone('cone'), gr.torus('ring')}
for i, solid in ipairs(upper) do
    solid:translate(x[i], 1.3, 0)
    root:add_child(solid, m)
end

local y = -1.4
root:add_child(gr.nh_sphere('nh ball', {x[1], y, 0}, 1), m)
root:add_child(gr.nh_box('nh box', {x[2], y, 0}, 1), m)
root:add_child(gr.nh_cylinder('nh cylinder', {x[3], y - 1, 0}, 2, 1), m)
root:add_child(gr.nh_cone('nh cone', {x[4], y, 0}, 1, 1), m)
root:add_child(gr.nh_torus('nh ring', {x[5], y, 0}, 1, 0.25), m)

gr.render(root, 'primitives.png', 160, 64, {0, 6, 60}, {0, -0.1, -1}, {0, 1, 0}, 5.6, {0.3, 0.3, 0.3},
          {gr.light({10, 30, 60}, {0.8, 0.8, 0.8}, {1, 0, 0})})
