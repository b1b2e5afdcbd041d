-- A ring of gold on a table: the heart of light that its inside throws.
local root = gr.node('root')
gr.options{caustics = true}

root:add_child(gr.nh_box('table', {-30, -1, -30}, {60, 1, 60}), gr.material({0.62, 0.58, 0.53}, {0, 0, 0}, 1))

-- A band, rounded at its edges.
local band = {}
local function corner(x, y, from)
  for i = 0, 6 do
    local a = math.rad(from + 15 * i)
    band[#band + 1] = {x + 0.05 * math.cos(a), y + 0.05 * math.sin(a)}
  end
end
corner(1.08, 0.05, -90)
corner(1.08, 0.40, 0)
corner(1.00, 0.40, 90)
corner(1.00, 0.05, 180)

local points, faces = {}, {}
local steps, n = 240, #band
for i = 0, steps - 1 do
  local a = 2 * math.pi * i / steps
  for _, p in ipairs(band) do points[#points + 1] = {p[1] * math.cos(a), p[2] + 0.002, p[1] * math.sin(a)} end
  local here, there = n * i, n * ((i + 1) % steps)
  for k = 0, n - 1 do
    local l = (k + 1) % n
    faces[#faces + 1] = {here + k, here + l, there + l, there + k}
  end
end
local gold = gr.material({0.83, 0.60, 0.24}, {0.6, 0.5, 0.25}, 120)
local ring = gr.mesh('ring', points, faces)
ring:set_reflection(0.25)
root:add_child(ring, gold)

gr.background({0.50, 0.47, 0.44}, {0.30, 0.32, 0.38})
root:render('caustic_ring.png', 640, 360, {0.15, 4.2, 3.6}, {0, -1.2, -1}, {0, 1, 0}, 32, {0.16, 0.16, 0.18},
            {gr.light({-3.8, 2.6, -3.0}, {1.0, 0.95, 0.86}, {1, 0, 0}, 0.12)})
