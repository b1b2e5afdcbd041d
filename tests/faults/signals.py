"""J: signals, scarce resources, threads."""
import os, resource, signal, time

from harness import BALL, Case, is_sanitized, OLD, ROOT, SHOT, Skip, whole_image
from meshes import TRIANGLE
from output import NOISE, QUIET, sh

SLOW = ROOT + """
local s = gr.sphere('s') s:set_refraction(1.5, 0.1) root:add_child(s, white)
for i = 1, 30 do root:add_child(gr.nh_sphere('s', {i / 9 - 2, math.sin(i), -1}, 0.3), white) end
gr.render(root, 'x.png', 300, 200, {0,0,5}, {0,0,-1}, {0,1,0}, 50, {0.3,0.3,0.3}, {gr.light({3,5,9}, {0.7,0.7,0.7}, {1,0,0}, 1)})
"""
SURE = "scene.lua --spp 1000000 "
# A second, and what a busy machine and a sanitizer may add.
PROMPT = 1.0 + 2.0


def sent(numbers, words, word="Threads", delay=0.3):
    signals = ",".join(str(int(n)) for n in numbers)
    helper = os.path.join(os.path.dirname(os.path.abspath(__file__)), "send_signal.py")
    return lambda project, folder: ["python3", helper, word, str(delay), signals, str(PROMPT), project, *words.split()]


def stopped(ids, name, number, words=SURE, script=SLOW, partial=True, old=True, **more):
    def check(run):
        there = os.path.exists(os.path.join(run.folder, "x.partial.png"))
        if partial is not None and there != partial:
            yield "x.partial.png is %s" % ("there" if there else "missing")
        if there and not whole_image(run.read("x.partial.png")):
            yield "half a partial image"
        if run.read("x.png") != OLD:
            yield "the older image is gone"
    return Case(ids, name, script, command=sent([number], words, **{k: more.pop(k) for k in ("word", "delay") if k in more}), code=128 + int(number),
                also=check, says=more.pop("says", "x.partial.png" if partial else ()), **more)


def saved(run):
    whole = [name for name in ("x.png", "x.partial.png") if os.path.isfile(os.path.join(run.folder, name)) and run.read(name) != OLD]
    if not whole or not whole_image(run.read(whole[0])):
        yield "the image is lost"


def while_saving(delay):
    """A finished image is saved first, which takes a sanitized program five times as long."""
    def command(project, folder):
        size = "1100x1100" if is_sanitized(project) else "1800x1800"
        return sent([signal.SIGTERM], "scene.lua --spp 1 --size " + size, "100 %", delay)(project, folder)
    return command


def grid(path):
    """A mesh that takes seconds to read and to build."""
    with open(path, "w") as f:
        n = 1000
        for y in range(n):
            f.writelines("v %d %d %d\n" % (x, y, x * y % 7) for x in range(n))
        for y in range(n - 1):
            f.writelines("f %d %d %d %d\n" % (y * n + x + 1, y * n + x + 2, (y + 1) * n + x + 2, (y + 1) * n + x + 1) for x in range(n - 1))


def limited(ids, name, kind, value, code, says=(), words="", script=BALL, **more):
    return Case(ids, name, script, ("scene.lua", "-q", "--spp", "1", *words.split()), code, says, limits=[(kind, value)], **more)


def meshed_by(script):
    return ROOT + "root:add_child(gr.mesh('m', 'm.obj'), white)" + script


def counted(run):
    if "Threads: 1\n" not in run.errors:
        yield "more threads than cores"


CASES = [
    stopped("J1", "SIGINT while rendering", signal.SIGINT),
    stopped("J1", "SIGINT while rendering towards an error", signal.SIGINT, "scene.lua --error 1e-7 --max-spp 1000000"),
    stopped("J1", "SIGINT while rendering against time", signal.SIGINT, "scene.lua --time 100"),
    stopped("J3", "SIGTERM while rendering", signal.SIGTERM),
    stopped("J3", "SIGHUP while rendering", signal.SIGHUP),
    Case("J2", "SIGINT twice", SLOW, command=sent([signal.SIGINT, signal.SIGINT], SURE), code=130,
         also=lambda run: [] if run.read("x.png") == OLD else ["the older image is gone"]),
    Case("J2", "SIGINT again while it leaves", SLOW, command=sent([signal.SIGINT, signal.SIGINT], SURE, "Threads,Interrupted"), code=130),
    stopped("J4", "SIGINT in the script", signal.SIGINT, script="while true do end", partial=False),
    stopped("J4", "SIGTERM in string.find", signal.SIGTERM, script="string.find(('a'):rep(3000), ('a-'):rep(20) .. 'b')", partial=False),
    *[stopped("J4", "SIGTERM %g s into a mesh" % delay, signal.SIGTERM, "scene.lua --spp 1000", script=meshed_by(SHOT.replace("8, 6", "400, 300")), partial=False if delay < 0.5 else None,
              files={"m.obj": grid}, delay=delay) for delay in (0.1, 0.5, 1.0)],
    stopped("J4", "SIGINT while waiting for a FIFO to write to", signal.SIGINT, "scene.lua --spp 1 -o p", partial=False, files={"p": lambda path: os.mkfifo(path)}, delay=1.0,
            script=BALL),
    *[Case("J4", "SIGTERM %g s after the last pixel" % delay, BALL, command=while_saving(delay),
           code={0, 143}, also=saved, seconds=60) for delay in (0.0, 0.3, 0.5, 0.7)],
    stopped("J4", "SIGTERM at once", signal.SIGTERM, delay=0.0, partial=None),
    Case("J5", "stopped and continued", SLOW, command=sent([signal.SIGTSTP, signal.SIGCONT, signal.SIGINT], SURE), code=130),
    *[limited("J7", "%d MB of addresses" % (value >> 20), resource.RLIMIT_AS, value, {0, 4}, heavy=True) for value in (64 << 20, 100 << 20, 128 << 20, 160 << 20, 200 << 20)],
    limited("J7", "too few addresses for the image", resource.RLIMIT_AS, 700 << 20, 4, "memory", "--size 8000x8000", heavy=True),
    limited("J7", "too few addresses for the script", resource.RLIMIT_AS, 300 << 20, 4, "memory", script="local t = {} while true do t[#t + 1] = {} end", heavy=True),
    limited("J7", "too few addresses for a mesh", resource.RLIMIT_AS, 200 << 20, 4, "memory", script=meshed_by(SHOT), files={"m.obj": grid}, heavy=True),
    limited("J8", "16 files", resource.RLIMIT_NOFILE, 16, 0, writes="x.png"),
    limited("J8", "a stack of 256 KB", resource.RLIMIT_STACK, 256 << 10, 0, writes="x.png", heavy=True),
    limited("J8", "a stack of 256 KB, and a script that recurs", resource.RLIMIT_STACK, 256 << 10, 1, "overflow", heavy=True,
            script="local function f() ('x'):gsub('x', f) end f()"),
    limited("J8", "a stack of 256 KB, and a nested table", resource.RLIMIT_STACK, 256 << 10, 1, "C levels", heavy=True, script="x = " + "{" * 100000),
    Case("J8", "no more threads", BALL, command=lambda project, folder: ["setpriv", "--reuid=65533", "--regid=65533", "--clear-groups", "sh", "-c",
         "ulimit -u 1; exec '%s' scene.lua -q --spp 1 -j 8 -o /dev/null" % project] if os.getuid() == 0 else skip("only root may become somebody else"), heavy=True),
    Case("J9", "one core", BALL, command=lambda project, folder: ["taskset", "-c", "0", project, "scene.lua", "--spp", "1"], also=counted, writes="x.png"),
    Case("J11", "the script's time is not the renderer's", SLOW, ("scene.lua", "-q", "--spp", "40", "--script-time", "0.2"), writes="x.png"),
    *[Case("J13", "a mesh cut short after %g s of reading" % delay, meshed_by(SHOT), command=sh("$R & child=$!; sleep %g; truncate -s 1000 m.obj; wait $child" % delay),
           code={0, 1}, files={"m.obj": grid}) for delay in (0.05, 0.3)],
    Case("J14", "1, 2, 3, 7 and 64 threads", SLOW, command=sh("for j in 1 2 3 7 64; do $P scene.lua -q --spp 2 -j $j -o $j.pfm; done; "
         "cmp 1.pfm 2.pfm && cmp 1.pfm 3.pfm && cmp 1.pfm 7.pfm && cmp 1.pfm 64.pfm && $R"), writes="x.png", seconds=60),
    Case("J15", "instruction sets masked", SLOW, command=sh("$P scene.lua -q --spp 2 -o a.pfm; GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA $P scene.lua -q --spp 2 -o b.pfm; "
         "cmp a.pfm b.pfm && $R"), writes="x.png"),
]


def skip(why):
    raise Skip(why)
