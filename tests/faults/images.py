"""G: textures."""
import os, struct

from harness import BALL, Case, ROOT, SHOT, chunk, png, shot, textured
from loading import fifo

IHDR = 8 + 25


def damaged(at, by=1):
    data = bytearray(png(4, 4))
    data[at] ^= by
    return bytes(data)


def good(ids, name, content, says=(), file="t.png", **more):
    return Case(ids, name, says=says, never=() if says else "warning", writes="x.png", **textured(content, file), **more)


def bad(ids, name, content, says, code=1, file="t.png", **more):
    return Case(ids, name, code=code, says=says, **textured(content, file), **more)



CASES = [
    Case("G1", "missing", shot("root:add_child(gr.sphere('s'), nil, gr.texture('nothing.png', {0,0,0}, 0))"), code=1,
         says=r"scene\.lua:2: error: .*nothing\.png"),
    bad("G2", "truncated", png(40, 40)[:60], [r"t\.png", r"scene\.lua:2"]),
    bad("G2", "cut after the header", png(40, 40)[:IHDR], r"t\.png"),
    bad("G2", "bad CRC", damaged(IHDR - 1), r"t\.png.*CRC"),
    bad("G2", "bad zlib", damaged(IHDR + 8), r"t\.png"),
    bad("G2", "rows missing", png(40, 40, rows=b"\0" * 50), r"t\.png"),
    bad("G2", "empty", b"", r"t\.png"),
    bad("G2", "magic alone", b"\x89PNG\r\n\x1a\n", r"t\.png"),
    bad("G3", "10^5 x 10^5", png(100000, 100000, rows=b"\0" * 100000), ["--max-pixels", "100000"], code=4, seconds=5),
    bad("G3", "2^31 x 2^31", png(2**31 - 1, 2**31 - 1, rows=b"\0" * 100), "--max-pixels|t.png", code={1, 4}, seconds=5),
    bad("G3", "a zlib bomb behind a small size", png(4, 4, rows=b"\0" * (1 << 28)), r"t\.png", code={0, 1, 4}, seconds=15),
    bad("G4", "0 x 0", png(0, 0, rows=b""), r"t\.png"),
    good("G4", "1 x 1", png(1, 1)),
    good("G4", "1 x 65536", png(1, 65536)),
    *[good("G5", "%d bits, kind %d" % (depth, kind), png(5, 5, depth, kind)) for depth, kind in ((1, 0), (2, 0), (4, 0), (16, 0), (16, 2), (8, 4), (16, 6), (8, 6))],
    good("G5", "palette", png(5, 5, 2, 3, palette=bytes(12))),
    bad("G5", "palette missing", png(5, 5, 2, 3), r"t\.png", code={0, 1}),
    bad("G5", "interlaced, rows missing", png(5, 5, interlaced=1), r"t\.png", code={0, 1}),
    bad("G5", "3 bits", png(5, 5, 3, 2), r"t\.png"),
    good("G7", "a PNG named .jpg", png(4, 4), "warning: .*PNG", file="t.jpg"),
    *[bad("G8", kind, content, r"t\.%s" % kind, file="t." + kind) for kind, content in (("psd", b"8BPS\0\1" + bytes(100)), ("gif", b"GIF89a" + bytes(50)),
      ("svg", b"<svg xmlns='x'/>"), ("mp4", b"\0\0\0\x20ftypisom" + bytes(50)), ("webp", b"RIFF\x20\0\0\0WEBPVP8 " + bytes(30)))],
    *[Case("G9", name, shot("root:add_child(gr.sphere('s'), nil, gr.texture('%s', {0,0,0}, 0))" % name), code=1, says="error: ")
      for name in ("http://localhost/x.png", "/dev/null", "/dev/zero", "nul", "/proc/self/mem", "")],
    Case("G9", "a FIFO", shot("root:add_child(gr.sphere('s'), nil, gr.texture('p.png', {0,0,0}, 0))"), code=1, says="pipe|regular", files={"p.png": fifo}),
    *[bad("G5 G2", "broken " + kind, magic + bytes(range(200)), r"t\.%s" % kind, file="t." + kind) for kind, magic in (
        ("jpg", b"\xff\xd8\xff\xe0"), ("exr", b"\x76\x2f\x31\x01"), ("tif", b"II*\0"), ("bmp", b"BM"), ("hdr", b"#?RADIANCE\n"))],
    Case("G11", "2,000 textures and 64 files", shot("for i = 1, 2000 do root:add_child(gr.sphere('s'), nil, gr.texture('t' .. i .. '.png', {0,0,0}, 0)) end"),
         writes="x.png", files={"t%d.png" % (i + 1): png(2, 2) for i in range(2000)}, limits=[(7, 64)], seconds=60),
    Case("G13", "uv of 1e30", shot("root:add_child(gr.mesh('m', 'm.obj'), nil, gr.texture('t.png', {0,0,0}, 0))"), writes="x.png", never="finite",
         files={"t.png": png(4, 4), "m.obj": "v -2 -2 0\nv 2 -2 0\nv 0 2 0\nvt 1e30 -1e30\nvt 0 1e300\nvt 1 1\nf 1/1 2/2 3/3\n"}),
]
