#include "script/sandbox.h"

#include "caged_script.h"

#include "script/cage.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace rt;
using namespace rt::test;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_CASE("What leaves the process is refused by name, with the way out") {
    const char* const names[] = {
        "os.execute",         "os.exit",           "os.getenv",      "os.remove",
        "os.rename",          "os.setlocale",      "os.tmpname",     "io.popen",
        "io.tmpfile",         "package.loadlib",   "string.dump",    "debug.getinfo",
        "debug.sethook",      "debug.getregistry", "debug.getlocal", "debug.getupvalue",
        "debug.setupvalue",   "debug.upvaluejoin", "debug.debug",    "debug.setmetatable",
        "debug.getmetatable", "package.searchpath"};
    for (const std::string name : names) {
        CAPTURE(name);
        for (const char* arguments : {"()", "('true')", "(print)", "({}, {})"}) {
            const Outcome outcome = runCaged("\n" + name + arguments);
            CHECK(outcome.code == 1);
            CHECK(outcome.message ==
                  "scene.lua:2: " + name + " is not available in the sandbox (see --trust)");
        }
    }
}

TEST_CASE("The libraries hold what is known to be harmless, and nothing else") {
    const Outcome outcome = runCaged(
        "for _, library in ipairs{'_G', 'coroutine', 'debug', 'io', 'os', 'package', 'utf8'} do "
        "local names = {} for name, value in pairs(_G[library]) do local ok, why = true, '' if "
        "type(value) == 'function' and (library == 'debug' or library == 'os' or library == "
        "'io' or library == 'package') then ok, why = pcall(value, '?') end if ok or not "
        "tostring(why):find('not available') then names[#names + 1] = name end end "
        "tell(library .. ': ' .. table.concat(names, ' ')) end");
    CHECK(outcome.told ==
          "_G: _G _VERSION assert bit32 collectgarbage coroutine debug dofile error "
          "getmetatable io ipairs load loadfile loadstring math next os package pairs pcall "
          "print rawequal rawget rawlen rawset require select setmetatable string table tell "
          "tonumber tostring type unpack utf8 xpcall\n"
          "coroutine: create isyieldable resume running status wrap yield\n"
          "debug: traceback\n"
          "io: close flush input lines open read stderr stdout type write\n"
          "os: clock date difftime time\n"
          "package: config cpath loaded path preload\n"
          "utf8: char charpattern codepoint codes len offset\n");
}

TEST_CASE("Finalisers, metatables and the string table give no way out") {
    const struct {
        const char* script;
        const char* told;
    } rows[] = {
        {"tell(pcall(setmetatable, {}, {__gc = print}))",
         "false __gc is not available in the sandbox (see --trust)\n"},
        {"tell(pcall(setmetatable, {}, {__gc = false}))",
         "false __gc is not available in the sandbox (see --trust)\n"},
        {"local m = {} local t = setmetatable({}, m) m.__gc = function() tell('ran') end t = nil "
         "collectgarbage() collectgarbage() tell('end')",
         "end\n"},
        {"tell(getmetatable('').__index == string, pcall(getmetatable('').__index.dump, print))",
         "true false string.dump is not available in the sandbox (see --trust)\n"},
        {"tell(getmetatable(io.stdout), io.stdout.__gc, io.stdout.__index, io.stdout.__metatable)",
         "locked nil nil nil\n"},
        {"tell(pcall(setmetatable, io.stdout, {}))",
         "false bad argument #1 to 'setmetatable' (table expected, got FILE*)\n"},
        {"tell(pcall(io.stdout.write, {}, 'x'))",
         "false bad argument #1 to '?' (FILE* expected, got table)\n"},
        {"tell(pcall(io.close, setmetatable({}, {__name = 'FILE*'})))",
         "false bad argument #1 to 'io.close' (FILE* expected, got FILE*)\n"},
        {"tell(load('\\27Lua'))", "nil attempt to load a binary chunk (mode is 't')\n"},
        {"tell(load('\\27Lua', 'x', 'b'))", "nil attempt to load a binary chunk (mode is '')\n"},
        {"local s = '\\27Lua' tell(load(function() local r = s s = nil return r end, 'x', 'bt'))",
         "nil attempt to load a binary chunk (mode is 't')\n"},
        {"tell(load('return x', 'c', 't', {x = 5})(), load('return x', 'c', nil, {x = 6})())",
         "5 6\n"},
        {"x = 8 tell(load('return x')(), loadstring('return x + 1')())", "8 9\n"},
        {"tell(coroutine.wrap(function() return _ENV == _G, _G._G == _G end)())", "true true\n"},
        {"tell(xpcall(function() error('e', 0) end, function(m) return m, _G.os.exit end))",
         "false e\n"},
        {"pairs, string.format, setmetatable, require = nil tell(tostring(1))", "1\n"},
        {"package.loaded.os.exit = nil tell(os.exit, package.loaded._G == _G)", "nil true\n"},
        {"tell(pcall(require, 'os') , require('os') == os, require('string') == string)",
         "true true true\n"},
        {"tell(io.read == nil, pcall(io.read))", "false false standard input file is closed\n"},
        {"tell(type(collectgarbage('count')), collectgarbage('stop'), collectgarbage('restart'))",
         "number 0 0\n"},
        {"tell(type(debug.traceback()))", "string\n"},
        {"tell(type(os.time()), type(os.clock()), os.date('!%Y', 0))", "number number 1970\n"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome = runCaged(row.script);
        CHECK(outcome.told == row.told);
        CHECK(outcome.message.empty());
    }
}

/// A scene's folder with everything that tempts to leave it.
class TemptingFolder : public CageFolder {
  public:
    TemptingFolder() {
        write("data.txt", "first\nsecond\n\nlast");
        write("sub/deep.txt", "deep");
        write("module.lua", "return {name = ..., file = select(2, ...)}");
        write("sub/inner.lua", "return 'inner'");
        write("pack/init.lua", "return 'pack'");
        write("bad.lua", "\n\nlocal = 1");
        write("fails.lua", "\nerror('no luck')");
        write("binary.lua", "\x1bLua");
        write("run.lua", "tell(...) return 1, 2, 3");
        write("one.lua", "return require 'two'");
        write("two.lua", "return require 'three'");
        write("three.lua", "return require 'one'");
        write("quiet.lua", "quiet = (quiet or 0) + 1");
        link("../secret.txt", "link.txt");
        link("../secret.lua", "link.lua");
        link("..", "up");
        link("/etc", "etc");
        link("../nothing", "dangling");
        link("data.txt", "good_link.txt");
        link("sub", "good_folder");
        REQUIRE(mkfifo(file("fifo").c_str(), 0600) == 0);
        REQUIRE(mkfifo(file("fifo.lua").c_str(), 0600) == 0);
        link("/dev/zero", "zero.lua");
    }

  private:
    void link(const std::string& target, const std::string& name) const {
        std::filesystem::create_symlink(target, file(name));
    }
};

TEST_CASE(
    "No path leads out of the scene's folder, by any function, whether the file exists or "
    "not") {
    const TemptingFolder folder;
    const std::string paths[] = {"/etc/passwd",
                                 "/nothing",
                                 "../secret.txt",
                                 "../nothing.txt",
                                 "..",
                                 "sub/../../secret.txt",
                                 "./.././secret.txt",
                                 "sub//..//..//secret.txt",
                                 "link.txt",
                                 "link.lua",
                                 "up/secret.txt",
                                 "up/nothing",
                                 "up",
                                 "etc/passwd",
                                 "dangling",
                                 "dangling/x",
                                 "zero.lua",
                                 "/dev/stdin",
                                 "/proc/self/mem",
                                 "//etc/passwd",
                                 "nothing/../../secret.txt",
                                 "data.txt\\0/../../secret.txt",
                                 folder.file("data.txt")};
    for (const std::string& path : paths) {
        for (const char* call :
             {"io.open('", "io.lines('", "io.input('", "dofile('", "loadfile('"}) {
            CAPTURE(path);
            CAPTURE(call);
            const Outcome outcome = runIn(folder, "\n" + (call + path) + "')");
            CHECK(outcome.code == 1);
            CHECK(contains(outcome.message, "is outside of the scene's folder (see --trust)"));
            CHECK(contains(outcome.message, "scene.lua:2: "));
            CHECK_FALSE(contains(outcome.message, "root:"));
            CHECK(outcome.files.empty());
        }
    }
}

TEST_CASE("require finds modules in the scene's folder alone") {
    const TemptingFolder folder;
    const struct {
        const char* script;
        const char* told;
    } rows[] = {
        {"local m = require 'module' tell(m.name, m.file, require('module') == m)",
         "module module.lua true\n"},
        {"tell(require 'sub.inner', require 'sub/inner', require 'pack')", "inner inner pack\n"},
        {"tell(require 'good_folder.inner', require './sub/inner')", "inner inner\n"},
        {"tell(require 'quiet', require 'quiet', quiet)", "true true 1\n"},
        {"package.path = package.path .. ';sub/?.lua' tell(require 'inner')", "inner\n"},
        {"package.path = './sub/?.lua' tell(require 'inner', (pcall(require, 'module')))",
         "inner false\n"},
        {"package.preload.made = function(...) return 'made', ... end tell(require 'made')",
         "made\n"},
        {"package.loaded.given = 5 tell(require 'given')", "5\n"},
        {"package.path = nil tell(require 'sub.inner')", "inner\n"},
        {"for i = 1, 2 do local ok, why = pcall(require, 'fails') tell(why:match('no luck')) end",
         "no luck\nno luck\n"},
        {"tell(pcall(require, 'one')) tell(pcall(require, 'one'))",
         "false one.lua\nfalse one.lua\n"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        Outcome outcome = runIn(folder, row.script);
        // The message on a cycle names the file with its folder; the shape is looked at below.
        if (contains(row.script, "'one'")) {
            CHECK(std::count(outcome.told.begin(), outcome.told.end(), '\n') == 2);
            CHECK(contains(outcome.told, "one -> two -> three -> one"));
        } else {
            CHECK(outcome.told == row.told);
        }
        CHECK(outcome.message.empty());
    }
}

TEST_CASE("require tells what is wrong with a module") {
    const TemptingFolder folder;
    const struct {
        std::string script, message;
    } rows[] = {
        {"require 'none'",
         "scene.lua:1: module 'none' not found:\n\tno field package.preload['none']\n\tno file "
         "'none.lua'\n\tno file 'none/init.lua'"},
        {"require '../secret'", "'../secret.lua' is outside of the scene's folder"},
        {"require '../../x'", "'../../x.lua' is outside of the scene's folder"},
        {"require 'link'", "'link.lua' is outside of the scene's folder"},
        {"require '/etc/passwd'", "'/etc/passwd.lua' is outside of the scene's folder"},
        {"package.path = '/etc/?' require 'passwd'", "'/etc/passwd' is outside"},
        {"package.path = '../?.lua' require 'secret'", "'../secret.lua' is outside"},
        {"package.cpath = './?.so' require 'x'", "module 'x' not found"},
        {"require 'zero'", "'zero.lua' is outside"},
        {"require 'fifo'", "is a device or a pipe; only regular files are read"},
        {"require 'bad'", "bad.lua:3: <name> expected near '='"},
        {"require 'fails'", "fails.lua:2: no luck"},
        {"require 'binary'", "binary.lua: binary chunks are refused"},
        {"require 'one'", "loop: modules require each other: one -> two -> three -> one"},
        {"require()", "bad argument #1 to 'require' (string expected, got no value)"},
        {"require {}", "bad argument #1 to 'require' (string expected, got table)"},
        {"require ''", "not found"},
        {"require '..'", "not found"},
        {"require(('x'):rep(100000))", "not found"},
        {"require 'a\\0b'", "is outside"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script.substr(0, 60));
        const Outcome outcome = runIn(folder, row.script);
        CHECK(outcome.code == 1);
        CAPTURE(outcome.message);
        CHECK(contains(outcome.message, row.message));
        CHECK_FALSE(contains(outcome.message, "secret'\n"));
    }
    CHECK(contains(runIn(folder, "require 'fails'").traceback, "fails.lua:2"));
    CHECK(contains(runIn(folder, "require 'fails'").traceback, "scene.lua:1: in main chunk"));
}

TEST_CASE("dofile and loadfile run files of the scene's folder") {
    const TemptingFolder folder;
    CHECK(runIn(folder, "tell(dofile('run.lua'))").told == "\n1 2 3\n");
    CHECK(runIn(folder, "tell(loadfile('run.lua')('x', 'y'))").told == "x y\n1 2 3\n");
    CHECK(runIn(folder, "loadfile('run.lua', 't', {tell = function() tell('env') end})()").told ==
          "env\n");
    CHECK(runIn(folder, "local f, why = loadfile('none.lua') tell(f, why)").told ==
          "nil cannot open 'none.lua'\n");
    CHECK(contains(runIn(folder, "tell(loadfile('bad.lua'))").told, "bad.lua:3: <name> expected"));
    CHECK(
        contains(runIn(folder, "tell(loadfile('binary.lua'))").told, "binary chunks are refused"));
    CHECK(contains(runIn(folder, "tell(loadfile('fifo'))").told, "only regular files"));
    const struct {
        const char* script;
        const char* message;
    } rows[] = {
        {"dofile 'none.lua'", "scene.lua:1: dofile: cannot open 'none.lua'"},
        {"dofile 'bad.lua'", "bad.lua:3: <name> expected near '='"},
        {"dofile 'fails.lua'", "fails.lua:2: no luck"},
        {"dofile 'sub'", "is a folder, not a file"},
        {"dofile 'fifo'", "only regular files are read"},
        {"dofile()", "bad argument #1 to 'dofile'"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome = runIn(folder, row.script);
        CHECK(outcome.code == 1);
        CHECK(contains(outcome.message, row.message));
    }
    CHECK(contains(runIn(folder, "dofile 'fails.lua'").traceback, "scene.lua:1: in main chunk"));
}

TEST_CASE("io reads files of the scene's folder and writes none") {
    const TemptingFolder folder;
    const struct {
        const char* script;
        const char* told;
    } rows[] = {
        {"local f = io.open('data.txt') tell(f:read('l'), f:read('n'), f:read(3)) f:close() "
         "tell(io.type(f), tostring(f))",
         "first nil sec\nclosed file file (closed)\n"},
        {"tell(#io.open('data.txt', 'rb'):read('a'))", "18\n"},
        {"for line in io.lines('data.txt') do tell(line) end", "first\nsecond\n\nlast\n"},
        {"for a, b in io.lines('data.txt', 1, 2) do tell(a, b) break end", "f ir\n"},
        {"for line in io.open('data.txt'):lines('L') do tell(#line) end", "6\n7\n1\n4\n"},
        {"io.input('data.txt') tell(io.read(), io.read('a')) io.close(io.input())",
         "first second\n\nlast\n"},
        {"for l in io.lines('good_link.txt') do tell(l) break end", "first\n"},
        {"tell(io.open('good_folder/deep.txt'):read('a'))", "deep\n"},
        {"tell(io.open('./sub/../data.txt'):seek('end'))", "18\n"},
        {"tell(io.open('none.txt'))", "nil none.txt: No such file or directory 2\n"},
        {"tell(io.open('sub/none/none.txt'))",
         "nil sub/none/none.txt: No such file or directory 2\n"},
        {"tell(io.open('sub'))", "nil sub: is a folder, not a file 13\n"},
        {"tell(io.open('fifo'))",
         "nil fifo: is a device or a pipe; only regular files are read 13\n"},
        {"tell(io.open('data.txt'):write('x'))", "nil Bad file descriptor 9\n"},
        {"for i = 1, 5000 do for l in io.lines('data.txt') do end end tell('all closed')",
         "all closed\n"},
        {"tell(io.output() == io.stdout, io.type(io.stdout), io.stdin)", "true file nil\n"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome = runIn(folder, row.script);
        CHECK(outcome.told == row.told);
        CHECK(outcome.message.empty());
    }
    for (const char* script :
         {"io.open('new.txt', 'w')", "io.open('data.txt', 'a')", "io.open('data.txt', 'r+')",
          "io.open('data.txt', 'w+b')", "io.open('data.txt', 'x')", "io.output('new.txt')"}) {
        CAPTURE(script);
        const Outcome outcome = runIn(folder, script);
        CHECK(outcome.code == 1);
        CHECK(contains(outcome.message, "is not available in the sandbox"));
    }
    CHECK_FALSE(std::filesystem::exists(folder.file("new.txt")));
    CHECK(contains(runIn(folder, "io.lines('none.txt')").message, "No such file or directory"));
    CHECK(runIn(folder, "io.open()").code == 1);
}

TEST_CASE("Every file that was read is told once, resolved") {
    const TemptingFolder folder;
    folder.write("main.lua",
                 "require 'module' dofile 'good_folder/inner.lua' io.open('good_link.txt') "
                 "io.open('data.txt') loadfile('run.lua') io.open('none') pcall(require, 'bad')");
    const Outcome outcome = runFileIn(folder, "main.lua");
    CHECK(outcome.message.empty());
    const std::vector<std::string> files = {folder.file("main.lua"),      folder.file("module.lua"),
                                            folder.file("sub/inner.lua"), folder.file("data.txt"),
                                            folder.file("run.lua"),       folder.file("bad.lua")};
    CHECK(outcome.files == files);
}

TEST_CASE("A path from the current folder is found where it leads into the scene's folder") {
    const TemptingFolder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(std::filesystem::path(folder.scene()).parent_path());
    SandboxSettings settings;
    settings.sceneFolder = sceneFolderOf("scene/main.lua");
    CHECK(runCaged("tell(io.open('scene/data.txt'):read(), dofile('scene/sub/inner.lua'))", {},
                   settings)
              .told == "first inner\n");
    CHECK(runCaged("io.open('secret.txt'):read()", {}, settings).code == 1);
    CHECK(runCaged("require 'bad'", {}, settings).message ==
          "scene/bad.lua:3: <name> expected near '='");
    std::filesystem::current_path(before);
}

TEST_CASE("With trust everything of Lua is there, in fixed orders all the same") {
    const TemptingFolder folder;
    const std::string made = folder.file("made.txt");
    const struct {
        std::string script, told;
    } rows[] = {
        {"local f = io.open('" + made + "', 'w') f:write('x') f:close() tell(io.open('" + made +
             "'):read('a'), os.remove('" + made + "'))",
         "x true\n"},
        {"tell(io.popen('echo hello'):read())", "hello\n"},
        {"tell(os.execute('exit 3'))", "nil exit 3\n"},
        {"tell(debug.getinfo(1, 'l').currentline, type(debug.getregistry()))", "1 table\n"},
        {"tell(load(string.dump(function() return 5 end))())", "5\n"},
        {"local f = io.open('" + folder.file("code.lua") +
             "', 'wb') f:write(string.dump(function() return 6 end)) "
             "f:close() tell(dofile('code.lua')) os.remove('" +
             folder.file("code.lua") + "')",
         "6\n"},
        {"tell(require 'module'.name, require '../secret')", "module secret\n"},
        {"tell(dofile('" + folder.file("../secret.lua") + "'))", "secret\n"},
        {"tell((pcall(require, 'none')))", "false\n"},
        {"for k in pairs{b = 1, a = 2} do tell(k) end", "a\nb\n"},
        {"tell(math.random(10))", "9\n"},
        {"setmetatable({}, {__gc = function() tell('finalised') end}) collectgarbage()",
         "finalised\n"},
        {"setmetatable({}, {__gc = function() error('finaliser') end}) for i = 1, 100000 do "
         "tostring({}) end",
         ""},
        {"for i = 1, 2000 do setmetatable({}, {__gc = function() error('finaliser') end}) "
         "pcall(tell, 'x', {}, tostring(i)) pcall(require, 'none') end",
         "*"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome = runIn(folder, row.script, true);
        if (row.told == "*") continue;
        CHECK(outcome.told == row.told);
    }
}

TEST_CASE("Scripts of older Lua versions run") {
    const struct {
        const char* script;
        const char* told;
    } rows[] = {
        {"tell(unpack({1, 2, 3})) tell(unpack({1, 2, 3}, 2))", "1 2 3\n2 3\n"},
        {"tell(table.getn({1, 2, 3}), table.maxn({1, [10] = 2, [2.5] = 1, x = 1}))", "3 10\n"},
        {"tell(table.maxn({}), table.maxn({[1.5] = 1}), table.maxn({[-3] = 1}))", "0 1.5 0\n"},
        {"local t = {1, 2} table.setn(t, 1) tell(#t)", "2\n"},
        {"table.foreach({b = 2, a = 1, 7}, function(k, v) tell(k, v) end)", "1 7\na 1\nb 2\n"},
        {"tell(table.foreach({a = 1, b = 2}, function(k, v) if v == 2 then return k end end))",
         "b\n"},
        {"tell(table.foreachi({5, 6}, function(i, v) tell(i, v) if v == 6 then return i end end))",
         "1 5\n2 6\n2\n"},
        {"for w in string.gfind('a b', '%a') do tell(w) end", "a\nb\n"},
        {"tell(math.pow(2, 10), math.mod(7, 3), math.log10(1000))", "1024.0 1 3.0\n"},
        {"tell(math.ldexp(1, 3), math.frexp(8))", "8.0 0.5 4\n"},
        {"tell(math.cosh(0), math.sinh(0), math.tanh(0))", "1.0 0.0 0.0\n"},
        {"tell(loadstring('return 1 + 1')())", "2\n"},
        {"tell(pcall(table.foreach, {1}, function() error('x', 0) end))", "false x\n"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.script);
        const Outcome outcome = runCaged(row.script);
        CHECK(outcome.told == row.told);
        CHECK(outcome.message.empty());
    }
}

TEST_CASE("The mathematics of scripts is that of the program") {
    CHECK(runCaged("local function near(a, b) return math.abs(a - b) < 1e-15 end "
                   "assert(near(math.sin(1), 0.8414709848078965)) "
                   "assert(near(math.cos(1), 0.5403023058681398)) "
                   "assert(near(math.tan(0.5), 0.5463024898437905)) "
                   "assert(near(math.atan(1, 1), 0.7853981633974483)) "
                   "assert(near(math.exp(-1), 0.36787944117144233)) "
                   "assert(near(math.log(2), 0.6931471805599453)) "
                   "assert(near(2^0.5, math.sqrt(2))) assert(math.log(8, 2) == 3) "
                   "assert(math.floor(-0.5) == -1) assert(math.fmod(-7, 3) == -1)")
              .message.empty());
}

TEST_CASE("resolveBelow tells what lies in a folder after links from what does not") {
    const TemptingFolder folder;
    using Kind = Resolved::Kind;
    const struct {
        std::string path;
        Kind kind;
        std::string file;
    } rows[] = {
        {"data.txt", Kind::kFound, "data.txt"},
        {"good_link.txt", Kind::kFound, "data.txt"},
        {"good_folder/deep.txt", Kind::kFound, "sub/deep.txt"},
        {"sub/../data.txt", Kind::kFound, "data.txt"},
        {".", Kind::kFound, ""},
        {"none", Kind::kMissing, ""},
        {"sub/none/none", Kind::kMissing, ""},
        {"data.txt/x", Kind::kMissing, ""},
        {"", Kind::kMissing, ""},
        {"DATA.TXT", Kind::kMissing, ""},
        {"..", Kind::kOutside, ""},
        {"../scene_two", Kind::kOutside, ""},
        {"/", Kind::kOutside, ""},
        {"dangling/../../secret.txt", Kind::kOutside, ""},
    };
    for (const auto& row : rows) {
        CAPTURE(row.path);
        const Resolved resolved = resolveBelow(folder.scene(), row.path);
        CHECK(resolved.kind == row.kind);
        if (row.kind == Kind::kFound) {
            CHECK(resolved.path == (row.file.empty() ? folder.scene() : folder.file(row.file)));
        } else {
            CHECK(resolved.path.empty());
        }
    }
    std::filesystem::create_directory(folder.file("../scene_two"));
    CHECK(resolveBelow(folder.scene(), "../scene_two").kind == Kind::kOutside);
    CHECK(resolveBelow(folder.file("nowhere"), "x").kind == Kind::kOutside);
    CHECK(resolveBelow("/", "etc/../etc/passwd").kind == Kind::kFound);
}

TEST_CASE("The folder of a scene is the one that its path names") {
    CHECK(sceneFolderOf("a.lua") == ".");
    CHECK(sceneFolderOf("-") == ".");
    CHECK(sceneFolderOf("scenes/a.lua") == "scenes");
    CHECK(sceneFolderOf("/a.lua") == "/");
    CHECK(sceneFolderOf("../x/y/a.lua") == "../x/y");
}

}  // namespace
