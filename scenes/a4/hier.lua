-- A puppet of joints. Two of its initial angles lie outside of their ranges: a warning each, clamped.
-- Look at: the raised arm bends at the elbow, the head nods; parts stay together at the joints.

skin = gr.material({0.9, 0.7, 0.55}, {0.1, 0.1, 0.1}, 10)
shirt = gr.material({0.7, 0.1, 0.1}, {0.5, 0.7, 0.5}, 25)
jeans = gr.material({0.15, 0.2, 0.5}, {0.1, 0.1, 0.1}, 10)
grass = gr.material({0.1, 0.7, 0.1}, {0.0, 0.0, 0.0}, 0)

function limb(name, length, width, material)
    local part = gr.sphere(name)
    part:set_material(material)
    part:scale(width, length / 2, width)
    part:translate(0, -length / 2, 0)
    return part
end

function arm(side, shoulder, elbow)
    local joint = gr.joint(side .. ' shoulder', {-180, shoulder, 180}, {0, 0, 0})
    joint:add_child(limb(side .. ' upper arm', 1.2, 0.22, shirt))
    local lower = gr.joint(side .. ' elbow', {-140, elbow, 0}, {0, 0, 0})
    lower:add_child(limb(side .. ' lower arm', 1.1, 0.18, skin))
    lower:translate(0, -1.1, 0)
    joint:add_child(lower)
    return joint
end

function leg(side, hip, knee)
    local joint = gr.joint(side .. ' hip', {-90, hip, 60}, {0, 0, 0})
    joint:add_child(limb(side .. ' thigh', 1.5, 0.32, jeans))
    local lower = gr.joint(side .. ' knee', {0, knee, 130}, {0, 0, 0})
    lower:add_child(limb(side .. ' shin', 1.5, 0.24, jeans))
    local foot = gr.sphere(side .. ' foot')
    foot:scale(0.2, 0.15, 0.4)
    foot:translate(0, -1.5, 0.2)
    foot:set_material(skin)
    lower:add_child(foot)
    lower:translate(0, -1.4, 0)
    joint:add_child(lower)
    return joint
end

puppet = gr.node('puppet')

torso = gr.sphere('torso')
torso:set_material(shirt)
torso:scale(0.75, 1.15, 0.45)
puppet:add_child(torso)

neck = gr.joint('neck', {-20, 12, 20}, {-70, 25, 70})
head = gr.sphere('head')
head:set_material(skin)
head:scale(0.5, 0.6, 0.5)
head:translate(0, 0.75, 0)
neck:add_child(head)
nose = gr.nh_sphere('nose', {0, 0.7, 0.5}, 0.1)
nose:set_material(skin)
neck:add_child(nose)
neck:translate(0, 0.95, 0)
puppet:add_child(neck)

left = arm('left', -20, -30)
left:rotate('z', 14)
left:translate(0.72, 0.75, 0)
puppet:add_child(left)
right = arm('right', -130, -200) -- the elbow ends at -140
right:rotate('z', -10)
right:translate(-0.72, 0.75, 0)
puppet:add_child(right)

l = leg('left', -25, 30)
l:translate(0.35, -0.9, 0)
puppet:add_child(l)
r = leg('right', 10, -15) -- the knee ends at 0
r:translate(-0.35, -0.9, 0)
puppet:add_child(r)

puppet:rotate('Y', -25)
puppet:translate(0, 4, 0)

scene = gr.node('scene')
scene:add_child(puppet)
floor = gr.nh_box('floor', {-50, -1, -50}, 100)
floor:scale(1, 0.01, 1)
floor:translate(0, -0.35, 0)
floor:set_material(grass)
scene:add_child(floor)

white = gr.light({-8, 12, 10}, {0.8, 0.8, 0.8}, {1, 0, 0})
blue = gr.light({8, 5, 6}, {0.15, 0.15, 0.3}, {1, 0, 0})

gr.render(scene, 'hier.png', 256, 256, {0, 4, 12}, {0, -0.12, -1}, {0, 1, 0}, 40, {0.3, 0.3, 0.3}, {white, blue})
