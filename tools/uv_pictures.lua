-- How images lie on each solid: `./Project tools/uv_pictures.lua` in the root renders
-- Documentation/images/uv_*.png. Red grows with u, green with v; thin lines are tenths, strong ones 0,
-- 1/2 and 1. The rods are the axes: x red, y green, z blue. Each picture shows the solid twice.

gr.background({0.93, 0.93, 0.93})

local grid = gr.texture('uv_grid.png', {0, 0, 0}, 1)
local colours = {x = {0.85, 0.10, 0.10}, y = {0.10, 0.60, 0.10}, z = {0.10, 0.20, 0.85}}

gr.options{error = 0.005}

local function axes(length)
    local all = gr.node('axes')
    local turn = {x = {'z', -90}, z = {'x', 90}}
    for axis, colour in pairs(colours) do
        local paint = gr.material(colour, {0, 0, 0}, 1)
        local arrow = gr.node('arrow')
        arrow:add_child(gr.nh_cylinder('rod', {0, 0, 0}, length, 0.022), paint)
        local tip = gr.nh_cone('tip', {0, 0, 0}, 0.2, 0.07)
        tip:rotate('x', 180)
        tip:translate(0, length + 0.2, 0)
        arrow:add_child(tip, paint)
        if turn[axis] then arrow:rotate(turn[axis][1], turn[axis][2]) end
        all:add_child(arrow)
    end
    return all
end

-- The solid, made by `make`, under two pairs of turns: about y, then about x.
local function picture(name, make, first, second, length)
    local root = gr.node('root')
    for i, turns in ipairs{first, second} do
        local stand = gr.node('stand')
        local solid = make()
        solid:set_texture(grid)
        stand:add_child(solid)
        stand:add_child(axes(length or 1.45))
        stand:rotate('y', turns[1])
        stand:rotate('x', turns[2])
        stand:translate(i == 1 and -1.75 or 1.75, 0, 0)
        root:add_child(stand)
    end
    gr.render(root, 'Documentation/images/uv_' .. name .. '.png', 560, 280, {0, 0, 40}, {0, 0, -1}, {0, 1, 0}, 5.2,
              {0.72, 0.72, 0.72}, {gr.light({-20, 30, 40}, {0.3, 0.3, 0.3}, {1, 0, 0})})
end

-- Around its middle, so that it turns in place; the axes cross there, too.
local function centred(make, x, y, z)
    return function()
        local node = make()
        node:translate(x, y, z)
        return node
    end
end

picture('sphere', function() return gr.sphere('sphere') end, {-30, 25}, {150, -25})
picture('box', function() return gr.nh_box('box', {-0.75, -0.75, -0.75}, 1.5) end, {-35, 25}, {145, -25})
picture('cylinder', function() return gr.cylinder('cylinder') end, {-30, 35}, {150, -35})
picture('cone', centred(function() return gr.nh_cone('cone', {0, 0, 0}, 2, 1) end, 0, -1, 0), {-30, 40}, {150, -20})
picture('torus', function() return gr.torus('torus', 0.8, 0.35) end, {-35, 15}, {145, -15})
picture('mesh', centred(function() return gr.mesh('vase', 'vase.obj') end, 0, -1.2, 0), {-30, 25}, {150, 25})
