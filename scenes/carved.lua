-- Solids made of solids: a flange on a shaft, a nut, a die, and chessmen, one of them of glass.
-- Look at: bores that cross each other, rims without a speckle where faces coincide, threads of one torus many
-- times, the rook's crown seen through its glass.

local root = gr.node('root')
local steel = gr.material({0.32, 0.33, 0.35}, {0.60, 0.60, 0.62}, 60)
local bore = gr.material({0.20, 0.20, 0.22}, {0.50, 0.50, 0.50}, 40)
local brass = gr.material({0.62, 0.45, 0.16}, {0.55, 0.50, 0.35}, 60)
local ivory = gr.material({0.82, 0.78, 0.68}, {0.35, 0.35, 0.35}, 60)
local ink = gr.material({0.10, 0.11, 0.16}, {0.40, 0.40, 0.40}, 60)
local ebony = gr.material({0.12, 0.08, 0.06}, {0.45, 0.45, 0.45}, 80)
local clear = gr.material({0.02, 0.03, 0.03}, {0.70, 0.70, 0.70}, 300)

local function painted(node, material) node:set_material(material) return node end
local function rod(name, x, y, z, h, r) return gr.nh_cylinder(name, {x, y, z}, h, r) end

-- A flange: a plate with six holes, a hub with a conical seat and a key's groove, a cross bore.
local function flange()
    local body = painted(gr.union('body', rod('plate', 0, 0, 0, 0.28, 1.3), rod('hub', 0, 0, 0, 0.95, 0.62)), steel)
    local holes = gr.node('holes')
    for i = 0, 5 do
        local a = math.rad(60 * i)
        holes:add_child(rod('hole ' .. i, 1.0 * math.cos(a), -1, 1.0 * math.sin(a), 3, 0.13), bore)
        holes:add_child(rod('counterbore ' .. i, 1.0 * math.cos(a), 0.18, 1.0 * math.sin(a), 1, 0.2), bore)
    end
    holes:add_child(rod('shaft', 0, -1, 0, 3, 0.34), bore)
    holes:add_child(gr.nh_box('key', {-0.1, -1, 0.2}, {0.2, 3, 0.26}), bore)
    holes:add_child(gr.nh_frustum('seat', {0, 0.75, 0}, 0.21, 0.34, 0.52), bore)
    local across = rod('cross bore', 0, -2, 0, 4, 0.12)
    across:rotate('x', 90)
    across:translate(0, 0.58, 0)
    holes:add_child(across, bore)
    return gr.difference('flange', body, holes)
end

-- A nut: three slabs in common are a hexagon; cones take its corners, tori cut its thread.
local function nut()
    local hexagon = {}
    for i = 0, 2 do
        local slab = gr.nh_box('slab ' .. i, {-0.5, 0, -2}, {1, 0.5, 4})
        slab:rotate('y', 60 * i)
        hexagon[#hexagon + 1] = slab
    end
    local lower = gr.nh_frustum('lower chamfer', {0, 0, 0}, 1, 0.5, 2.5)
    local upper = gr.nh_frustum('upper chamfer', {0, -0.5, 0}, 1, 2.5, 0.5)
    local thread = gr.node('thread')
    thread:add_child(rod('core', 0, -1, 0, 3, 0.3))
    local turn = gr.torus('turn', 0.3, 0.035)
    turn:rotate('x', 90)
    for i = 0, 6 do
        local at = gr.node('turn ' .. i)
        at:translate(0, 0.04 + 0.07 * i, 0)
        at:add_child(turn)
        thread:add_child(at)
    end
    return gr.difference('nut', gr.intersection('head', hexagon[1], hexagon[2], hexagon[3], lower, upper), thread)
end

-- Chessmen stand on y = 0. A ring of tori softens their feet.
local function foot(name)
    local ring = gr.torus(name .. ' ring', 0.36, 0.08)
    ring:rotate('x', 90)
    ring:translate(0, 0.08, 0)
    return gr.union(name .. ' foot', rod(name .. ' sole', 0, 0, 0, 0.16, 0.36), ring)
end

local function rook(name)
    local waist = gr.quadric(name .. ' waist', {xx = 1, yy = -0.12, zz = 1, y = 0.15, c = -0.092}, {-1, 0.16, -1}, {1, 0.9, 1})
    local crown = rod(name .. ' crown', 0, 0.85, 0, 0.4, 0.36)
    local gaps = {rod(name .. ' inside', 0, 1.05, 0, 1, 0.24)}
    for i = 0, 2 do
        local gap = gr.nh_box(name .. ' gap ' .. i, {-0.07, 1.08, -1}, {0.14, 1, 2})
        gap:rotate('y', 60 * i)
        gaps[#gaps + 1] = gap
    end
    return gr.difference(name, gr.union(name .. ' body', foot(name), waist, crown), table.unpack(gaps))
end

local function pawn(name)
    local skirt = gr.quadric(name .. ' skirt', {xx = 1, zz = 1, yy = -0.25, y = 0.42, c = -0.2}, {-1, 0.16, -1}, {1, 0.72, 1})
    local collar = gr.nh_sphere(name .. ' collar', {0, 0, 0}, 0.24)
    collar:scale(1, 0.25, 1)
    collar:translate(0, 0.72, 0)
    return gr.union(name, foot(name), skirt, collar, gr.nh_sphere(name .. ' head', {0, 0.92, 0}, 0.2))
end

local function bishop(name)
    local body = gr.quadric(name .. ' body', {xx = 1, zz = 1, yy = -0.16, y = 0.32, c = -0.19}, {-1, 0.16, -1}, {1, 0.95, 1})
    local mitre = gr.nh_sphere(name .. ' mitre', {0, 0, 0}, 0.22)
    mitre:scale(1, 1.5, 1)
    mitre:translate(0, 1.2, 0)
    local slot = gr.nh_box(name .. ' slot', {0, -0.03, -1}, {1, 0.06, 2})
    slot:rotate('z', 50)
    slot:translate(0.02, 1.2, 0)
    return gr.difference(name, gr.union(name .. ' whole', foot(name), body, mitre, gr.nh_sphere(name .. ' tip', {0, 1.55, 0}, 0.06)), slot)
end

local function die()
    local pips = gr.node('pips')
    local function pip(name, centre, radius) pips:add_child(gr.nh_sphere(name, centre, radius), ink) end
    pip('one', {0, 1.25, 0}, 0.35)
    for _, side in ipairs{-0.5, 0.5} do
        pip('two, ' .. side, {1.1, side, side}, 0.22)
        for _, other in ipairs{-0.5, 0.5} do pip('five, ' .. side .. other, {-1.1, side, other}, 0.22) end
    end
    for i = -1, 1 do pip('three, ' .. i, {0.55 * i, 0.55 * i, 1.1}, 0.22) end
    pip('five, middle', {-1.1, 0, 0}, 0.22)
    local cube = painted(gr.nh_box('cube', {-1, -1, -1}, 2), ivory)
    return gr.difference('die', gr.intersection('rounded', cube, painted(gr.nh_sphere('corners', {0, 0, 0}, 1.5), ivory)), pips)
end

local function put(solid, material, x, z, degrees, size)
    solid:scale(size, size, size)
    solid:rotate('y', degrees)
    solid:translate(x, 0, z)
    root:add_child(solid, material)
    return solid
end

local board = gr.checker{first = {0.62, 0.58, 0.50}, second = {0.24, 0.20, 0.18}, size = 1.1}
root:add_child(gr.nh_box('board', {-40, -1, -40}, {80, 1, 80}), nil, board)
put(flange(), nil, -1.9, -0.6, 20, 1)
put(nut(), brass, -0.35, 1.5, 12, 0.8)
local glass = put(rook('rook'), clear, 2.5, 0.5, 10, 1.25)
glass:set_refraction(1.5, 0)
glass:set_fresnel(true)
glass:set_absorption({0.9, 0.25, 0.35})
put(rook('black rook'), ebony, 0.55, -1.6, 25, 1.15)
put(pawn('pawn'), ivory, 1.2, 0.95, 0, 1.1)
put(bishop('bishop'), ivory, 3.4, -1.5, -35, 1.2)
put(pawn('black pawn'), ebony, 2.0, -1.9, 0, 1.1)
put(die(), nil, -1.7, 2.0, 35, 0.28):translate(0, 0.28, 0)

gr.background({0.72, 0.74, 0.78}, {0.30, 0.36, 0.46})
gr.render(root, 'carved.png', 960, 540, {0.6, 3.1, 7.2}, {-0.02, -0.36, -1}, {0, 1, 0}, 34, {0.28, 0.28, 0.30},
          {gr.light({-6, 9, 6}, {0.75, 0.72, 0.66}, {1, 0, 0}, 1),
           gr.light({7, 6, 3}, {0.25, 0.27, 0.32}, {1, 0, 0}, 0.6)})
