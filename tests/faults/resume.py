"""K: checkpoints, and going on from them."""
import os

from harness import Case, ROOT

# A thread takes about half a second: it is met in the middle.
WORK = ROOT + """
local s = gr.sphere('s') s:set_refraction(1.5, 0.1) root:add_child(s, white)
for i = 1, 30 do root:add_child(gr.nh_sphere('s' .. i, {i / 9 - 2, math.sin(i), -1}, 0.3), white) end
gr.render(root, 'x.png', 160, 120, {0,0,5}, {0,0,-1}, {0,1,0}, 50, {0.3,0.3,0.3}, {gr.light({3,5,9}, {0.7,0.7,0.7}, {1,0,0}, 1)})
"""
SPP = "--spp 100"
LONG = "--spp 400"
ERROR = "--error 0.0005"
HEAD = "P='%s'; R=\"$P scene.lua -q -j 1\"; "
# Stops a render in the middle, however fast the machine.
STOP = "for t in 0.1 0.2 0.3 0.5 1 2; do timeout -s TERM $t $R %s; test -e x.checkpoint && break; done; test -e x.checkpoint || exit 90; rm -f x.png; "


def shell(script):
    return lambda project, folder: ["bash", "-c", HEAD % project + script]


def stopped(ids, name, script, code=0, says=(), quality=SPP, **more):
    """`script` after a render was stopped; $R renders scene.lua."""
    more.setdefault("old", False)
    return Case(ids, name, WORK, command=shell(STOP % quality + script), code=code, says=says, seconds=60, **more)


def like_the_whole(run):
    if run.code == 0 and run.read("whole.png") != run.read("x.png"):
        yield "the image is not that of an uninterrupted render"
    if os.path.exists(os.path.join(run.folder, "x.checkpoint")):
        yield "the checkpoint was left behind"


def left_alone(run):
    if not os.path.exists(os.path.join(run.folder, "x.checkpoint")):
        yield "a file that is no checkpoint was removed"


def kept(run):
    if not os.path.exists(os.path.join(run.folder, "x.checkpoint")):
        yield "the checkpoint is gone"
    if os.path.exists(os.path.join(run.folder, "x.png")):
        yield "an image was written"


def resumed(quality, options=""):
    return "$R %s -o whole.png && $R %s %s --resume" % (quality, quality, options)


def damaged(ids, name, damage, why, also=like_the_whole):
    return [stopped(ids, name, damage + resumed(SPP), 0, "warning: .*x.checkpoint %s.*; the render starts anew" % why, also=also),
            stopped(ids, name + ", --resume=require", damage + "$R %s --resume=require" % SPP, 1, "x.checkpoint: error: .*" + why, also=kept)]


def another(name, options, says, before=""):
    return stopped("K2", name, before + "$R %s --resume" % options, 1, r"x\.checkpoint: error: .*another picture: " + says, also=kept)


def watched(name, quality):
    """Two snapshots, and an image that knows nothing of them."""
    return Case("J6", name, WORK, old=False, seconds=60, also=like_the_whole, writes="x.partial.png", command=shell(
        "$R %s -o whole.png; $R %s & for t in 0.3 0.2; do sleep $t; kill -USR1 $!; done; wait $! && test -e x.partial.png" % (quality, quality)))


def killed(name, quality):
    """kill -9 again and again, and a last run that ends: the delays grow, so that some are late."""
    kills = "for t in 0.1 0.13 0.17 0.2 0.25 0.3; do timeout -s KILL $t $R %s --resume --checkpoint 0.02; done; "
    return Case("K3", name, WORK, command=shell(kills % quality + resumed(quality)), also=like_the_whole, seconds=60, old=False)


CASES = [
    stopped("K3 J1", "going on, with --spp", resumed(SPP), says="--resume goes on from x.checkpoint", also=like_the_whole),
    stopped("K3 J1", "going on, with --error", resumed(ERROR), quality=ERROR, says="--resume goes on from x.checkpoint", also=like_the_whole),
    stopped("K3", "going on with other threads and instruction sets", resumed(ERROR, "-j 3 --isa baseline"), quality=ERROR, also=like_the_whole),
    watched("snapshots, with --spp", LONG),
    watched("snapshots, with --error", ERROR),
    Case("J6", "a signal for a snapshot where there is none", WORK, command=shell(
        "$R --time 1 & sleep 0.5; kill -USR1 $!; wait $!"), writes="x.png"),
    killed("kill -9 six times, with --spp", SPP),
    killed("kill -9 six times, with --error", ERROR),
    *damaged("K1", "a checkpoint cut short", "truncate -s 9999 x.checkpoint; ", "is damaged"),
    *damaged("K1", "an empty checkpoint", ": > x.checkpoint; ", "is not a checkpoint", left_alone),
    *damaged("K1", "a checkpoint with a changed byte", "printf x | dd of=x.checkpoint bs=1 seek=5000 conv=notrunc status=none; ", "is damaged"),
    *damaged("K1", "another file for a checkpoint", "cp scene.lua x.checkpoint; ", "is not a checkpoint", left_alone),
    *damaged("K1", "a checkpoint of another version", "printf RTCHECK9 | dd of=x.checkpoint bs=1 conv=notrunc status=none; ",
             "is of another version"),
    Case("K1", "a folder for a checkpoint", WORK, ("scene.lua", "-q", "--spp", "1", "--resume"), 3, "x.checkpoint",
         files={"x.checkpoint": lambda path: os.mkdir(path)}),
    another("a checkpoint of another number of samples", "--spp 101", "--spp was 100, and is 101"),
    another("a checkpoint of another seed", SPP + " --seed 3", "--seed was not set, and is 3"),
    another("a checkpoint of another size", SPP + " --size 20x10", "--size was 0x0, and is 20x10"),
    another("a checkpoint of another crop", SPP + " --crop 0,0,20,20", "--crop was not set, and is 0,0,20,20"),
    another("a checkpoint of another parameter", SPP + " -D n=1", "-D n was not set, and is 1"),
    another("a checkpoint of another scene", SPP, "the scene's files are not the same", "echo >> scene.lua; "),
    Case("K2", "an older checkpoint that is further stays", WORK, old=False, seconds=60, command=shell(
        "timeout -s TERM 0.8 $R %s; cp x.checkpoint y; timeout -s TERM 0.1 $R %s; cmp x.checkpoint y && " % (LONG, LONG)
        + resumed(LONG)), also=like_the_whole),
    Case("K2", "a file that is no checkpoint stays", WORK, command=shell("timeout -s TERM 1 $R --spp 99999; grep -q mine x.checkpoint && exit 4"),
         code=4, says="x.checkpoint: is not a checkpoint, and is left alone", files={"x.checkpoint": "mine"}),
    Case("K2", "a scene that changed while it rendered leaves no checkpoint", WORK, old=False,
         command=shell("timeout -s TERM 2 $R --spp 99999 & sleep 1; echo >> scene.lua; wait; test -e x.partial.png && test ! -e x.checkpoint && exit 4"), code=4,
         says="no checkpoint: .*scene.lua: has changed"),
    Case("K2", "--resume with --time", WORK, ("scene.lua", "-q", "--time", "1", "--resume"), 2, "--resume.*--time"),
    Case("K2", "--resume with a script's time", "gr.options{time = 1}\n" + WORK, ("scene.lua", "-q", "--resume"), 2, "--resume.*--time"),
    Case("K2", "--resume into a device", WORK, ("scene.lua", "-q", "--spp", "1", "-o", "/dev/null", "--resume"), 2, "--resume.*no file"),
    Case("K2", "--resume from stdin", None, ("-", "-q", "--spp", "1", "--resume"), 1, "standard input", stdin=WORK.encode()),
    Case("K9", "a task that runs again after it was done", WORK, command=shell(
        "$R --spp 2 -o whole.png; $R --spp 2 --resume; $R --spp 2 --resume"), also=like_the_whole, old=False),
    Case("K9", "a shard that was killed and runs again", WORK, old=False, seconds=60, command=shell(
        "$R --spp 100 -o whole.png; for t in 0.1 0.2 0.3; do timeout -s KILL $t $R --spp 100 --shard 1/2 --resume --checkpoint 0.02; done; "
        "timeout -s TERM 0.15 $R --spp 100 --shard 2/2 --resume; test -e x.2-of-2.checkpoint || exit 90; "
        "for i in 1 2; do $R --spp 100 --shard $i/2 --resume; done; $P merge x.png x.*.part && test -z \"$(ls | grep checkpoint)\""),
        also=like_the_whole),
]
