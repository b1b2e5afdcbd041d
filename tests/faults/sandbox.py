"""C: what a running script may do, and its limits."""
import os

from harness import BALL, Case, ROOT, SHOT, shot

TIMED = ("scene.lua", "-q", "--spp", "1", "--script-time", "0.3")
SMALL = ("scene.lua", "-q", "--spp", "1", "--script-memory", "64M")


def fails(ids, name, script, says, code=1, **more):
    return Case(ids, name, script, code=code, says=says, **more)


def timed(ids, name, script, says=r"scene\.lua:\d+: error: .*--script-time"):
    return fails(ids, name, script, says, 4, args=TIMED, seconds=10)


def crowded(ids, name, script):
    return fails(ids, name, script, r"error: .*(memory|bytes).*--script-memory", 4, args=SMALL, seconds=20)


def unwritten(run):
    if os.path.exists(os.path.join(run.folder, "out.txt")):
        yield "a file was written"


def same_again(script):
    """The same scene in a second process, whatever the addresses."""
    return Case("C22 C23 C24", "the same output in two runs", script, prints="^(.+)\n$", command=twice, old=False)


def twice(project, folder):
    return ["sh", "-c", "'%s' scene.lua -q --check > a; '%s' scene.lua -q --check > b; cmp a b && cat a" % (project, project)]


LOOP = "local function loop() while true do end end\n"
ORDER = """
local t = {} for i = 1, 40 do t[{}] = i t['k' .. i * 7919 % 1000] = i t[print] = 0 end
local seen = {} for k, v in pairs(t) do seen[#seen + 1] = v end
print(table.concat(seen, ' '), tostring({}), tostring(print), string.format('%s', {}), math.random(), math.random(1000))
"""
CASES = [
    fails("C1", "nil call", "\nfoo()", r"scene\.lua:2: error: .*nil value \(global 'foo'\)"),
    fails("C1", "arithmetic on nil, with the traceback", "local function f() return nil + 1 end\nf()",
          [r"scene\.lua:1: error: .*arithmetic", "traceback", r"scene\.lua:2"], args=("scene.lua", "-q", "--verbose")),
    timed("C2", "endless loop", "while true do end"),
    timed("C3", "pcall around an endless loop", LOOP + "while true do pcall(loop) end"),
    timed("C3", "xpcall whose handler loops", LOOP + "while true do xpcall(loop, loop) end", "error: .*--script-time"),
    timed("C4", "loop in a coroutine", LOOP + "coroutine.wrap(loop)()"),
    timed("C4", "coroutine that catches and goes on", LOOP + "while true do coroutine.resume(coroutine.create(loop)) end"),
    crowded("C5", "string.rep", "local s = string.rep('x', 1 << 30)"),
    fails("C6", "string.find that never ends", "string.find(('a'):rep(3000), ('a-'):rep(20) .. 'b')", "--script-time", 4,
          args=TIMED, seconds=10),
    fails("C7", "finaliser", "setmetatable({}, {__gc = function() while true do end end})", r"__gc is not available"),
    timed("C8", "__index of _G loops", LOOP + "setmetatable(_G, {__index = loop}) x = y"),
    timed("C8", "__tostring loops in print", LOOP + "print(setmetatable({}, {__tostring = loop}))"),
    timed("C8", "sort with a loop", LOOP + "table.sort({2, 1}, loop)"),
    timed("C8", "gsub with a loop", LOOP + "('x'):gsub('x', loop)"),
    crowded("C9", "table bomb", "local t = {} while true do t[#t + 1] = {} end"),
    crowded("C9", "concatenation bomb", "local s = 'x' while true do s = s .. s end"),
    crowded("C9", "table.concat bomb", "local t = {} for i = 1, 100 do t[i] = ('x'):rep(1 << 20) end local s = table.concat(t)"),
    crowded("C9", "coroutine bomb", "local t = {} while true do t[#t + 1] = coroutine.create(print) end"),
    crowded("C9", "node bomb", "local t = {} while true do t[#t + 1] = gr.node('n') end"),
    fails("C10", "deep recursion", "local function f() return 1 + f() end f()", "stack overflow"),
    fails("C10", "recursion in gsub", "local function f() ('x'):gsub('x', f) end f()", "overflow"),
    fails("C10", "nested coroutines", "local function f() return coroutine.wrap(f)() end f()", "overflow"),
    fails("C10", "recursion through __index", "local t = setmetatable({}, {__index = function(t, k) return t[k] end}) x = t.y", "overflow"),
    fails("C10", "nested pcall", "local function f() return assert(pcall(f)) end f()", "overflow"),
    fails("C10", "error handler that fails", "xpcall(error, function(m) error(m) end) error('last')", "last"),
    fails("C11", "unpack too much", "table.unpack({}, 1, 1e7)", "too many results"),
    fails("C11", "format too wide", "string.format('%1000d', 1)", "invalid format"),
    fails("C11", "invalid order function", "local t = {} for i = 1, 100 do t[i] = i end table.sort(t, function() return true end)",
          "invalid order function"),
    *[fails("C12", call, "\n" + call, r"scene\.lua:2: error: .*not available in the sandbox \(see --trust\)") for call in
      ("os.execute('true')", "io.popen('id')", "os.remove('x.png')", "os.rename('x.png', 'y')", "os.exit(0)", "os.tmpname()")],
    fails("C13", "/etc/passwd", "io.open('/etc/passwd')", "outside", never="root:"),
    fails("C13", "lines of ../", "for l in io.lines('../../etc/passwd') do end", "outside", never="root:"),
    fails("C14", "writing", "io.open('out.txt', 'w')", "sandbox|--trust", also=unwritten),
    fails("C14", "appending", "io.open('scene.lua', 'a')", "sandbox|--trust"),
    fails("C14", "reading and writing", "io.open('scene.lua', 'r+')", "sandbox|--trust"),
    *[fails("C15", call, call, "not available|binary chunk|nil value") for call in
      ("package.loadlib('x', 'y')", "debug.getinfo(1)", "debug.sethook()", "string.dump(print)", "assert(load('\\27Lua'))",
       "debug.getregistry()", "package.searchers[3]('x')")],
    Case("C16", "no way to the real globals",
         "local s = getmetatable('').__index assert(s == string) assert(not pcall(s.dump, print))\n"
         "assert(coroutine.wrap(function() return _ENV == _G end)())\n"
         "xpcall(error, function() assert(not pcall(os.exit)) end)\nassert(not pcall(rawget(os, 'exit')))\n" + BALL, writes="x.png"),
    Case("C17", "a script that breaks its own tools",
         BALL + "gr = nil pairs = nil string.format = error table = nil setmetatable = nil tostring = nil", writes="x.png"),
    *[fails("C18", name, "\n" + call, r"scene\.lua:2: error: .*expected") for name, call in (
        ("method of a node on a light", "gr.translate(gr.light({0,0,0}, {1,1,1}, {1,0,0}), 1, 2, 3)"),
        ("method of a node on a file", "gr.translate(io.stdout, 1, 2, 3)"),
        ("method of a node on a table", "gr.node('n').translate({}, 1, 2, 3)"),
        ("material for a light", "gr.sphere('s'):set_material(gr.light({0,0,0}, {1,1,1}, {1,0,0}))"),
        ("table with a node's metatable", "gr.translate(setmetatable({}, getmetatable(gr.node('n'))), 1, 2, 3)"))],
    fails("C19", "a node's __gc", "local n = gr.node('n') getmetatable(n).__gc(n)", "error: "),
    fails("C19", "a node's metatable changed", "setmetatable(gr.node('n'), {})", "error: "),
    fails("C20 C21", "an error through live C++ objects, a thousand times",
          "for i = 1, 1000 do pcall(gr.mesh, 'm', {{0,0,0}, {1,0,0}, {0,1,'x'}}, {{0, 1, 2}}) end error('end')", "end"),
    same_again(ORDER),
    Case("C25", "time and date", "assert(os.time() > 0 and os.clock() >= 0 and #os.date() > 0)\n" + BALL, writes="x.png"),
    fails("C27", "escapes in an error", r"error('\27[31mred\7\0\127')", r"\\x1b\[31mred\\x07"),
    fails("C27", "escapes in a node's name", ROOT + r"root:add_child(gr.sphere('\27]0;title\7'))" + SHOT, r"\\x1b\]0;title"),
    fails("C28", "a message of 256 MB", "error(('x'):rep(1 << 28))", "error: "),
]
