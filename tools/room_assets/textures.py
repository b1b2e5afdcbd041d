"""Surfaces of the room: wood, straw, plaster, paper, cloth, iron, fur, and their bump maps."""
import math

from fields import clamp, fractal, hash01, mix, noise, ramp, scaled, smoothstep, write, write_normals

TAU = 2 * math.pi


# ---- wood ----------------------------------------------------------------------------------------------------

def wood_tone(w, h, rings, warp, seed):
    """0 (early wood) to 1 (late wood) of a plain-sawn board whose grain runs along v."""
    bend = fractal(w, h, 2, 1, 4, seed)
    fibre = fractal(w, h, 96, 3, 3, seed + 7, 0.7)
    cloud = fractal(w, h, 3, 2, 3, seed + 13)
    rows = []
    for y in range(h):
        b, f, c = bend[y], fibre[y], cloud[y]
        row = []
        for x in range(w):
            t = (abs(((x + 0.5) / w + 0.5) % 1 - 0.5) * 2 * rings + warp * b[x]) % 1
            ring = t * t * t * (1 - smoothstep(0.93, 1, t))
            row.append(clamp(0.55 * ring + 0.5 * (f[x] - 0.25) + 0.35 * (c[x] - 0.5)))
        rows.append(row)
    return rows


def wood(name, w, h, stops, rings, warp, seed):
    tone = wood_tone(w, h, rings, warp, seed)
    write("Texture", name, w, h, lambda x, y: ramp(stops, tone[y][x]))


def post_wood():
    wood("room_post.png", 256, 1024, [(0, (0.43, 0.27, 0.16)), (0.45, (0.33, 0.19, 0.11)), (1, (0.16, 0.09, 0.05))],
         6, 3.0, 11)


def tansu_wood():
    wood("room_tansu.png", 256, 1024, [(0, (0.47, 0.27, 0.15)), (0.4, (0.36, 0.19, 0.10)), (1, (0.15, 0.065, 0.035))],
         5, 5.0, 31)


def sill_wood():
    wood("room_cedar.png", 256, 1024, [(0, (0.78, 0.60, 0.40)), (0.4, (0.68, 0.48, 0.29)), (1, (0.44, 0.27, 0.14))],
         8, 3.0, 51)


def ceiling_wood():
    wood("room_ceiling.png", 256, 512, [(0, (0.55, 0.40, 0.26)), (0.5, (0.45, 0.31, 0.19)), (1, (0.28, 0.18, 0.10))],
         4, 4.0, 71)


def wood_bump():
    tone = wood_tone(256, 512, 6, 3.0, 11)
    write_normals("room_wood_normal.png", [[1 - 0.7 * t for t in row] for row in tone], 0.006)


# ---- straw ---------------------------------------------------------------------------------------------------

def tatami_height(size):
    """Rush along u, tied by threads along v: 48 rushes and 24 threads to a tile."""
    jitter = fractal(size, size, 8, 96, 2, 201)
    rows = []
    for y in range(size):
        v = (y + 0.5) / size * 48
        strand = math.sqrt(max(0.0, 1 - (2 * (v % 1) - 1) ** 2))
        odd = int(v) % 2
        row = []
        for x in range(size):
            u = (x + 0.5) / size * 24 + 0.5 * odd
            over = 0.55 + 0.45 * math.sin(TAU * u)
            row.append(clamp(0.8 * strand * over + 0.25 * jitter[y][x]))
        rows.append(row)
    return rows


def tatami():
    size = 512
    height = tatami_height(size)
    tint = fractal(size, size, 1, 48, 3, 211, 0.7)
    patch = fractal(size, size, 3, 3, 4, 221)
    stops = [(0, (0.66, 0.58, 0.34)), (0.5, (0.82, 0.73, 0.47)), (1, (0.94, 0.85, 0.60))]

    def pixel(x, y):
        t = 0.25 + 1.2 * (tint[y][x] - 0.5) + 0.55 * (patch[y][x] - 0.5) + 0.45 * height[y][x]
        return scaled(ramp(stops, clamp(t)), 0.80 + 0.24 * height[y][x])

    write("Texture", "room_tatami.png", size, size, pixel)
    write_normals("room_tatami_normal.png", height, 0.012)


# ---- walls and paper -----------------------------------------------------------------------------------------

def plaster():
    """Clay plaster with straw in it."""
    size = 512
    broad = fractal(size, size, 2, 2, 5, 301)
    sand = fractal(size, size, 128, 128, 2, 311)
    straws = {}
    for k in range(260):
        u, v, a = hash01(k, 1, 321), hash01(k, 2, 321), TAU * hash01(k, 3, 321)
        length, shade = 0.008 + 0.022 * hash01(k, 4, 321), 0.4 + 0.6 * hash01(k, 5, 321)
        for i in range(24):
            s = (i / 23 - 0.5) * length
            straws[(int((u + s * math.cos(a)) % 1 * size), int((v + s * math.sin(a)) % 1 * size))] = shade
    stops = [(0, (0.56, 0.49, 0.36)), (0.5, (0.70, 0.62, 0.47)), (1, (0.79, 0.72, 0.57))]

    def pixel(x, y):
        c = ramp(stops, clamp(0.5 + 1.1 * (broad[y][x] - 0.5) + 0.7 * (sand[y][x] - 0.5)))
        return mix(c, (0.85, 0.76, 0.52), 0.55 * straws.get((x, y), 0))

    write("Texture", "room_plaster.png", size, size, pixel)
    relief = [[0.5 * b + 0.42 * s + 0.2 * straws.get((x, y), 0) for x, (b, s) in enumerate(zip(p, q))]
              for y, (p, q) in enumerate(zip(broad, sand))]
    write_normals("room_plaster_normal.png", relief, 0.0024)


def washi():
    """Paper with long fibres; brighter towards the middle of a sheet is left to the light."""
    size = 512
    cloud = fractal(size, size, 4, 4, 5, 401)
    fibres = [[0.0] * size for _ in range(size)]
    for k in range(420):
        x, y, a = hash01(k, 1, 411), hash01(k, 2, 411), TAU * hash01(k, 3, 411)
        bend, depth = 0.12 * (hash01(k, 4, 411) - 0.5), 0.3 + 0.7 * hash01(k, 5, 411)
        for _ in range(int(40 + 90 * hash01(k, 6, 411))):
            fibres[int(y % 1 * size)][int(x % 1 * size)] = depth
            x, y, a = x + math.cos(a) / size, y + math.sin(a) / size, a + bend * 0.2
    write("Texture", "room_washi.png", size, size,
          lambda x, y: scaled(mix((0.90, 0.88, 0.81), (0.98, 0.97, 0.93), cloud[y][x]), 1 - 0.10 * fibres[y][x]))
    write_normals("room_washi_normal.png", [[0.5 * c + 0.5 * f for c, f in zip(p, q)] for p, q in zip(cloud, fibres)],
                  0.004)


# ---- cloth ---------------------------------------------------------------------------------------------------

def weave_height(size, threads, seed):
    slub = fractal(size, size, 32, 32, 2, seed)
    rows = []
    for y in range(size):
        v = (y + 0.5) / size * threads
        row = []
        for x in range(size):
            u = (x + 0.5) / size * threads
            a = abs(math.sin(math.pi * u)) if (int(u) + int(v)) % 2 else abs(math.sin(math.pi * v))
            row.append(0.7 * a + 0.3 * slub[y][x])
        rows.append(row)
    return rows


def segment_distance(px, py, ax, ay, bx, by):
    dx, dy = bx - ax, by - ay
    t = clamp(((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy))
    return math.hypot(px - ax - t * dx, py - ay - t * dy)


def asanoha_distance(x, y):
    """The distance to the lines of the hemp-leaf pattern, whose hexagons have unit triangles' sides."""
    h = math.sqrt(3) / 2
    row = math.floor(y / h)
    fy = y - row * h
    fx = (x - 0.5 * (row % 2)) % 1
    upright = fy < h * (1 - abs(2 * fx - 1))
    if not upright:
        fx, fy = (fx + 0.5) % 1, h - fy
    corners = ((0.0, 0.0), (1.0, 0.0), (0.5, h))
    centre = (0.5, h / 3)
    best = 9.0
    for i, (ax, ay) in enumerate(corners):
        bx, by = corners[(i + 1) % 3]
        best = min(best, segment_distance(fx, fy, ax, ay, bx, by), segment_distance(fx, fy, ax, ay, *centre))
    return best


def indigo():
    """Hemp leaves in white on indigo, on a plain weave."""
    w, h = 512, 887
    thread = weave_height(512, 128, 501)
    dye = fractal(w, h, 5, 9, 4, 511)

    def pixel(x, y):
        d = asanoha_distance((x + 0.5) / w * 4, (y + 0.5) / w * 4)
        line = 1 - smoothstep(0.016, 0.045, d + 0.02 * (dye[y][x] - 0.5))
        ground = mix((0.07, 0.12, 0.27), (0.15, 0.24, 0.44), dye[y][x])
        return scaled(mix(ground, (0.84, 0.85, 0.82), 0.88 * line), 0.80 + 0.22 * thread[y % 512][x])

    write("Texture", "room_indigo.png", w, h, pixel)
    write_normals("room_weave_normal.png", weave_height(256, 64, 501), 0.008)


def crimson():
    """Seven treasures: circles that overlap by a quarter, in gold thread on red."""
    size = 512
    thread = weave_height(size, 128, 521)
    dye = fractal(size, size, 4, 4, 4, 531)

    def pixel(x, y):
        u, v = (x + 0.5) / size * 6, (y + 0.5) / size * 6
        d = 9.0
        for ox, oy in ((0, 0), (1, 0), (0, 1), (1, 1), (0.5, 0.5)):
            d = min(d, abs(math.hypot(u % 1 - ox, v % 1 - oy) - 0.5))
        ground = mix((0.45, 0.08, 0.09), (0.62, 0.15, 0.12), dye[y][x])
        gold = mix((0.72, 0.52, 0.22), (0.88, 0.70, 0.36), thread[y][x])
        return scaled(mix(ground, gold, 1 - smoothstep(0.025, 0.055, d)), 0.80 + 0.22 * thread[y][x])

    write("Texture", "room_crimson.png", size, size, pixel)


def border():
    """The cloth border of a mat: black-green with a small woven lozenge."""
    w, h = 128, 256
    thread = weave_height(256, 64, 541)

    def pixel(x, y):
        u, v = (x + 0.5) / w, (y + 0.5) / h * 2
        d = abs(u - 0.5) + abs(v % 1 - 0.5) * 0.8
        gold = smoothstep(0.20, 0.17, abs(d - 0.22)) * smoothstep(0.05, 0.09, abs(d - 0.22)) if d < 0.4 else 0
        c = mix((0.08, 0.12, 0.10), (0.45, 0.38, 0.18), gold)
        return scaled(c, 0.7 + 0.4 * thread[y][x * 2 % 256])

    write("Texture", "room_border.png", w, h, pixel)


def fan_paper():
    """The paper of a round fan: morning glories on white."""
    size = 512
    cloud = fractal(size, size, 6, 6, 4, 601)
    flowers = [(0.34, 0.60, 0.17, 0), (0.64, 0.70, 0.13, 1), (0.60, 0.42, 0.15, 0), (0.32, 0.34, 0.10, 1)]
    leaves = [(0.48, 0.52, 0.10, 0.6), (0.74, 0.54, 0.09, 2.1), (0.22, 0.46, 0.08, 4.0), (0.46, 0.26, 0.09, 5.1),
              (0.50, 0.78, 0.08, 1.2)]

    def pixel(x, y):
        u, v = (x + 0.5) / size, 1 - (y + 0.5) / size
        c = mix((0.92, 0.91, 0.86), (0.97, 0.97, 0.94), cloud[y][x])
        for cx, cy, r, turn in leaves:
            a, d = math.atan2(v - cy, u - cx) - turn, math.hypot(u - cx, v - cy)
            if d < r * (0.55 + 0.45 * math.cos(3 * a)) * (0.85 + 0.15 * math.cos(a)):
                c = mix((0.24, 0.45, 0.26), (0.42, 0.60, 0.34), cloud[y][x])
        for cx, cy, r, kind in flowers:
            a, d = math.atan2(v - cy, u - cx), math.hypot(u - cx, v - cy) / r
            if d < 1 + 0.04 * math.cos(5 * a):
                petal = ((0.30, 0.25, 0.66), (0.70, 0.24, 0.44))[kind]
                rays = smoothstep(0.5, 0.98, math.cos(5 * a) * 0.5 + 0.5) * smoothstep(0.95, 0.2, d)
                c = mix(mix((0.97, 0.96, 0.88), petal, smoothstep(0.18, 0.55, d)), (0.97, 0.95, 0.97), 0.65 * rays)
        rib = abs((math.atan2(v + 0.15, u - 0.5) * 22 / math.pi) % 1 - 0.5)
        return scaled(c, 1 - 0.07 * smoothstep(0.12, 0.0, rib))

    write("Texture", "room_fan.png", size, size, pixel)


# ---- iron, clay, fur -----------------------------------------------------------------------------------------

def iron():
    """Cast iron: u round the kettle, v up; small hail dots in the relief."""
    w, h = 512, 256
    rust = fractal(w, h, 6, 3, 5, 701)
    grain = fractal(w, h, 64, 32, 2, 711)
    write("Texture", "room_iron.png", w, h,
          lambda x, y: ramp([(0, (0.07, 0.07, 0.08)), (0.6, (0.13, 0.12, 0.12)), (1, (0.27, 0.17, 0.11))],
                            clamp(1.5 * (rust[y][x] - 0.3) + 0.3 * (grain[y][x] - 0.5))))
    rows = []
    for y in range(h):
        v = (1 - (y + 0.5) / h) * 20
        row = []
        for x in range(w):
            u = (x + 0.5) / w * 48 + 0.5 * (int(v) % 2)
            inside = 0.17 - (u % 1 - 0.5) ** 2 - (v % 1 - 0.5) ** 2
            dots = math.sqrt(inside) * 2.2 if inside > 0 and 5 <= int(v) < 14 else 0.0
            row.append(clamp(0.75 * dots + 0.25 * grain[y][x]))
        rows.append(row)
    write_normals("room_iron_normal.png", rows, 0.010)


def wave_bowl():
    """Porcelain with blue-ocean waves: rows of fans of arcs."""
    w, h = 1024, 256
    cobalt = fractal(w, h, 24, 6, 4, 721)

    def arcs(u, v):
        """The nearest fan in front (lower rows lie over higher ones), its radius in units of the cell."""
        for row in range(int(v * 2) - 2, int(v * 2) + 2):
            cx = math.floor(u - 0.5 * (row % 2) + 0.5) + 0.5 * (row % 2)
            d = math.hypot(u - cx, (v - row / 2))
            if d < 0.5:
                return d / 0.5
        return None

    def pixel(x, y):
        u, v = (x + 0.5) / w * 20, (1 - (y + 0.5) / h) * 5
        white = mix((0.88, 0.90, 0.91), (0.94, 0.95, 0.94), cobalt[y][x])
        d = arcs(u, v)
        inside = 0.9 < v < 3.6
        band = min(abs(v - 0.75), abs(v - 3.8), abs(v - 4.6)) < 0.05
        if band:
            return mix((0.13, 0.22, 0.50), (0.22, 0.34, 0.62), cobalt[y][x])
        if inside and d is not None:
            line = 1 - smoothstep(0.05, 0.12, min(abs(d - k) for k in (0.33, 0.63, 0.95)))
            return mix(white, mix((0.12, 0.20, 0.48), (0.28, 0.40, 0.68), cobalt[y][x]), line)
        return white

    write("Texture", "room_waves.png", w, h, pixel)


def raku():
    """A tea bowl's glaze: black-brown above, running into bare red clay below."""
    w, h = 512, 256
    run = noise(w, 1, 14, 1, 741)[0]
    speck = fractal(w, h, 48, 24, 3, 751)
    broad = fractal(w, h, 6, 3, 4, 761)

    def pixel(x, y):
        v = 1 - (y + 0.5) / h
        edge = 0.28 + 0.14 * (run[x] - 0.5)
        glaze = ramp([(0, (0.10, 0.22, 0.20)), (0.5, (0.23, 0.42, 0.38)), (1, (0.52, 0.64, 0.56))],
                     clamp(0.4 + 1.3 * (broad[y][x] - 0.5) + 0.6 * (speck[y][x] - 0.5) + 0.9 * (v - 0.6)))
        clay = mix((0.42, 0.25, 0.17), (0.58, 0.38, 0.27), speck[y][x])
        drop = smoothstep(edge - 0.012, edge + 0.012, v)
        return scaled(mix(clay, glaze, drop), 1 - 0.35 * drop * (1 - smoothstep(edge, edge + 0.06, v)))

    write("Texture", "room_raku.png", w, h, pixel)


def cat_fur():
    """A ginger tabby: u the angle about the upright axis (the middle is the front), v the height over 0.4."""
    w, h = 1024, 512
    hair = fractal(w, h, 160, 20, 3, 801, 0.8)
    wander = fractal(w, h, 6, 5, 4, 811)
    blot = fractal(w, h, 10, 8, 4, 821)

    def pixel(x, y):
        u, v = (x + 0.5) / w, 1 - (y + 0.5) / h
        front = 1 - abs(u - 0.5) * 2
        hairs = hair[y][x] - 0.5
        ginger = mix((0.60, 0.34, 0.16), (0.80, 0.54, 0.30), clamp(0.5 + 1.2 * hairs + 0.8 * (blot[y][x] - 0.5)))
        wave = math.sin(TAU * (v * 15 + 1.1 * (wander[y][x] - 0.5) * 2 + 0.9 * abs(front - 0.35)))
        stripe = smoothstep(0.05, 0.65, wave + 0.9 * hairs) * smoothstep(0.92, 0.55, front)
        spine = smoothstep(0.10, 0.03, front) * smoothstep(0.05, 0.2, v)
        c = mix(ginger, (0.43, 0.19, 0.07), 0.80 * max(stripe, 0.8 * spine))
        bib = smoothstep(0.80, 0.88, front + 0.10 * (wander[y][x] - 0.5) + 0.10 * hairs) * (v < 0.66)
        muzzle = smoothstep(0.09, 0.06, math.hypot((u - 0.5) * 1.3, (v - 0.635) * 0.9) + 0.02 * hairs)
        blaze = smoothstep(0.012, 0.004, abs(u - 0.5) - 0.016 * (v < 0.74)) * (0.62 < v < 0.80)
        paws = smoothstep(0.075, 0.045, v + 0.03 * (wander[y][x] - 0.5))
        white = max(bib, muzzle, 0.8 * blaze, paws)
        c = mix(c, mix((0.80, 0.76, 0.70), (0.97, 0.95, 0.91), clamp(0.5 + 1.4 * hairs)), white)
        return scaled(c, 0.86 + 0.30 * (hairs + 0.4))

    write("Texture", "room_fur.png", w, h, pixel)
    fine = fractal(512, 256, 128, 16, 2, 831)
    write_normals("room_fur_normal.png", fine, 0.010)


def cat_eye():
    """An eye that looks along +z: amber-green iris, upright slit."""
    w, h = 512, 256
    streak = noise(w, 1, 64, 1, 841)[0]

    def pixel(x, y):
        a, b = TAU * ((x + 0.5) / w - 0.5), math.pi * (0.5 - (y + 0.5) / h)
        px, py = math.sin(a) * math.cos(b), math.sin(b)
        if math.cos(a) * math.cos(b) <= 0:
            return (0.10, 0.08, 0.07)
        d = math.hypot(px, py)
        ray = streak[int((math.atan2(py, px) / TAU + 0.5) * w) % w]
        iris = ramp([(0, (0.80, 0.82, 0.30)), (0.55, (0.62, 0.72, 0.25)), (1, (0.26, 0.40, 0.14))], clamp(d + 0.3 * (ray - 0.5)))
        slit = smoothstep(0.02, -0.02, (px / 0.22) ** 2 + (py / 0.72) ** 2 - 1)
        return mix(mix(iris, (0.03, 0.03, 0.03), slit), (0.08, 0.06, 0.05), smoothstep(0.80, 0.88, d))

    write("Texture", "room_eye.png", w, h, pixel)


def bark():
    w, h = 256, 512
    broad, fine = fractal(w, h, 8, 3, 4, 861), fractal(w, h, 32, 12, 3, 871)
    write("Texture", "room_bark.png", w, h,
          lambda x, y: ramp([(0, (0.13, 0.09, 0.07)), (0.5, (0.32, 0.24, 0.18)), (1, (0.52, 0.43, 0.34))],
                            clamp(0.5 + 1.4 * (broad[y][x] - 0.5) + 0.8 * (fine[y][x] - 0.5))))
    write_normals("room_bark_normal.png", [[0.6 * a + 0.4 * b for a, b in zip(p, q)] for p, q in zip(broad, fine)], 0.04)


def moss():
    size = 256
    broad, fine = fractal(size, size, 4, 4, 4, 881), fractal(size, size, 48, 48, 2, 891)
    write("Texture", "room_moss.png", size, size,
          lambda x, y: mix((0.13, 0.20, 0.07), (0.45, 0.52, 0.20), clamp(0.5 + 1.2 * (broad[y][x] - 0.5) + 1.4 * (fine[y][x] - 0.5))))


ALL = (post_wood, tansu_wood, sill_wood, ceiling_wood, wood_bump, tatami, plaster, washi, indigo, crimson, border,
       fan_paper, iron, wave_bowl, raku, cat_fur, cat_eye, bark, moss)
