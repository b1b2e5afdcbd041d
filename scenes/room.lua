-- A room on a late summer afternoon: a cat looks at itself in the mirror.
--
-- Look at: the cat's face, which only the mirror shows, with the painted doors behind the camera; the stem that
-- breaks at the water's surface, and the glass's lighter shadow; the shadow of the paper doors on the wall; the
-- focus, which lies on the cat. Parts of it are in scenes/room/.
--
-- Each effect can be left out: ./Project scenes/room.lua -D lens=false -D bump=false -D soft=false

local lens = gr.param('lens', true, {doc = 'depth of field'})
local soft = gr.param('soft', true, {doc = 'lights with a size'})

local root = gr.node('room')
local window = require 'room.window'
local lantern = {1.30, 0.245, 0.30}

require 'room.shell'(root, window)
require 'room.shoji'(root)
window.build(root)
require 'room.cabinet'(root)
require 'room.table'(root, lantern)

gr.background({0.95, 0.88, 0.74}, {0.85, 0.90, 0.94})

local function light(at, colour, falloff, radius, brightness)
    return gr.light(at, colour, falloff, soft and radius or 0, brightness)
end

local lights = {
    -- The low sun, through the open door and, dimmed, through paper.
    light({7.6, 3.15, 4.7}, {1.20, 0.92, 0.56}, {1, 0, 0}, 0.07),
    -- The sky in the round window, and the bright veranda.
    light({window.x + 0.1, window.y + 0.25, -0.62}, {0.46, 0.54, 0.66}, {0.6, 0, 0.45}, 0.40),
    light({2.9, 1.5, 1.75}, {0.62, 0.58, 0.52}, {0.6, 0, 0.20}, 0.60),
    -- What the sunlit floor, the doors and the mirror give back.
    light({-0.5, 1.95, 2.7}, {0.46, 0.39, 0.31}, {0.8, 0, 0.12}, 0.45),
    light({-0.84, 0.92, 0.16}, {0.62, 0.52, 0.40}, {0.5, 0, 1.8}, 0.04),
    -- The lantern.
    light(lantern, {0.34, 0.21, 0.10}, {0.5, 0, 3.0}, 0.09),
    -- Daylight on the garden and on what lies beyond it.
    light({4.5, 11, -4}, {0.66, 0.66, 0.66}, {1, 0, 0}, 0, 1),
}

local eye, target = {0.27, 1.12, 3.02}, {-0.11, 0.59, 0}
local view = {target[1] - eye[1], target[2] - eye[2], target[3] - eye[3]}
local focus = lens and gr.focal({-0.90, 0.75, 0.30}, 0.05, 0.019) or nil

gr.render(root, 'room.png', 1280, 720, eye, view, {0, 1, 0}, 38, {0.26, 0.255, 0.27}, lights, focus)
