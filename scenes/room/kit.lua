-- What every part of the room is built with.

local kit = {}

local count = 0

-- A name that no other node has.
function kit.name(word)
    count = count + 1
    return word .. ' ' .. count
end

function kit.group(word)
    return gr.node(kit.name(word))
end

function kit.mesh(word, file, options)
    return gr.mesh(kit.name(word), file .. '.obj', options)
end

-- Hangs a box of the given corner and size under the parent, in one material.
function kit.box(parent, corner, size, material)
    local node = gr.nh_box(kit.name('box'), corner, size)
    parent:add_child(node, material)
    return node
end

-- A board between two corners, its grain along its longest side, its texture as often as its length asks.
function kit.board(parent, low, high, texture, bump)
    local size = {high[1] - low[1], high[2] - low[2], high[3] - low[3]}
    local long = 2
    for axis = 1, 3 do
        if size[axis] > size[long] then long = axis end
    end
    local times = size[long] > 1.6 and 3 or 1
    local node = kit.mesh('board', 'room_board_' .. times)
    if long == 1 then
        node:rotate('z', -90)
    elseif long == 3 then
        node:rotate('x', 90)
    end
    node:scale(size[1], size[2], size[3])
    node:translate((low[1] + high[1]) / 2, (low[2] + high[2]) / 2, (low[3] + high[3]) / 2)
    parent:add_child(node, nil, texture, bump)
    return node
end

-- A round bar from a to b; the radius may differ at its ends only through `cone`.
function kit.bar(parent, a, b, radius, material, texture, bump)
    local d = {b[1] - a[1], b[2] - a[2], b[3] - a[3]}
    local length = math.sqrt(d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2)
    local node = gr.nh_cylinder(kit.name('bar'), {0, 0, 0}, length, radius)
    node:rotate('z', -math.deg(math.acos(d[2] / length)))
    node:rotate('y', -math.deg(math.atan(d[3], d[1])))
    node:translate(a[1], a[2], a[3])
    parent:add_child(node, material, texture, bump)
    return node
end

-- A ring about the y axis through its centre.
function kit.ring(parent, centre, big, small, material)
    local node = gr.torus(kit.name('ring'), big, small)
    node:rotate('x', 90)
    node:translate(centre[1], centre[2], centre[3])
    parent:add_child(node, material)
    return node
end

function kit.ball(parent, centre, radius, material)
    local node = gr.nh_sphere(kit.name('ball'), centre, radius)
    parent:add_child(node, material)
    return node
end

-- Numbers in [0,1) that are the same for each run, one stream for each seed.
function kit.random(seed)
    local state = seed
    return function()
        state = (state * 1103515245 + 12345) % 2147483648
        return (state >> 8) / 8388608
    end
end

return kit
