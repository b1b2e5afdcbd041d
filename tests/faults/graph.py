"""E: the graph of nodes."""
from harness import BALL, Case, ROOT, SHOT, shot
from output import same_bytes

DIAMONDS = """
local n = gr.sphere('s')
for i = 1, %d do
    local up = gr.node('level') up:add_child(n, white) up:add_child(n, white) n = up
end
root:add_child(n)
"""
CHAIN = """
local n = gr.sphere('s')
n:set_material(white)
for i = 1, 1000000 do local up = gr.node('n') up:add_child(n) n = up end
root:add_child(n)
"""
CASES = [
    Case("E1", "a child of itself", "local a = gr.node('a')\na:add_child(a)", code=1, says=[r"scene\.lua:2: error: ", "cycle: a -> a|cycle: a → a"]),
    Case("E1", "a circle of two", "local a, b = gr.node('a'), gr.node('b') a:add_child(b)\nb:add_child(a)", code=1,
         says=[r"scene\.lua:2: error: ", "cycle"]),
    Case("E1", "a circle of 100,000", "local first = gr.node('n') local n = first\nfor i = 1, 99999 do local m = gr.node('n') n:add_child(m) n = m end\n"
         "n:add_child(first)", code=1, says=[r"scene\.lua:3: error: ", "cycle"]),
    Case("E2", "one child, many parents", shot("local s = gr.sphere('s') for i = -2, 2 do local g = gr.node('g') g:translate(i, 0, 0) g:add_child(s, white) "
         "root:add_child(g) end"), writes="x.png"),
    Case("E3", "2^40 instances", shot(DIAMONDS % 40), code=4, says=["1099511627776|more than", "--max-instances"], seconds=10),
    Case("E3", "2^80 instances", shot(DIAMONDS % 80), code=4, says="--max-instances", seconds=10),
    Case("E3", "2^5000 instances", shot(DIAMONDS % 5000), code=4, says="--max-instances", seconds=10),
    Case("E4", "a chain of a million nodes", shot(CHAIN), writes="x.png", seconds=60),
    Case("E5", "an empty scene", ROOT + SHOT, says="warning: ", writes="x.png"),
    Case("E5", "an empty group", shot("root:add_child(gr.node('g'))"), says="warning: ", writes="x.png"),
    Case("E6", "nodes without end", "local t = {} for i = 1, 1e7 do t[i] = gr.node('n') end", ("scene.lua", "-q", "--script-memory", "256M"), code=4,
         says="--script-memory", seconds=60),
    Case("E7 E8", "what only the graph holds lives",
         shot("do local g = gr.node('g') g:add_child(gr.sphere('s'), gr.material({1,0,0}, {0,0,0}, 1)) root:add_child(g) end white = nil "
              "for i = 1, 5 do collectgarbage() end"), writes="x.png"),
    Case("E9", "coincident objects", shot("for i = 1, 20 do root:add_child(gr.sphere('s'), gr.material({i / 20, 1 - i / 20, 0}, {0,0,0}, 1)) end"),
         command=same_bytes("-j 1", "-j 7"), writes="x.png"),
]
