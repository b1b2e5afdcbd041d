"""B: loading of scripts."""
import os

from harness import BALL, Case, ROOT, SHOT


def fails(ids, name, script, says, code=1, **more):
    return Case(ids, name, script, code=code, says=says, **more)


def fifo(path):
    os.mkfifo(path)


def link(target):
    return lambda path: os.symlink(target, path)


def outside(path):
    with open(os.path.join(os.path.dirname(os.path.dirname(path)), b"outside.lua"), "w") as f:
        f.write("return 'out'")
    os.symlink("../outside.lua", path)


def many_upvalues():
    return "local t = {}\n" + "t[#t + 1] = function() return t end " * 70000


CASES = [
    fails("B1", "syntax error", "\nx = = 1", r"scene\.lua:2: error: .*near '='"),
    fails("B1", "unfinished string", "x = 'abc", r"scene\.lua:1: error: .*near"),
    Case("B2", "empty file", "", says="warning: .*nothing"),
    Case("B2", "comments only", "-- nothing\n--[[ here ]]\n", says="warning: .*nothing"),
    Case("B2", "empty file, --werror", "", ("scene.lua", "--werror"), 1, "warning: .*nothing"),
    fails("B3", "bytecode", b"\x1bLua\x53\0\x19\x93\r\n", "binary chunk"),
    fails("B4", "NUL bytes", b"\0\0\0x = 1", r"scene\.lua:1: error"),
    fails("B4", "random bytes", bytes((i * 97 + i * i * 31) % 256 for i in range(4000)), "scene.lua"),
    fails("B4", "1 MB of (", "x = " + "(" * 1000000, "C levels"),
    fails("B4", "1 MB of {", "x = " + "{" * 1000000, "C levels"),
    fails("B4", "1 MB of blocks", "do " * 300000, "C levels"),
    fails("B4", "1 MB of unary minus", "x = " + "- " * 500000 + "1", "C levels|overflow"),
    Case("B5", "byte order mark, CRLF and #!", b"\xef\xbb\xbf#!/usr/bin/lua\r\n" + BALL.replace("\n", "\r\n").encode(),
         writes="x.png"),
    fails("B5", "line numbers after them", b"\xef\xbb\xbf#!/usr/bin/lua\r\n\r\nerror('here')", r"scene\.lua:3: error"),
    Case("B6", "100 MB script", None, code=1, says="67108864 bytes", files={"scene.lua": lambda path: grown(path, 100 << 20)}),
    fails("B6", "a million locals", "local a" + ", a" * 1000000, "too many local variables|limit"),
    Case("B6", "a million constants", "local t = {" + ",".join(map(str, range(1000000))) + "}\n" + BALL, writes="x.png"),
    Case("B6", "70,000 closures", many_upvalues() + "\n" + BALL, writes="x.png"),
    fails("B6", "a jump too long", "while true do local a = 1 " + "a = a + 1 " * 300000 + " end", "control structure too long|limit|time",
          code={1, 4}, args=("scene.lua", "-q", "--script-time", "2")),
    fails("B7", "require of what is missing", "\nrequire 'nothing'", [r"scene\.lua:2: error", r"nothing\.lua", r"nothing/init\.lua"],
          never=r"/usr/"),
    fails("B8", "require in a circle", "require 'one'", "loop|circle",
          files={"one.lua": "return require 'two'", "two.lua": "return require 'one'"}),
    fails("B9", "require upwards", "require '../../x'", "outside|not found"),
    fails("B9", "require of an absolute path", "require '/etc/passwd'", "outside|not found", never="root:"),
    fails("B9", "require through a link out", "require 'link'", "outside", files={"link.lua": outside}),
    fails("B10", "dofile of a FIFO", "dofile 'pipe.lua'", "device or a pipe|regular", files={"pipe.lua": fifo}),
    fails("B10", "dofile of a link to /dev/zero", "dofile 'zero.lua'", "outside", files={"zero.lua": link("/dev/zero")}),
    Case("B10", "a FIFO as scene", None, code=1, says="pipe", files={"scene.lua": fifo}),
    Case("B10", "/dev/zero as scene", None, ("/dev/zero",), 1, "/dev/zero"),
    Case("B10", "/proc/self/mem as scene", None, ("/proc/self/mem",), 1, "/proc/self/mem"),
    Case("B12", "a script that returns values", BALL + "\nreturn 1, {}, nil", writes="x.png"),
    fails("B12", "error({})", "error({})", "error object is a table value"),
    fails("B12", "error(nil)", "error(nil)", "error: .*nil"),
    fails("B12", "error(print)", "error(print)", "error object is a function value"),
    fails("B12", "error with a __tostring", "error(setmetatable({}, {__tostring = function() return 'mine' end}))", "mine"),
    fails("B12", "error with a failing __tostring", "error(setmetatable({}, {__tostring = function() error('inner') end}))", "error: "),
]


def grown(path, size):
    with open(path, "wb") as f:
        f.truncate(size)
