-- Five discs at the distances 5, 10, 20, 40 and 160, each as large in the picture as the next, before a
-- lens of radius 0.5 in focus at 10.
-- Right, because: the second is sharp. A point at D has a blur circle of radius h/2 a |p-D| /
-- (D p tan(fov/2)) pixels = 7.2 times 0.5 |10-D| / D (h = 48, tan = 1/3): 3.6 for the first, 1.8, 2.7 and
-- 3.4 for the last three. So the first and the last are the most blurred and nearly alike.

gr.options{spp = 16}

local m = gr.material({1, 1, 1}, {0, 0, 0}, 1)
local root = gr.node('root')
local function disc(name, x, distance)
    local d = gr.cylinder(name)
    d:scale(0.07 * distance, 0.001, 0.07 * distance)
    d:rotate('x', 90)
    d:translate(x * distance, 0, -distance)
    root:add_child(d, m)
end
for i, distance in ipairs({5, 10, 20, 40, 160}) do disc('disc ' .. i, 0.25 * (i - 3), distance) end

gr.background({0.05, 0.05, 0.1})
gr.render(root, 'lens.png', 144, 48, {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 36.87, {0.9, 0.7, 0.3}, {},
          gr.focal(10, 0.05, 0.5))
