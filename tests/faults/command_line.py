"""A: the command line."""
import os

from harness import BALL, Case, ROOT, SHOT, png, textured, whole_image

QUIET = ("-q", "--spp", "1")


def usage(ids, name, *args, says=()):
    return Case(ids, name, BALL, ("scene.lua", *QUIET, *args), 2, says)


def clipped(run):
    if b"IHDR\x00\x00\x00\x03\x00\x00\x00\x02" not in run.read("x.png"):
        yield "the crop was not clipped to 3x2"


def rendered(run):
    if not whole_image(run.read("x.png")) or run.read("x.png") == b"":
        yield "no image"


def named(run):
    if "stdin:2: error:" not in run.errors:
        yield "the chunk is not named stdin"


def pipeline(tail):
    """The program with its stdout in a pipe whose reader is gone."""
    return lambda project, folder: ["bash", "-c", "set -o pipefail; '%s' %s" % (project, tail)]


PARAM = "local n = gr.param('n', 3)\n" + BALL
CASES = [
    Case("A1", "no arguments, no default scene", None, (), 1, "project.lua.*|Usage"),
    Case("A2", "--help", None, ("--help",), 0, prints=r"--threads"),
    Case("A2", "--version", None, ("--version",), 0, prints=r"\d+\.\d+"),
    usage("A3", "unknown flag", "--treads", "2", says=r"--treads.*did you mean --threads\?"),
    *[usage("A4", "--threads " + n, "--threads", n, says="--threads") for n in ("-1", "abc", "1e9", "1.5", "1025", "")],
    Case("A4", "--threads 0 is all cores", BALL, ("scene.lua", *QUIET, "--threads", "0"), writes="x.png"),
    *[usage("A3", "--aov " + n, "--aov", n, says="--aov.*depth, normal") for n in ("dept", "depth,", "", "depth normal")],
    Case("I11", "an --aov that is an input", textured(png(2, 2), "x.uv.pfm")["script"], ("scene.lua", *QUIET, "--aov", "uv"), 2,
         r"x\.uv\.pfm", files={"x.uv.pfm": png(2, 2)}),
    usage("I9", "--aov beside a stream", "--aov", "depth", "-o", "-", says="more images than one"),
    *[usage("A5", "--size " + s, "--size", s, says="--size") for s in
      ("0x10", "-5x10", "10x", "1e3x2", "x", "10", "99999999999x1", "10x10x10", " 5x5", "nanx5")],
    *[usage("A6", "--crop " + c, "--crop", c, says="crop") for c in
      ("9,9,12,12", "5,5,2,2", "nan,0,1,1", "0,0,0,0", "1,2,3", "-9,-9,-1,-1")],
    Case("A6", "--crop partly outside", BALL, ("scene.lua", *QUIET, "--crop", "5,4,99,99"), 0,
         r"warning: --crop.*\[-Wcrop\]", also=clipped),
    Case("A7", "missing scene", None, ("nothing.lua",), 1, r"nothing\.lua.*No such file"),
    Case("A7", "a folder as scene", None, ("d.lua",), 1, r"d\.lua.*folder", files={"d.lua/x": b""}),
    Case("A7", "a current folder that is gone", BALL, (), 1, "current folder cannot be found", old=False,
         command=lambda project, folder: ["sh", "-c", "mkdir d && cd d && rmdir ../d && exec '%s' '%s/scene.lua' -q" % (project, folder)]),
    Case("A7", "unreadable scene", BALL, (), 1, r"scene\.lua.*Permission denied",
         command=lambda project, folder: unreadable(project, folder)),
    Case("A8", "the second of three is bad", BALL, ("scene.lua", "bad.lua", "third.lua", *QUIET), 1, r"bad\.lua:1",
         files={"bad.lua": "x = = 1", "third.lua": BALL.replace("x.png", "third.png")}, writes="third.png"),
    Case("A8", "--fail-fast", BALL, ("bad.lua", "scene.lua", *QUIET, "--fail-fast"), 1, r"bad\.lua:1",
         files={"bad.lua": "x = = 1"}),
    Case("A9", "-D with a word for a number", PARAM, ("scene.lua", *QUIET, "-D", "n=abc"), 1,
         r"scene\.lua:1: error: .*n.*abc"),
    usage("A9", "-D without =", "-D", "n", says="-D"),
    Case("A10", "-D that nobody reads", BALL, ("scene.lua", *QUIET, "-D", "unread=1"), 0, r"warning: .*unread"),
    Case("A10", "-D that nobody reads, --werror", BALL, ("scene.lua", *QUIET, "-D", "unread=1", "--werror"), 1,
         r"warning: .*unread"),
    *[Case("A9", "a file of parameters with " + what, PARAM, ("scene.lua", *QUIET, "--param-file", "p"), 1, says,
           files={"p": content})
      for what, content, says in (
          ("a word for a number", "n = abc\n", r"scene\.lua:1: error: .*n = abc \(p:1\)"),
          ("no =", "\nn 3\n", r"p:2: error: 'n 3' must be name = value"),
          ("a name twice", "n = 3\nn = 3\n", r"p:2: error: .*line 1"),
          ("a quote without an end", 'n = "3\n', r"p:1: error: .*quotes"),
          ("bytes of any kind", bytes(range(256)), r"p:1: error: "))],
    Case("A9", "a file of parameters with other line ends, and no last one", PARAM,
         ("scene.lua", *QUIET, "--param-file", "p"), writes="x.png", files={"p": "# DOS\r\nn = 3\r\n\r\n#"}),
    *[Case("A9", "a file of parameters that is " + what, PARAM, ("scene.lua", *QUIET, "--param-file", name), 1, says,
           files={"d/x": b""})
      for what, name, says in (("missing", "none", r"none: error: cannot be opened"), ("a folder", "d", r"d: error: is a folder"),
                               ("a device", "/dev/zero", r"/dev/zero: error: is a device"))],
    Case("A9", "a file of parameters larger than the script's memory", PARAM,
         ("scene.lua", *QUIET, "--param-file", "p", "--script-memory", "1M"), 4, r"p: error: .*--script-memory",
         files={"p": b"#" * (1 << 20) + b"\n"}),
    usage("A9", "--param-file without a name", "--param-file", "", says="--param-file"),
    Case("A10", "a file of parameters with a name that nobody reads", PARAM, ("scene.lua", *QUIET, "--param-file", "p"), 1,
         r"p:1: error: unknown parameter 'm'", files={"p": "m = 3\n"}),
    *[usage("A11", "--frames " + f, "--frames", f, says="--frames") for f in ("10-1", "a-b", "1-", "-", "1.5-2")],
    *[usage("A11", " ".join(words), *words, says="--subset")
      for words in (("--subset", "2"), ("--frames", "1-5", "--subset", "0-2"), ("--frames", "1-5", "--subset", "5-6"),
                    ("--frames", "1-5", "--subset", "3-2"))],
    usage("A11", "frames into one file", "--frames", "1-2", "-o", "y.png", says=r"-o y\.png: .*put # into the name"),
    Case("A11", "--frames 1-1e12", BALL, ("scene.lua", *QUIET, "--frames", "1-1000000000000"), {2, 4}, "--frames"),
    *[Case("A13", "scene named " + repr(n), None, (n, *QUIET), files={n: BALL}, writes="x.png")
      for n in ("a b.lua", "h\u00e4\u00df\u65e5.lua", "new\nline.lua", "./-dash.lua", "quo'te\".lua")],
    Case("A14", "stdout closed", BALL, prints="", command=pipeline("scene.lua -o - >&-"), code={3, 141},
         says="error: "),
    Case("A14", "image into a pipe that closes at once", BALL, command=pipeline("scene.lua -q --size 900x900 --spp 1 -o - | true"),
         code={0, 3}),
    Case("A14 C26", "print into a pipe that closes at once", "for i = 1, 1e6 do print('line', i) end\n" + BALL, prints="line",
         command=pipeline("scene.lua -q --spp 1 | head -1"), code={0, 141}, also=rendered),
    Case("A15", "scene from stdin", None, ("-", *QUIET), stdin=BALL.encode(), writes="x.png"),
    Case("A15", "error in a scene from stdin", None, ("-", *QUIET), 1, stdin=b"\nerror('x')", also=named),
    Case("A15", "empty stdin", None, ("-", *QUIET), 0, "warning: .*nothing"),
    Case("A16", "empty environment", BALL, env={}, writes="x.png"),
    Case("A16", "a locale with decimal commas", "local half = tonumber('0.5') assert(half == 1 / 2)\n" + BALL,
         ("scene.lua", "-q", "--time", "0.05", "--cutoff", "0.25"), env={"LANG": "de_DE.UTF-8", "LC_ALL": "de_DE.UTF-8"},
         writes="x.png"),
]


def unreadable(project, folder):
    os.chmod(os.path.join(folder, "scene.lua"), 0)
    os.chmod(os.path.dirname(folder), 0o755)
    os.chmod(folder, 0o777)
    return as_nobody([project, "scene.lua", "-q"])


def as_nobody(command):
    """root may read and write everything: then as somebody who may not."""
    if os.getuid() != 0:
        return command
    return ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", *command]
