"""What a case is, how one is run, and what holds for all of them."""
import os, re, resource, shutil, signal, stat, struct, subprocess, tempfile, time, zlib

LIMIT = 30.0
OLD = b"an older image, which no failure may cost"
KNOWN_CODES = {0, 1, 2, 3, 4, 10, 129, 130, 143}
SANITIZER = re.compile(rb"(Address|Leak|Thread|UndefinedBehavior)Sanitizer|runtime error:")
MESSAGE = re.compile(r"^(.+: )?(error|warning): .", re.MULTILINE)

ROOT = "root = gr.node('root') white = gr.material({1,1,1}, {0,0,0}, 0)\n"
SHOT = ("\ngr.render(root, 'x.png', 8, 6, {0,0,5}, {0,0,-1}, {0,1,0}, 50, {0.3,0.3,0.3},"
        " {gr.light({3,5,9}, {0.7,0.7,0.7}, {1,0,0})})\n")
BALL = ROOT + "root:add_child(gr.sphere('ball'), white)" + SHOT
# Long enough to be met in the middle of rendering on any machine.
SLOW = BALL.replace("8, 6", "400, 300") + "\n"


def shot(body):
    """A scene around `body`, whose first line is the script's second."""
    return ROOT + body + SHOT


def meshed(obj, name="m.obj"):
    return {"script": shot("root:add_child(gr.mesh('m', '%s'), white)" % name), "files": {name: obj}}


def textured(png, name="t.png"):
    return {"script": shot("root:add_child(gr.sphere('s'), nil, gr.texture('%s', {0,0,0}, 0))" % name),
            "files": {name: png}}


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png(width, height, depth=8, kind=2, rows=None, interlaced=0, palette=b""):
    """A PNG of zeros, or of `rows`, filter bytes included."""
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[kind]
    if rows is None:
        rows = (b"\0" + bytes((width * channels * depth + 7) // 8)) * height
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, interlaced))
            + (chunk(b"PLTE", palette) if palette else b"") + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def is_sanitized(project):
    with open(project, "rb") as f:
        return b"__asan_init" in f.read()


class Skip(Exception):
    """Why a case cannot be tried here."""


class Run:
    """What came of one run of the program."""

    def __init__(self, folder, code, out, err, seconds):
        self.folder, self.code, self.out, self.seconds = folder, code, out, seconds
        self.errors = err.decode(errors="replace")

    def read(self, name):
        with open(os.path.join(self.folder, name), "rb") as f:
            return f.read()


class Case:
    """One line of a table.

    ids: the cases of the contract that it covers; script: becomes scene.lua; files: name -> bytes, text or
    a function that makes it, given the path; args; code: exit code, or a set of them; says: patterns that
    stderr must have; never: patterns that it must not have; prints: a pattern for stdout, which is empty
    otherwise; output: what the run would write, an older file there by default; old: whether there is one;
    also: further checks, given the Run; limits: for setrlimit; heavy: not under sanitizers, whose memory
    is another.
    """

    def __init__(self, ids, name, script=None, args=("scene.lua", "-q", "--spp", "1"), code=0, says=(), never=(),
                 files=None, prints=None, output="x.png", old=True, also=None, env=None, stdin=b"", limits=(),
                 seconds=LIMIT, heavy=False, command=None, writes=None):
        self.ids, self.name, self.script, self.args = ids.split(), name, script, list(args)
        self.codes = code if isinstance(code, set) else {code}
        self.says = [says] if isinstance(says, str) else list(says)
        self.never = [never] if isinstance(never, str) else list(never)
        self.files, self.prints, self.output, self.old = files or {}, prints, output, old
        self.also, self.env, self.stdin, self.limits = also, env, stdin, limits
        self.seconds, self.heavy, self.command, self.writes = seconds, heavy, command, writes


def put(folder, name, content):
    path = os.path.join(os.fsencode(folder), os.fsencode(name))
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if callable(content):
        return content(path)
    with open(path, "wb") as f:
        f.write(content if isinstance(content, bytes) else content.encode())


def whole_image(data):
    return data.endswith(chunk(b"IEND", b"")) if data.startswith(b"\x89PNG") else data[:2] in (b"PF", b"II", b"v/", b"#?")


def leftovers(folder):
    return [name for _, _, names in os.walk(folder) for name in names if ".tmp-" in name]


def always(case, run):
    """What holds for every case. -> complaints"""
    if run.code < 0:
        yield "died of signal %d" % -run.code
    elif run.code not in KNOWN_CODES:
        yield "exit code %d, which the contract does not have" % run.code
    if SANITIZER.search(run.errors.encode()):
        yield "a sanitizer spoke"
    if run.code in (1, 2, 3, 4) and not MESSAGE.search(run.errors + (run.out.decode(errors="replace") if case.prints else "")):
        yield "failed without a message of the common form"
    if len(run.errors) > 64 * 1024:
        yield "%d bytes of messages" % len(run.errors)
    if re.search(r"[\x00-\x08\x0b-\x1f\x7f]", run.errors.replace("\r", "")):
        yield "control characters in a message"
    if case.prints is None and run.out:
        yield "stdout has %r" % run.out[:100]
    if leftovers(run.folder):
        yield "left behind: %s" % leftovers(run.folder)
    path = os.path.join(run.folder, case.output)
    if os.path.isfile(path):
        data = run.read(case.output)
        # A script that fails late, a warning under --werror and a signal at the end come after a whole image.
        if run.code in (2, 3, 4) and case.old and data != OLD:
            yield "the older image is gone"
        if data != OLD and not whole_image(data):
            yield "half an image under the final name"
    elif case.old:
        yield "the older image was removed"


def expected(case, run):
    if run.code not in case.codes:
        yield "exit code %d instead of %s" % (run.code, sorted(case.codes))
    for pattern in case.says:
        if not re.search(pattern, run.errors):
            yield "does not say %r" % pattern
    for pattern in case.never:
        if re.search(pattern, run.errors):
            yield "says %r" % pattern
    if case.prints is not None and not re.search(case.prints, run.out.decode(errors="replace")):
        yield "stdout has %r, not %r" % (run.out[:100], case.prints)
    if case.writes and not (os.path.isfile(os.path.join(run.folder, case.writes))
                            and whole_image(run.read(case.writes))):
        yield "no image %s" % case.writes
    if case.also:
        yield from case.also(run) or ()


def execute(project, case, folder):
    put(folder, "keep", b"")
    if case.script is not None:
        put(folder, "scene.lua", case.script)
    if case.old:
        put(folder, case.output, OLD)
    for name, content in case.files.items():
        put(folder, name, content)

    def limited():
        for kind, value in case.limits:
            resource.setrlimit(kind, (value, value))

    command = [project, *case.args] if case.command is None else case.command(project, folder)
    began = time.monotonic()
    child = subprocess.Popen(command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             env=case.env if case.env is not None else None, preexec_fn=limited, start_new_session=True)
    try:
        out, err = child.communicate(case.stdin, timeout=case.seconds)
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, signal.SIGKILL)
        out, err = child.communicate()
        return Run(folder, None, out, err, time.monotonic() - began)
    return Run(folder, child.returncode, out, err, time.monotonic() - began)


def complaints(project, case):
    """-> what is wrong, and the run"""
    outside = tempfile.mkdtemp(prefix="rt-faults-")
    folder = os.path.join(outside, "inside")
    os.mkdir(folder)
    try:
        run = execute(project, case, folder)
        if run.code is None:
            return ["did not end within %g s" % case.seconds], run
        return [*always(case, run), *expected(case, run)], run
    finally:
        shutil.rmtree(outside, ignore_errors=True)
