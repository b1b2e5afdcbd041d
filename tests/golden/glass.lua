-- A glass ball with Fresnel's law, one without, a pool of water with a stick, and a prism's total
-- reflection, before checks.
-- Right, because: both balls show the checks upside down and only the left one has a bright rim that
-- mirrors the sky; the pool shows the lines of the wall and of the floor shifted against those beside
-- it, and the stick goes on in it; the block of glass on the right mirrors the checks in its side
-- without any loss, since inside it the ray meets the side beyond the critical angle of 41.8 degrees;
-- all shadows of glass are grey, none black.

gr.options{spp = 16}

local clear = gr.material({0.02, 0.02, 0.02}, {0, 0, 0}, 1)
local root = gr.node('root')
root:add_child(gr.nh_box('floor', {-8, -0.2, -8}, {16, 0.2, 16}), nil, gr.texture('checker.png', {0, 0, 0}, 1))
root:add_child(gr.nh_box('wall', {-8, 0, -3.2}, {16, 6, 0.2}), nil, gr.texture('uv_grid.png', {0, 0, 0}, 1))

local function glass(node, index, fresnel)
    node:set_refraction(index, 0)
    node:set_fresnel(fresnel)
    root:add_child(node, clear)
end
glass(gr.nh_sphere('real', {-2.9, 0.8, 0}, 0.8), 1.5, true)
glass(gr.nh_sphere('plain', {-1.1, 0.8, 0}, 0.8), 1.5, false)
glass(gr.nh_box('pool', {0, 0, -0.7}, {1.6, 1.2, 1.4}), 1.33, true)
glass(gr.nh_box('block', {2.1, 0, -0.7}, {1.3, 1.5, 1.4}), 1.5, false)

local stick = gr.nh_cylinder('stick', {0, 0, 0}, 2.4, 0.07)
stick:rotate('z', -28)
stick:translate(0.25, 0.1, 0.1)
root:add_child(stick, gr.material({0.8, 0.2, 0.1}, {0, 0, 0}, 1))

gr.background({0.8, 0.85, 0.9})
gr.render(root, 'glass.png', 160, 72, {-0.1, 2.2, 8}, {0, -0.16, -1}, {0, 1, 0}, 27, {0.5, 0.5, 0.5},
          {gr.light({-3, 7, 6}, {0.55, 0.55, 0.55}, {1, 0, 0})})
