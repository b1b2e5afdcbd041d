-- A glass of water in low sunlight, on a white table: the light that it gathers.
local root = gr.node('root')
gr.options{caustics = true}

local table_top = gr.material({0.72, 0.70, 0.66}, {0, 0, 0}, 1)
local clear = gr.material({0, 0, 0}, {0.9, 0.9, 0.9}, 400)
root:add_child(gr.nh_box('table', {-30, -1, -30}, {60, 1, 60}), table_top)

-- A wall of revolution: outside up, over the rim, inside down. The water fills the inside, and overlaps the glass by a
-- hair, so that there is no air between them.
local function turned(name, outline, steps)
  local points, faces = {}, {}
  for i = 0, steps - 1 do
    local a = 2 * math.pi * i / steps
    for _, p in ipairs(outline) do
      points[#points + 1] = {p[1] * math.cos(a), p[2], p[1] * math.sin(a)}
    end
  end
  local n = #outline
  for i = 0, steps - 1 do
    local here, there = n * i, n * ((i + 1) % steps)
    for k = 0, n - 2 do
      local a, b, c, d = here + k, here + k + 1, there + k + 1, there + k
      -- On the axis the quads close up to triangles.
      local face = outline[k + 1][1] == 0 and {a, b, c} or outline[k + 2][1] == 0 and {a, b, d} or {a, b, c, d}
      faces[#faces + 1] = face
    end
  end
  return gr.mesh(name, points, faces)
end

local function arc(outline, x, y, r, from, to, steps)
  for i = 0, steps do
    local a = math.rad(from + (to - from) * i / steps)
    outline[#outline + 1] = {x + r * math.cos(a), y + r * math.sin(a)}
  end
end

local outline = {{0, 0.01}}
arc(outline, 0.92, 0.11, 0.1, -90, 0, 8)
arc(outline, 1.12, 3.0, 0.04, 0, 180, 12)
arc(outline, 0.82, 0.35, 0.12, 0, -90, 8)
outline[#outline + 1] = {0, 0.23}
local glass = turned('glass', outline, 180)
glass:set_refraction(1.5, 0)
glass:set_fresnel(true)
root:add_child(glass, clear)

local inside = {{0, 0.2301}}
arc(inside, 0.82, 0.35, 0.1201, -90, 0, 8)
inside[#inside + 1] = {0.94 + 0.14 * (1.9 - 0.35) / 2.65, 1.9}
inside[#inside + 1] = {0, 1.9}
local water = turned('water', inside, 180)
water:set_refraction(1.33, 0)
water:set_fresnel(true)
water:set_absorption{0.10, 0.03, 0.015}
root:add_child(water, clear)

gr.background({0.74, 0.76, 0.80}, {0.42, 0.52, 0.66})
root:render('caustic_glass.png', 640, 360, {1.2, 3.6, 8.6}, {-0.02, -0.33, -1}, {0, 1, 0}, 32, {0.20, 0.21, 0.24},
            {gr.light({-9, 9, -6}, {0.85, 0.80, 0.70}, {1, 0, 0}, 0.35)})
