-- A module of the old programs: reads the vertices and faces of an OBJ file into tables, 0-based.

local M = {}

function M.read(name)
    local vertices, faces = {}, {}
    for line in io.lines(name) do
        local tag, rest = string.match(line, '^(%a+)%s+(.*)$')
        if tag == 'v' then
            local x, y, z = string.match(rest, '(%S+)%s+(%S+)%s+(%S+)')
            table.insert(vertices, {tonumber(x), tonumber(y), tonumber(z)})
        elseif tag == 'f' then
            local face = {}
            for index in string.gmatch(rest, '(%d+)[^%s]*') do
                table.insert(face, tonumber(index) - 1)
            end
            table.insert(faces, face)
        end
    end
    return vertices, faces
end

return M
