"""I: what is written, and what stays when it cannot be."""
import os, shutil, subprocess

import harness
from harness import BALL, Case, OLD, ROOT, SHOT, Skip, whole_image
from loading import fifo, link

FSIZE = 1  # RLIMIT_FSIZE
# Too many bytes for a page, whatever the compression: noise.
NOISE = ("local root = gr.node('r')\nfor i = 1, 300 do root:add_child(gr.nh_sphere('s', {math.random() * 8 - 4, math.random() * 8 - 4, 0}, 0.3), "
         "gr.material({math.random(), math.random(), math.random()}, {0,0,0}, 0)) end\n"
         "gr.render(root, 'x.png', 200, 150, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0.3,0.3,0.3}, {gr.light({3,5,9}, {0.7,0.7,0.7}, {1,0,0})})")
QUIET = "scene.lua -q --spp 1 "


def sh(words, *, root=False):
    """A shell line in the run's folder; $P is the program, run with QUIET's arguments by $R."""
    def command(project, folder):
        if root and os.getuid() != 0:
            raise Skip("only root may do this")
        return ["sh", "-c", "P='%s'; R=\"$P %s\"; %s" % (project, QUIET, words)]
    return command


def same_bytes(first, second):
    return sh("$R %s -o a.pfm && $R %s -o b.pfm && cmp a.pfm b.pfm && $R" % (first, second))


def mounted(options, words):
    """Within a mount of its own at small/, where scene.lua is ../scene.lua; nothing stays behind."""
    def command(project, folder):
        for flags in ("-m", "-rm"):
            inside = "mkdir -p small && mount -t tmpfs -o %s none small" % options
            if subprocess.run(["unshare", flags, "sh", "-c", inside], cwd=folder, capture_output=True).returncode == 0:
                return ["unshare", flags, "sh", "-c", "P='%s'; %s && cd small && { %s; }" % (project, inside, words)]
        raise Skip("no right to mount a tmpfs")
    return command


def old_is_whole(words):
    """Runs `words` beside an older image on a full disk; its exit code is theirs unless that image or the folder changed."""
    return ("printf '%s' > x.png; %s; c=$?; " % (OLD.decode(), words)
            + "[ \"$(cat x.png)\" = '%s' ] || { echo 'error: the older image is gone' >&2; exit 99; }; " % OLD.decode()
            + "[ \"$(ls -A)\" = x.png ] || { echo \"error: left behind: $(ls -A)\" >&2; exit 99; }; exit $c")


def nobody(words):
    """As somebody who is not root, who owns the run's folder."""
    def command(project, folder):
        shell = ["sh", "-c", "P='%s'; R=\"$P %s\"; %s" % (project, QUIET, words)]
        if os.getuid() != 0:
            return shell
        os.chmod(os.path.dirname(folder), 0o755)
        for base, folders, names in os.walk(folder):
            for path in [base] + [os.path.join(base, name) for name in folders + names]:
                os.chown(path, 65534, 65534, follow_symlinks=False)
        return ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", *shell]
    return command


def wrote(name):
    def check(run):
        if not os.path.isfile(os.path.join(run.folder, name)) or not whole_image(run.read(name)):
            yield "no whole image in " + name
    return check


def stays(what, holds):
    def check(run):
        if not holds(run):
            yield what
    return check


def image(ids, name, command, **more):
    return Case(ids, name, more.pop("script", BALL), command=command, **more)


KILLED = """
for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    $P scene.lua -q --spp 1 & child=$!
    sleep 0.0$((i %% 10))$i; kill -9 $child 2>/dev/null; wait $child 2>/dev/null
    python3 -c 'import sys; sys.path.insert(0, "%s"); import harness
d = open("x.png", "rb").read(); sys.exit(0 if d == harness.OLD or harness.whole_image(d) and len(d) > 100 else 98)' || exit 98
done
$R
""" % os.path.dirname(os.path.abspath(__file__))

CASES = [
    image("I1", "a missing folder is made", sh("$R -o a/b/c.png"), writes="a/b/c.png"),
    image("I1", "a folder that cannot be made", sh("$R -o scene.lua/c.png"), code=3, says="error: .*scene.lua"),
    image("I1", "a folder below a missing one in /proc", sh("$R -o /proc/nothing/c.png"), code=3, says="error: .*/proc"),
    image("I2", "a folder without the right to write", nobody("mkdir d && chmod 555 d && $R -o d/c.png"), code=3, says="error: .*d/c.png|error: .*d"),
    image("I2", "a write-protected image", nobody("chmod 444 x.png && $R"), code=3, says="error: .*x.png"),
    image("I2", "refused before rendering", nobody("chmod 444 x.png && $R --size 4000x3000 --spp 4000"), code=3, says="error: ", seconds=5),
    image("I2", "a read-only file system", mounted("size=64k,ro", "$P ../scene.lua -q --spp 1 -o x.png"), code=3, says="error: .*x.png"),
    image("I3", "the name is a folder", sh("mkdir d.png && $R -o d.png"), code=3, says="error: .*d.png"),
    *[image("I4", "disk full, %s of %s" % (size, kind), mounted("size=" + size, old_is_whole("$P ../scene.lua -q --spp 1 -o x." + kind) if kind == "png" else
            old_is_whole("$P ../scene.lua -q --spp 1 -o y." + kind)), script=NOISE, code=3, says="error: .*cannot be written: No space left")
      for size, kind in (("4k", "png"), ("8k", "png"), ("40k", "png"), ("40k", "pfm"), ("40k", "exr"), ("40k", "tif"), ("40k", "hdr"))],
    image("I4", "disk full for --stats", mounted("size=4k", "head -c 4096 /dev/zero > fill; $P ../scene.lua -q --spp 1 -o /dev/null --stats s.json; c=$?; "
          "[ -e s.json ] && exit 99; exit $c"), code=3, says="error: .*s.json: cannot be written: No space left"),
    *[image("I5", "files of at most %d bytes" % size, sh("$R"), script=NOISE, code=3, says="error: .*x.png.*File too large", limits=[(FSIZE, size)]) for size in (0, 1, 4096, 20000)],
    image("I4 I6", "/dev/full", sh("$R -o /dev/full"), code=3, says="error: .*/dev/full.*No space left",
          also=stays("/dev/full is no device any more", lambda run: not os.path.isfile("/dev/full"))),
    image("I4 I6", "stdout is /dev/full", sh("$R -o - > /dev/full"), code=3, says="error: .*No space left"),
    image("I7", "kill -9 at twenty moments", sh(KILLED), writes="x.png", script=NOISE, seconds=60),
    image("I7", "a temporary of a process that ended", sh("touch x.png.tmp-999999-0 && $R && [ ! -e x.png.tmp-999999-0 ]"), writes="x.png"),
    image("I8", "a symbolic link stays", sh("mkdir d && mv x.png d/y.png && ln -sf d/y.png x.png && $R && [ -L x.png ]"), writes="d/y.png"),
    image("I8", "a dangling link", sh("rm x.png; ln -s new.png x.png && $R && [ -L x.png ]"), writes="new.png"),
    image("I8", "a link to itself", sh("rm x.png; ln -s x.png x.png && $R"), code=3, says="error: ", old=False),
    image("I9", "/dev/null", sh("$R -o /dev/null && [ -c /dev/null ]")),
    image("I9", "/dev/stdout into a file", sh("$R -o /dev/stdout > y.png"), writes="y.png"),
    image("I9", "a FIFO", sh("mkfifo p && { cat p > y.png & } && $R -o p && wait && [ -p p ]"), writes="y.png"),
    image("I9 A14", "a FIFO whose reader goes", sh("mkfifo p && { head -c 10 p > /dev/null & } && $R --size 900x900 -o p"), code=3, says="error: .*Broken pipe", script=NOISE),
    image("I9", "stdout", sh("$R -o - > y.png"), writes="y.png"),
    image("I10", "eight processes, one image", sh("for i in 1 2 3 4 5 6 7 8; do $R & done; wait"), writes="x.png"),
    image("I11", "the output is the scene", sh("cp scene.lua s.png; $P s.png -q -o s.png; c=$?; cmp scene.lua s.png || exit 99; exit $c"), code=2, says="error: .*s.png"),
    image("I11", "the output is a texture", sh("$R -o t.png; cp t.png u.png; printf '%s' \"$(cat scene.lua | sed 's/white)/nil, gr.texture(\"t.png\", {0,0,0}, 0))/')\" > t.lua; "
          "$P t.lua -q -o ./t.png; c=$?; cmp t.png u.png || exit 99; exit $c"), code=2, says="error: .*t.png"),
    image("I11", "the output is a link to a texture", sh("$R -o t.png; cp t.png u.png; ln -s t.png l.png; printf '%s' \"$(cat scene.lua | sed 's/white)/nil, gr.texture(\"t.png\", {0,0,0}, 0))/')\" > t.lua; "
          "$P t.lua -q -o l.png; c=$?; cmp t.png u.png || exit 99; exit $c"), code=2, says="error: .*l.png"),
    image("I12", "a name of 255 bytes", sh("$R -o " + "n" * 251 + ".png"), writes="n" * 251 + ".png"),
    image("I12", "a name of 256 bytes", sh("$R -o " + "n" * 252 + ".png"), code=3, says="error: .*too long"),
    *[image("I14", "a size that %s cannot hold" % kind, sh("$R -o y.%s --size 65000x30000 --max-pixels 9000000000" % kind), code=3, says="error: ", seconds=5) for kind in ("png", "tif")],
    image("I13 D20", "a format that nobody knows", sh("$R -o y.jpg"), code=3, says="error: .*jpg", seconds=5),
    image("I15", "an image to a terminal", sh("script -qec \"$R -o -\" /dev/null < /dev/null; exit $?"), code={2}, prints="terminal", says=()),
    image("I16", "the older mode is kept", sh("chmod 640 x.png && $R && [ $(stat -c %a x.png) = 640 ]"), writes="x.png"),
    image("I16", "a new file's mode", sh("rm x.png; umask 027; $R && [ $(stat -c %a x.png) = 640 ]"), writes="x.png"),
    image("I18", "equal renders are equal files", sh("$R -o a.png && sleep 1.1 && $R -o b.png && cmp a.png b.png")),
    image("I9", "--stats into /dev/full", sh("$R --stats /dev/full"), code={3}, says="error: .*/dev/full", old=False),
]
