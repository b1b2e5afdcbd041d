"""F: OBJ files."""
import os

from harness import BALL, Case, ROOT, SHOT, meshed, png, shot
from loading import fifo, grown, link

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def bad(ids, name, obj, says, code=1, **more):
    return Case(ids, name, code=code, says=says, **meshed(obj), **more)


def good(ids, name, obj, says=(), **more):
    return Case(ids, name, says=says, never=() if says else "warning", writes="x.png", **meshed(obj), **more)


def missing(run):
    if not run.errors.startswith("scene.lua:2: error: "):
        yield "the script's line is not named"


def round_polygon(count):
    import math
    corners = "".join("v %.9f %.9f 0\n" % (math.cos(6.283185307 * i / count), math.sin(6.283185307 * i / count)) for i in range(count))
    return corners + "f " + " ".join(str(i + 1) for i in range(count)) + "\n"


CASES = [
    Case("F1", "missing", shot("root:add_child(gr.mesh('m', 'nothing.obj'), white)"), code=1, says="nothing.obj", also=missing),
    Case("F1", "a folder", shot("root:add_child(gr.mesh('m', 'd.obj'), white)"), code=1, says=r"d\.obj", files={"d.obj/x": b""}),
    Case("F1", "a FIFO", shot("root:add_child(gr.mesh('m', 'p.obj'), white)"), code=1, says=r"p\.obj.*pipe|regular", files={"p.obj": fifo}),
    *[bad("F2", name, obj, r"m\.obj: warning: .*no faces", code=0) for name, obj in (("empty", ""), ("comments", "# nothing\n"), ("no faces", TRIANGLE))],
    bad("F3", "index out of range", TRIANGLE + "f 1 2 9\n", [r"m\.obj:4: error: .*vertex 9 of 3", r"scene\.lua:2"]),
    bad("F4", "index 0", TRIANGLE + "f 0 1 2\n", r"m\.obj:4: error: "),
    good("F4", "negative indices", TRIANGLE + "f -3 -2 -1\n"),
    bad("F4", "negative index too far", TRIANGLE + "f -4 -2 -1\n", r"m\.obj:4: error: "),
    *[bad("F5", "index " + i, TRIANGLE + "f 1 2 %s\n" % i, r"m\.obj:4: error: ") for i in
      ("2147483648", "4294967297", "4294967299", "18446744073709551619", "1e30", "1.5", "x", "-2147483648", "-9223372036854775808", "1/", "1//", "/1")],
    good("F6", "one and two vertices", TRIANGLE + "f 1\nf 1 2\nf 1 2 3\n", "warning: "),
    good("F6", "five vertices", "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv -1 1 0\nf 1 2 3 4 5\n"),
    good("F6", "concave", "v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nf 1 2 3 4\n"),
    good("F6", "20,000 vertices", round_polygon(20000)),
    good("F7", "every form of index", TRIANGLE + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 3//1\nf 1/1 2/1 3/1\nf 1 2/1 3//1\n"),
    bad("F7", "vt out of range", TRIANGLE + "vt 0 0\nf 1/2 2/1 3/1\n", r"m\.obj:5: error: "),
    bad("F7", "vn out of range", TRIANGLE + "vn 0 0 1\nf 1//1 2//1 3//7\n", r"m\.obj:5: error: "),
    *[bad("F8", "coordinate " + c, "v 0 0 0\nv 1 0 %s\nv 0 1 0\nf 1 2 3\n" % c, r"m\.obj:2: error: ") for c in ("nan", "inf", "-inf", "1e999", "0x1p3", "0,5", "1..2", "--1", "")],
    good("F9", "degenerate triangles", TRIANGLE + "f 1 1 2\nf 1 2 3\nv 2 0 0\nf 1 2 4\n", "warning: .*2"),
    good("F10", "normals of length zero", TRIANGLE + "vn 0 0 0\nf 1//1 2//1 3//1\n", "warning: .*normal"),
    good("F11", "a line of 10 MB", TRIANGLE + "# " + "x" * 10000000 + "\nf 1 2 3\n"),
    good("F11", "no newline at the end", TRIANGLE + "f 1 2 3"),
    good("F11", "CR alone", (TRIANGLE + "f 1 2 3\n").replace("\n", "\r")),
    good("F11", "continuation", TRIANGLE + "f 1 \\\n 2 \\\r\n 3\n"),
    bad("F11", "NUL", TRIANGLE.encode() + b"f 1 2\0 3\n", r"m\.obj"),
    bad("F12", "cut off in a face", TRIANGLE + "f 1 2/", r"m\.obj:4: error: "),
    bad("F12", "cut off in a vertex", TRIANGLE + "f 1 2 3\nv 1 2", r"m\.obj:5: error: "),
    *[bad("F13", name, content, "not an OBJ") for name, content in (("binary STL", bytes(80) + b"\x0c\0\0\0" + bytes(range(250))),
      ("gzip", b"\x1f\x8b\x08\0\0\0\0\0\0\3" + bytes(range(200))), ("ELF", b"\x7fELF\2\1\1" + bytes(300)))],
    good("F14", "mtllib and usemtl", "mtllib none.mtl\nusemtl gold\n" + TRIANGLE + "f 1 2 3\n", "warning: "),
    bad("F15", "5 GB, sparse", lambda path: grown(path, 5 << 30), [r"m\.obj", "GiB"], code={1, 4}, seconds=10),
    bad("F15", "5 GB that begin as an OBJ", lambda path: sparse(path, 5 << 30), [r"m\.obj", "GiB"], code=4, seconds=10),
    Case("F15", "a height field of 25 million heights", shot("root:add_child(gr.height_field('h', 't.png'), white)"), code=4,
         says=r"scene\.lua:2: error: gr\.height_field: 5000x5000 heights; 16777216 are the most", files={"t.png": png(5000, 5000, 8, 0)}, seconds=20),
    Case("F15", "a height field by a function, of more memory than a script may use",
         shot("root:add_child(gr.height_field('h', function() return 0 end, {resolution = 4096}), white)"), code=4, says="script-memory",
         args=("scene.lua", "-q", "--script-memory", "64M")),
    Case("F1", "heights from a missing image", shot("root:add_child(gr.height_field('h', 'nothing.png'), white)"), code=1, says="nothing.png", also=missing),
    Case("F18", "heights that are all alike", shot("root:add_child(gr.height_field('h', {{0, 0}, {0, 0}}), white) "
         "root:add_child(gr.height_field('g', {{0, 0}, {0, 0}}, {base = -1}), white)"), writes="x.png", never="warning"),
    Case("F18", "a base within the heights", shot("root:add_child(gr.height_field('h', {{0, 1}, {1, 1}}, {base = 0.5}), white)"), code=1,
         says=r"scene\.lua:2: error: gr\.height_field: base must lie below all heights, of which the lowest is 0 \(got 0\.5\)"),
    good("F16", "mtllib upwards", "mtllib ../../etc/passwd\n" + TRIANGLE + "f 1 2 3\n", "warning: ", ),
    Case("F16", "a mesh upwards", shot("root:add_child(gr.mesh('m', '../../../../../../etc/passwd.obj'), white)"), code=1, says="error: ", never="root:"),
    Case("F16", "a texture that is /etc/shadow", shot("root:add_child(gr.sphere('s'), nil, gr.texture('/etc/shadow', {0,0,0}, 0))"), code=1, says="error: "),
    Case("F17", "one mesh 100,000 times", shot("for i = 1, 100000 do root:add_child(gr.mesh('m', 'm.obj'), white) end"), writes="x.png", seconds=60,
         files={"m.obj": TRIANGLE + "f 1 2 3\n"}),
    good("F18", "flat", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"),
    good("F18", "all vertices equal", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "warning: "),
    Case("F19", "read once", shot("local m = gr.mesh('m', 'm.obj') root:add_child(m, white)") + SHOT, writes="x.png",
         files={"m.obj": TRIANGLE + "f 1 2 3\n"}),
]


def sparse(path, size):
    with open(path, "wb") as f:
        f.write((TRIANGLE + "f 1 2 3\n").encode())
        f.truncate(size)
