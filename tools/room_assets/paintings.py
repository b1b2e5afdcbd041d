"""Pictures in the room: the view from the window, two sliding doors, a scroll, a paper strip, book spines."""
import math

from fields import clamp, fractal, hash01, mix, noise, ramp, scaled, smoothstep, write

TAU = 2 * math.pi


def puffs(seed, base_y, centre, spread, height, count):
    """Balls (x, y, radius) that make a heap of cloud: small and many at its outline, large within."""
    balls = []
    for k in range(count):
        t = hash01(k, 1, seed)
        x = 2 * hash01(k, 2, seed) - 1
        x = x * abs(x) ** 0.3
        top = height * (1 - x * x) ** 0.8 * (0.72 + 0.28 * math.sin(7.3 * x + seed))
        y = base_y + top * t ** 0.6
        r = (0.030 + 0.055 * hash01(k, 3, seed)) * (1.25 - 0.7 * t) * (1.1 - 0.5 * abs(x))
        balls.append((centre + spread * x, y, r))
    return balls


def paint_puffs(canvas, w, h, balls, wander, detail, lit, shade, sun):
    """Shades the balls as a height field, the higher the nearer, with edges that noise frays."""
    near = {}
    for bx, by, r in balls:
        for y in range(max(0, int((1 - by - 1.2 * r) * h)), min(h, int((1 - by + 1.2 * r) * h) + 1)):
            for x in range(max(0, int((bx - 1.2 * r) * h)), min(w, int((bx + 1.2 * r) * h) + 1)):
                px = ((x + 0.5) / h - bx) / r + 0.9 * (wander[y][x] - 0.5) + 0.5 * (detail[y][x] - 0.5)
                py = (1 - (y + 0.5) / h - by) / r + 0.9 * (wander[y][(x + 97) % w] - 0.5)
                d2 = px * px + py * py
                if d2 < 1:
                    z = math.sqrt(1 - d2)
                    key = z * r - 0.25 * by
                    old = near.get((x, y))
                    if old is None or key > old[0]:
                        near[(x, y)] = (key, px * sun[0] + py * sun[1] + z * sun[2], z, by)
    for (x, y), (_, light, z, by) in near.items():
        t = clamp(0.42 + 0.55 * light + 0.5 * (detail[y][x] - 0.5))
        colour = ramp(((0, shade), (0.45, mix(shade, lit, 0.45)), (0.8, lit), (1, (1.0, 0.985, 0.95))), t)
        canvas[y][x] = mix(canvas[y][x], colour, smoothstep(0, 0.35, z))


def view():
    """Late summer afternoon: a heap of cloud over blue hills and the sea."""
    w, h = 1024, 768
    wander, detail = fractal(w, h, 12, 9, 4, 901), fractal(w, h, 40, 30, 4, 911)
    canvas = []
    for y in range(h):
        v = 1 - (y + 0.5) / h
        canvas.append([ramp(((0.25, (0.98, 0.88, 0.74)), (0.36, (0.80, 0.88, 0.90)), (0.55, (0.47, 0.70, 0.88)),
                             (1, (0.17, 0.42, 0.74))), v + 0.02 * (wander[y][x] - 0.5)) for x in range(w)])
    sun = (0.62, 0.50, 0.60)
    lit, shade = (0.99, 0.95, 0.87), (0.58, 0.64, 0.80)
    paint_puffs(canvas, w, h, puffs(921, 0.33, 0.34, 0.30, 0.26, 120), wander, detail, mix(lit, (0.8, 0.88, 0.92), 0.4),
                mix(shade, (0.75, 0.85, 0.92), 0.4), sun)
    paint_puffs(canvas, w, h, puffs(922, 0.34, 0.70, 0.40, 0.50, 360), wander, detail, lit, shade, sun)
    for y in range(h):
        v = 1 - (y + 0.5) / h
        haze = smoothstep(0.42, 0.29, v)
        for x in range(w):
            canvas[y][x] = mix(canvas[y][x], (0.95, 0.90, 0.82), 0.75 * haze)
    for k, (base, rise, colour, cells) in enumerate(((0.30, 0.10, (0.62, 0.73, 0.82), 3), (0.265, 0.085, (0.43, 0.58, 0.68), 5),
                                                     (0.10, 0.13, (0.22, 0.40, 0.34), 8))):
        ridge = fractal(w, 1, cells, 1, 1, 931 + k)[0]
        fine = fractal(w, 64, cells * 4, 2, 5, 941 + k)[9]
        for x in range(w):
            top = base + rise * (ridge[x] - 0.35) + 0.035 * (fine[x] - 0.5)
            for y in range(h):
                v = 1 - (y + 0.5) / h
                if v < top:
                    c = mix(colour, (0.80, 0.84, 0.82), 0.45 * smoothstep(0.08, 0.0, v - top + 0.16) if k < 2 else 0)
                    edge = smoothstep(0, 0.003, top - v)
                    c = scaled(c, 0.86 + 0.28 * detail[y][x])
                    if k < 2 and v < 0.235:
                        glitter = detail[(y * 5) % h][(x + 40 * (y % 2)) % w] - 0.5
                        c = mix((0.36, 0.60, 0.74), (0.95, 0.93, 0.84), clamp(0.2 + 1.4 * glitter))
                    canvas[y][x] = mix(canvas[y][x], c, edge)
    write("Texture", "room_view.png", w, h, lambda x, y: canvas[y][x])


def ink_ridges(u, v, ridges, mist):
    """Washes of ink: each ridge dark at its crest, lost in mist at its foot."""
    ink = 0.0
    for base, line, depth, strength in ridges:
        below = base + line[int(u * 512) % 1024] - v
        if below > 0:
            ink = max(ink * (1 - smoothstep(0, 0.004, below)), strength * math.exp(-below / depth)) if below < 0.004 else strength * math.exp(-below / depth)
    return ink * (0.75 + 0.5 * (mist - 0.5))


def pine(u, v, x, y, size):
    """A pine of ink: a leaning trunk with flat tufts; 0 to 1."""
    px, py = (u - x) / size, (v - y) / size
    trunk = abs(px - 0.10 * math.sin(2.2 * py)) < 0.028 * (1.2 - py) and 0 < py < 1
    if trunk:
        return 0.9
    for k in range(7):
        ty = 0.35 + 0.11 * k
        tx = 0.10 * math.sin(2.2 * ty) + (0.30 - 0.03 * k) * (1 if k % 2 else -1) * 0.75
        d = math.hypot((px - tx) / (0.27 - 0.022 * k), (py - ty) / 0.055)
        if d < 1:
            return 0.9 - 0.45 * d
    return 0.0


def fusuma():
    """Two doors, one picture: hills of ink in gold mist, pines, a red sun."""
    w, h = 512, 1024
    mist = fractal(w * 2, h, 4, 4, 5, 951)
    paper = fractal(w * 2, h, 64, 64, 3, 961)
    lines = []
    for k in range(4):
        broad, fine = fractal(1024, 64, 3 + k, 1, 2, 970 + k)[5], fractal(1024, 64, 24, 2, 4, 980 + k)[5]
        lines.append([0.34 * (a - 0.4) + 0.06 * (b - 0.5) for a, b in zip(broad, fine)])
    ridges = ((0.66, lines[0], 0.10, 0.35), (0.55, lines[1], 0.09, 0.50), (0.41, lines[2], 0.08, 0.68), (0.22, lines[3], 0.10, 0.85))

    def pixel_at(offset):
        def pixel(x, y):
            gx = x + offset
            u, v = (gx + 0.5) / w, 1 - (y + 0.5) / h
            leaf = 0.04 * (hash01(int(u * 6), int(v * 12), 991) - 0.5)
            seam = min(abs((u * 6) % 1 - 0.5), abs((v * 12) % 1 - 0.5))
            gold = mix((0.74, 0.58, 0.30), (0.90, 0.78, 0.50), clamp(mist[y][gx] + leaf + 0.3 * (paper[y][gx] - 0.5)))
            gold = scaled(gold, 1 - 0.06 * smoothstep(0.485, 0.5, 0.5 - seam + 0.0))
            sun = smoothstep(0.135, 0.130, math.hypot(u - 1.36, (v - 0.80) * 2))
            c = mix(gold, (0.72, 0.22, 0.14), 0.85 * sun)
            ink = ink_ridges(u, v, ridges, mist[y][gx])
            for px, py, size in ((0.36, 0.13, 0.30), (0.58, 0.10, 0.22), (1.55, 0.16, 0.26), (1.22, 0.09, 0.18)):
                ink = max(ink, pine(u, v * 2, px, py * 2, size * 1.6))
            return mix(c, (0.10, 0.12, 0.13), clamp(ink))
        return pixel

    write("Texture", "room_fusuma_left.png", w, h, pixel_at(0))
    write("Texture", "room_fusuma_right.png", w, h, pixel_at(w))


def scroll():
    """A hanging scroll: one circle in one stroke of a brush, and a seal."""
    w, h = 512, 1024
    silk = fractal(w, h, 128, 256, 2, 1001)
    cloud = fractal(w, h, 4, 8, 4, 1011)
    bristle = fractal(512, 64, 4, 24, 3, 1021, 0.8)

    def pixel(x, y):
        u, v = (x + 0.5) / w, 2 * (1 - (y + 0.5) / h)
        if not (0.10 < u < 0.90 and 0.34 < v < 1.70):
            brocade = 0.5 + 0.5 * math.cos(TAU * 9 * u) * math.cos(TAU * 9 * v)
            edge = min(abs(u - 0.10), abs(u - 0.90)) < 0.012 and 0.33 < v < 1.71 or min(abs(v - 0.34), abs(v - 1.70)) < 0.012
            c = mix((0.20, 0.29, 0.27), (0.33, 0.42, 0.36), brocade * silk[y][x] * 1.4)
            return (0.70, 0.58, 0.32) if edge and 0.09 < u < 0.91 else c
        c = mix((0.86, 0.81, 0.68), (0.94, 0.91, 0.82), 0.6 * cloud[y][x] + 0.4 * silk[y][x])
        a = (math.atan2(v - 1.10, u - 0.5) + 2.2) % TAU / TAU
        r = math.hypot(u - 0.5, v - 1.10) + 0.012 * math.sin(TAU * a + 1)
        across = (r - 0.255) / (0.050 - 0.022 * a)
        if abs(across) < 1 and a < 0.965:
            dry = bristle[int((across + 1) * 31.5)][int(a * 380) % 512]
            ink = clamp(1.25 - 0.9 * smoothstep(0.30, 0.75, dry) * a * 1.9) * smoothstep(1.0, 0.82, abs(across))
            c = mix(c, (0.07, 0.07, 0.08), clamp(ink))
        if abs(u - 0.74) < 0.035 and abs(v - 0.52) < 0.04:
            c = mix((0.70, 0.16, 0.12), c, 0.9 if (abs(u - 0.74) < 0.022 and abs(v - 0.52) < 0.027 and int(u * 190) % 3 == 0) else 0.1)
        return c

    write("Texture", "room_scroll.png", w, h, pixel)


def strip():
    """The paper strip of the wind chime: blue waves under a red edge."""
    w, h = 128, 512
    cloud = fractal(w, h, 4, 16, 4, 1031)

    def pixel(x, y):
        u, v = (x + 0.5) / w, 1 - (y + 0.5) / h
        c = mix((0.90, 0.90, 0.84), (0.97, 0.97, 0.93), cloud[y][x])
        for k in range(5):
            crest = 0.08 + 0.07 * k + 0.02 * math.sin(TAU * (u * 1.5 + 0.37 * k))
            if v < crest and v > crest - 0.035:
                c = mix((0.16, 0.36, 0.66), (0.55, 0.74, 0.86), (crest - v) / 0.035)
        return mix(c, (0.75, 0.22, 0.18), 1 - smoothstep(0.015, 0.02, 1 - v))

    write("Texture", "room_strip.png", w, h, pixel)


def books():
    """Spines, eleven of them, in a row."""
    w, h = 512, 256
    grain = fractal(w, h, 64, 32, 3, 1041)
    edges, x = [], 0.0
    while x < 0.97:
        edges.append(x)
        x += 0.06 + 0.06 * hash01(len(edges), 1, 1051)
    colours = ((0.33, 0.14, 0.12), (0.16, 0.24, 0.33), (0.62, 0.54, 0.36), (0.21, 0.30, 0.22), (0.72, 0.67, 0.56),
               (0.48, 0.30, 0.14), (0.25, 0.18, 0.28))

    def pixel(x, y):
        u, v = (x + 0.5) / w, 1 - (y + 0.5) / h
        k = max(i for i, e in enumerate(edges) if e <= u)
        right = edges[k + 1] if k + 1 < len(edges) else 1.0
        t = (u - edges[k]) / (right - edges[k])
        c = scaled(colours[int(hash01(k, 2, 1051) * 7)], 0.8 + 0.4 * grain[y][x])
        label = abs(t - 0.5) < 0.28 and 0.52 < v < 0.86
        if label:
            c = mix(c, (0.86, 0.82, 0.70), 0.9)
            if abs(t - 0.5) < 0.14 and hash01(int(v * 64), k * 4 + int(t * 12), 1061) < 0.55:
                c = scaled(c, 0.35)
        return scaled(c, math.sqrt(max(0.0, 1 - (1.85 * (t - 0.5)) ** 2)))

    write("Texture", "room_books.png", w, h, pixel)


def kokeshi():
    """A turned doll: u round, v up; rings and a chrysanthemum on the body."""
    w, h = 512, 256
    grain = fractal(w, h, 6, 48, 3, 1071)

    def pixel(x, y):
        u, v = (x + 0.5) / w, 1 - (y + 0.5) / h
        c = mix((0.80, 0.64, 0.42), (0.90, 0.76, 0.55), grain[y][x])
        for low, high, colour in ((0.03, 0.10, (0.62, 0.12, 0.10)), (0.12, 0.14, (0.14, 0.22, 0.16)), (0.84, 0.92, (0.62, 0.12, 0.10)),
                                  (0.80, 0.82, (0.14, 0.22, 0.16))):
            if low < v < high:
                c = colour
        px, py = (u - 0.5) * 4, (v - 0.47) * 2.6
        d, a = math.hypot(px, py), math.atan2(py, px)
        if d < 0.62 and abs(math.cos(6 * a)) > 0.35 + 0.5 * abs(d - 0.36):
            c = (0.70, 0.15, 0.12) if d > 0.12 else (0.86, 0.66, 0.20)
        return c

    write("Texture", "room_kokeshi.png", w, h, pixel)


def kokeshi_face():
    """The doll's head, longitude and latitude: black hair, two brows, eyes like the moon, a small mouth."""
    w, h = 512, 256

    def pixel(x, y):
        a, b = TAU * ((x + 0.5) / w - 0.5), math.pi * (0.5 - (y + 0.5) / h)
        px, py = math.sin(a) * math.cos(b), math.sin(b)
        front = math.cos(a) * math.cos(b) > 0
        fringe = 0.42 + 0.05 * math.cos(9 * px)
        if not front or py > fringe or abs(px) > 0.80:
            return (0.06, 0.05, 0.06)
        c = (0.88, 0.74, 0.56)
        for side in (-1, 1):
            ex = (px - 0.32 * side)
            brow = abs(py - 0.20 + 1.3 * ex * ex) < 0.017 and abs(ex) < 0.17
            lid = abs(py - 0.04 + 2.6 * ex * ex) < 0.024 and abs(ex) < 0.15
            if brow or lid or math.hypot(ex, py + 0.01) < 0.042:
                return (0.08, 0.06, 0.06)
            if math.hypot(px - 0.50 * side, (py + 0.24) * 1.2) < 0.13:
                c = mix(c, (0.85, 0.42, 0.34), 0.45)
        if abs(px) < 0.055 and abs(py + 0.42 - 3 * px * px) < 0.035:
            return (0.72, 0.16, 0.13)
        return c

    write("Texture", "room_kokeshi_face.png", w, h, pixel)


ALL = (view, fusuma, scroll, strip, books, kokeshi, kokeshi_face)
