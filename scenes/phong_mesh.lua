-- Normals of meshes: one ball of 80 triangles, three times. From left to right: flat faces (smooth =
-- false), normals computed from the faces (the default), the normals that the file brings.
-- Look at: the outlines are the same 80 triangles; no dark band where a smooth ball turns away from
-- the light; faint edges on the middle ball, where faces that meet at a corner lie more than the
-- default 40 degrees apart; behind, a blob of 20,480 triangles, and a gem whose edges stay edges.

local pearl = gr.material({0.74, 0.72, 0.70}, {0.45, 0.45, 0.45}, 40)
local jade = gr.material({0.25, 0.52, 0.40}, {0.55, 0.55, 0.55}, 70)
local rose = gr.material({0.75, 0.30, 0.36}, {0.35, 0.35, 0.35}, 40)
local slab = gr.material({0.66, 0.65, 0.64}, {0.03, 0.03, 0.03}, 10)

local root = gr.node('root')
root:add_child(gr.nh_box('slab', {-40, -1, -40}, {80, 1, 80}), slab)

local function put(node, material, size, x, y, z)
    node:scale(size, size, size)
    node:translate(x, y, z)
    root:add_child(node, material)
end

put(gr.mesh('flat', 'ball80_plain.obj', {smooth = false}), pearl, 1, -2.4, 1, 1)
put(gr.mesh('computed', 'ball80_plain.obj'), pearl, 1, 0, 1, 1)
put(gr.mesh('given', 'ball80.obj'), pearl, 1, 2.4, 1, 1)

local blob = gr.mesh('blob', 'blob.obj')
blob:rotate('y', 130)
put(blob, jade, 1.45, -1.6, 1.45, -2.6)

local gem = gr.mesh('gem', 'dodecahedron.obj')
gem:rotate('x', 31.717)
put(gem, rose, 1.3, 2.2, 1.033, -2.4)

gr.background({0.76, 0.78, 0.82}, {0.34, 0.44, 0.62})
gr.render(root, 'phong_mesh.png', 800, 450, {0, 3.0, 8.6}, {0, -0.24, -1}, {0, 1, 0}, 36,
          {0.20, 0.20, 0.24}, {gr.light({-14, 17, 3}, {0.95, 0.90, 0.80}, {1, 0, 0}, 1.0)})
