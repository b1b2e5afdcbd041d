-- Transforms of all kinds, under one light from the upper left front.
-- Right, because: upper row: a ball scaled to an egg, twice as high as wide and turned by 30 degrees to
-- the left; the same egg mirrored by scale(-1, 1, 1), so turned to the right, yet lit from the left as
-- its neighbour; a cube sheared to a rhomb. Lower row: a hierarchy of three joints, each 30 degrees
-- further, so that the last stick is level; a cone upside down by a negative scale; a torus of radii
-- 0.8 and 0.2 scaled to half its height, an oval ring with thin top and bottom.

gr.options{spp = 16}

local a = gr.material({0.70, 0.45, 0.25}, {0.3, 0.3, 0.3}, 20)
local b = gr.material({0.30, 0.50, 0.65}, {0.3, 0.3, 0.3}, 20)
local root = gr.node('root')

local function egg(name)
    local ball = gr.sphere(name)
    ball:scale(0.5, 1, 0.5)
    ball:rotate('z', 30)
    return ball
end
local first = egg('egg')
first:translate(-2.6, 1.2, 0)
root:add_child(first, a)
local mirrored = egg('mirrored egg')
mirrored:scale(-1, 1, 1)
mirrored:translate(-0.4, 1.2, 0)
root:add_child(mirrored, a)

local cube = gr.cube('sheared')
cube:translate(-0.5, -0.5, -0.5)
cube:rotate('z', 45)
cube:scale(1.6, 0.8, 1)
cube:rotate('y', 25)
cube:translate(2.4, 1.2, 0)
root:add_child(cube, a)

local arm = nil
for i = 3, 1, -1 do
    local joint = gr.joint('joint ' .. i, {-90, 0, 90}, {0, 0, 0})
    local stick = gr.nh_cylinder('stick ' .. i, {0, 0, 0}, 0.8, 0.12)
    joint:add_child(stick, b)
    if arm then
        arm:rotate('z', -30)
        arm:translate(0, 0.8, 0)
        joint:add_child(arm)
    end
    arm = joint
end
arm:rotate('z', -30)
arm:translate(-3.2, -1.9, 0)
root:add_child(arm)

local cone = gr.cone('cone')
cone:scale(0.7, -1.5, 0.7)
cone:translate(0.1, -0.4, 0)
root:add_child(cone, b)

local ring = gr.torus('ring', 0.8, 0.2)
ring:scale(1, 0.5, 1)
ring:translate(2.4, -1.2, 0)
root:add_child(ring, b)

gr.render(root, 'transforms.png', 144, 96, {0, 0, 30}, {0, 0, -1}, {0, 1, 0}, 9.5, {0.3, 0.3, 0.3},
          {gr.light({-20, 20, 30}, {0.75, 0.75, 0.75}, {1, 0, 0})})
