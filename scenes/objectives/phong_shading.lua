-- Phong shading: chessmen turned from tables of 16 sides, with normals interpolated between their corners.
-- Look at: round bodies whose outlines alone show the 16 sides; edges that stay edges, since they are sharper than
-- the smoothing angle. Without: flat faces.   ./Project scenes/objectives/phong_shading.lua -D without=true

local without = gr.param('without', false, {doc = 'flat faces'})
local sides = gr.param('sides', 16, {min = 3, max = 200, doc = 'sides of each piece'})

-- Profiles (radius, height), from the foot to the top.
local foot = {{0.30, 0}, {0.30, 0.05}, {0.27, 0.09}, {0.21, 0.12}, {0.23, 0.16}, {0.20, 0.20}}
local function profile(rest)
    local all = {}
    for _, p in ipairs(foot) do all[#all + 1] = p end
    for _, p in ipairs(rest) do all[#all + 1] = p end
    return all
end
local profiles = {
    pawn = profile{{0.13, 0.30}, {0.09, 0.44}, {0.085, 0.52}, {0.15, 0.55}, {0.15, 0.57}, {0.09, 0.59}, {0.13, 0.64}, {0.15, 0.71},
                   {0.13, 0.78}, {0.08, 0.83}, {0, 0.85}},
    rook = profile{{0.16, 0.32}, {0.14, 0.50}, {0.15, 0.62}, {0.21, 0.67}, {0.22, 0.70}, {0.22, 0.84}, {0.16, 0.84}, {0.15, 0.76}, {0, 0.75}},
    bishop = profile{{0.14, 0.34}, {0.10, 0.54}, {0.09, 0.68}, {0.17, 0.72}, {0.17, 0.74}, {0.09, 0.77}, {0.14, 0.84}, {0.15, 0.92},
                     {0.11, 1.02}, {0.04, 1.08}, {0.055, 1.11}, {0.04, 1.14}, {0, 1.15}},
    queen = profile{{0.16, 0.38}, {0.11, 0.64}, {0.10, 0.82}, {0.19, 0.86}, {0.19, 0.88}, {0.11, 0.91}, {0.14, 1.02}, {0.22, 1.18},
                    {0.17, 1.19}, {0.11, 1.23}, {0.06, 1.25}, {0.075, 1.29}, {0.05, 1.33}, {0, 1.34}},
    king = profile{{0.17, 0.40}, {0.12, 0.68}, {0.11, 0.88}, {0.20, 0.92}, {0.20, 0.95}, {0.12, 0.98}, {0.15, 1.10}, {0.20, 1.26},
                   {0.12, 1.33}, {0.05, 1.35}, {0, 1.36}},
}

-- Turns a profile about y: one quad for each step and side.
local function turn(name)
    local points, faces = {}, {}
    for _, p in ipairs(profiles[name]) do
        for k = 0, sides - 1 do
            local a = 2 * math.pi * k / sides
            points[#points + 1] = {p[1] * math.cos(a), p[2], -p[1] * math.sin(a)}
        end
    end
    for j = 0, #profiles[name] - 2 do
        for k = 0, sides - 1 do
            local n = (k + 1) % sides
            local above = (j + 1) * sides
            local tip = profiles[name][j + 2][1] == 0
            faces[#faces + 1] = tip and {j * sides + k, j * sides + n, above} or {j * sides + k, j * sides + n, above + n, above + k}
        end
    end
    return gr.mesh(name, points, faces, {smooth = without and 0 or 50})
end

local pieces = {}
for name in pairs(profiles) do pieces[name] = turn(name) end

local ivory = gr.material({0.80, 0.73, 0.58}, {0.42, 0.40, 0.36}, 70)
local ebony = gr.material({0.13, 0.08, 0.06}, {0.45, 0.43, 0.40}, 70)
local gold = gr.material({0.70, 0.50, 0.18}, {0.55, 0.48, 0.30}, 60)

local root = gr.node('root')
local pale, dark = gr.texture('room_cedar.png', {0.16, 0.15, 0.13}, 40), gr.texture('room_post.png', {0.16, 0.15, 0.13}, 40)
for i = 0, 7 do
    for j = 0, 7 do
        local square = gr.nh_box('square ' .. i .. ' ' .. j, {i - 4, -0.2, j - 4}, {1, 0.2, 1})
        square:set_reflection(0.86)
        root:add_child(square, nil, (i + j) % 2 == 0 and dark or pale)
    end
end
root:add_child(gr.nh_box('frame', {-4.4, -0.3, -4.4}, {8.8, 0.25, 8.8}), nil, dark)
root:add_child(gr.nh_box('table', {-30, -1.3, -30}, {60, 1, 60}), gr.material({0.13, 0.17, 0.16}, {0.03, 0.03, 0.03}, 8))

local function put(name, file, rank, look)
    local place = gr.node(name .. ' ' .. file .. rank)
    place:add_child(pieces[name], look)
    if name == 'king' then
        place:add_child(gr.nh_box('upright ' .. rank, {-0.022, 1.34, -0.022}, {0.044, 0.20, 0.044}), gold)
        place:add_child(gr.nh_box('bar ' .. rank, {-0.065, 1.43, -0.0221}, {0.13, 0.044, 0.0442}), gold)
    end
    place:translate(file - 4.5, 0, 4.5 - rank)
    root:add_child(place)
end

-- An endgame.
for _, p in ipairs{{'king', 4, 3}, {'queen', 6, 4}, {'bishop', 3, 4}, {'pawn', 5, 3}, {'pawn', 2, 3}, {'pawn', 7, 3}, {'rook', 8, 4}} do
    put(p[1], p[2], p[3], ivory)
end
for _, p in ipairs{{'king', 5, 7}, {'queen', 3, 6}, {'bishop', 7, 6}, {'pawn', 4, 5}, {'pawn', 2, 5}, {'pawn', 7, 5}, {'rook', 1, 7}, {'rook', 8, 8}} do
    put(p[1], p[2], p[3], ebony)
end

root:rotate('y', -14)
gr.background({0.16, 0.15, 0.15}, {0.44, 0.46, 0.50})
gr.render(root, 'phong_shading.png', 1280, 720, {0.1, 2.5, 5.6}, {-0.03, -0.40, -1}, {0, 1, 0}, 33, {0.24, 0.24, 0.27},
          {gr.light({-6, 7, 1}, {0.80, 0.72, 0.58}, {1, 0, 0}, 0.6), gr.light({7, 6, 5}, {0.22, 0.26, 0.34}, {1, 0, 0}, 1.0)})
