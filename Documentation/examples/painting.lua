-- Three functions that paint: dots on a ball, waves around a drum, rings on the board.
local stage = require 'stage'
local root = gr.node('root')

local rings = gr.texture(function(u, v)
  local r = 12 * math.sqrt((u - 0.5) ^ 2 + (v - 0.5) ^ 2)
  return r < 6 and math.floor(r) % 2 == 0 and {0.30, 0.42, 0.52} or {0.78, 0.77, 0.72}
end, {0, 0, 0}, 1, 1024)

-- Dots along a spiral that covers the ball evenly.
local dots = gr.texture(function(u, v)
  local y = math.sin(math.pi * (v - 0.5))
  local r = math.sqrt(1 - y * y)
  local x, z = r * math.cos(2 * math.pi * u), r * math.sin(2 * math.pi * u)
  for k = 1, 60 do
    local h = (2 * k - 61) / 60
    local s, angle = math.sqrt(1 - h * h), 2.399963 * k
    if x * s * math.cos(angle) + y * h + z * s * math.sin(angle) > 0.985 then return 0.85, 0.25, 0.16 end
  end
  return 0.84, 0.78, 0.62
end, {0.3, 0.3, 0.3}, 40)

local waves = gr.texture(function(u, v)
  local s = 0.5 + 0.5 * math.sin(8 * math.pi * v + 2.2 * math.sin(8 * math.pi * u))
  return 0.16 + 0.6 * s, 0.30 + 0.45 * s, 0.56 + 0.2 * s
end, {0.3, 0.3, 0.3}, 40)

local floor = gr.nh_box('floor', {-4, -0.2, -4}, {8, 0.2, 8})
root:add_child(floor, nil, rings)
root:add_child(gr.nh_sphere('ball', {-1.2, 1, 0}, 1), nil, dots)
local drum = gr.cylinder('drum')
drum:scale(0.85, 1.7, 0.85)
drum:translate(1.3, 0, -0.2)
root:add_child(drum, nil, waves)
stage.show(root)
