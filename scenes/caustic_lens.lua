-- A magnifying lens, held over a page: it burns where it gathers the light.
local root = gr.node('root')
gr.options{caustics = true}

root:add_child(gr.nh_box('desk', {-30, -1.02, -30}, {60, 1, 60}), gr.material({0.34, 0.22, 0.14}, {0.1, 0.1, 0.1}, 20))
root:add_child(gr.nh_box('page', {-2.4, -0.02, -1.9}, {4.8, 0.02, 3.6}), nil,
               gr.stripes{first = {0.74, 0.73, 0.69}, second = {0.62, 0.61, 0.58}, size = 0.18, direction = {0, 0, 1}})

-- Two caps of balls of radius 1.8, back to back: 1 / f = (n - 1) 2 / R, so f = 1.8 for n = 1.5.
local radius, half, steps, rings = 1.8, 1.0, 192, 48
local sag = radius - math.sqrt(radius * radius - half * half)
local points, faces = {}, {}
for side = -1, 1, 2 do
  for k = 0, rings - 1 do
    local r = half * k / rings
    local y = side * (sag - (radius - math.sqrt(radius * radius - r * r)) + 0.02)
    for i = 0, steps - 1 do
      local a = 2 * math.pi * i / steps
      points[#points + 1] = {r * math.cos(a), y, r * math.sin(a)}
    end
  end
  for i = 0, steps - 1 do
    local a = 2 * math.pi * i / steps
    points[#points + 1] = {half * math.cos(a), side * 0.02, half * math.sin(a)}
  end
end
local all = steps * (rings + 1)
for side = 0, 1 do
  for k = 0, rings - 1 do
    for i = 0, steps - 1 do
      local a, b = all * side + steps * k + i, all * side + steps * k + (i + 1) % steps
      if k == 0 then
        faces[#faces + 1] = {a, a + steps, b + steps}
      else
        faces[#faces + 1] = {a, a + steps, b + steps, b}
      end
    end
  end
end
for i = 0, steps - 1 do
  local a, b = steps * rings + i, steps * rings + (i + 1) % steps
  faces[#faces + 1] = {a, a + all, b + all, b}
end

local clear = gr.material({0, 0, 0}, {0.9, 0.9, 0.9}, 400)
local steel = gr.material({0.45, 0.46, 0.48}, {0.6, 0.6, 0.6}, 80)
local hand = gr.node('hand')
local lens = gr.mesh('lens', points, faces)
lens:set_refraction(1.5, 0)
lens:set_fresnel(true)
hand:add_child(lens, clear)
local rim = gr.torus('rim', 1.04, 0.06)
rim:rotate('x', 90)
hand:add_child(rim, steel)
hand:add_child(gr.nh_box('handle', {1.05, -0.06, -0.09}, {1.7, 0.12, 0.18}), gr.material({0.12, 0.08, 0.06}, {0.4, 0.4, 0.4}, 60))
hand:translate(-0.5, 1.45, 0)
hand:rotate('y', -25)
hand:rotate('z', 18)
hand:rotate('x', 8)
root:add_child(hand)

gr.background({0.52, 0.52, 0.54}, {0.36, 0.40, 0.48})
root:render('caustic_lens.png', 640, 360, {0.3, 3.4, 5.0}, {-0.02, -0.58, -1}, {0, 1, 0}, 36, {0.20, 0.20, 0.22},
            {gr.light({-2.5, 9, -1.5}, {0.95, 0.92, 0.86}, {1, 0, 0}, 0.15)})
