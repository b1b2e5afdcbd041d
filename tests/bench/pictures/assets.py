"""Textures and meshes of the benchmark scenes."""
import math, os, struct, zlib
import numpy as np

MESH_EDGE = {"5k": 20, "50k": 65, "500k": 204, "2M": 408}    # quads along a cube edge; 12 n^2 triangles


def write_png(path, values):
    """values: (h, w, 3), 0 to 255, the first row on top"""
    a = np.asarray(values, np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in a)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", a.shape[1], a.shape[0], 8, 2, 0, 0, 0))
                + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def floor_texture(path):
    """four by four tiles with marble veins and grout; periodic; linear reflectance"""
    n = 256
    y, x = np.mgrid[0:n, 0:n] / n
    tx, ty = (x * 4) % 1, (y * 4) % 1
    two = 2 * np.pi
    vein = 0.5 + 0.5 * np.sin(two * (2 * x + y + 0.35 * np.sin(two * (x + 2 * y))
                                     + 0.2 * np.sin(two * (5 * x - 3 * y))))
    dark = (np.floor(x * 4) + np.floor(y * 4)) % 2 > 0
    color = np.where(dark[..., None], [0.75, 0.62, 0.45], [0.35, 0.22, 0.14]) * (0.75 + 0.25 * vein[..., None])
    color[(np.minimum(tx, 1 - tx) < 0.03) | (np.minimum(ty, 1 - ty) < 0.03)] = 0.2
    write_png(path, np.clip(color * 255 + 0.5, 0, 255))


def checker_texture(path, cells=8, pixels=8):
    n = cells * pixels
    y, x = np.mgrid[0:n, 0:n] // pixels
    write_png(path, np.repeat(np.where((x + y) % 2, 230, 25)[..., None], 3, axis=2))


def rows(form, values, between):
    return between.join(form % tuple(v) for v in values.tolist())


def blob(size):
    """A cube projected onto a sphere and displaced: (vertices, smooth normals, faces from 0)"""
    n = MESH_EDGE[size]
    g = np.tan(np.linspace(-1, 1, n + 1) * math.pi / 4)
    g[0], g[-1] = -1.0, 1.0
    if n % 2 == 0:
        g[n // 2] = 0.0
    a, b = np.meshgrid(g, g, indexing="ij")
    one = np.ones_like(a)
    sides = [(one, a, b), (-one, -a, b), (-a, one, b), (a, -one, b), (-b, a, one), (b, a, -one)]
    points = np.concatenate([np.stack(s, -1).reshape(-1, 3) for s in sides])
    i, j = (v.ravel() for v in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))
    m = n + 1
    q00, q10, q01, q11 = i * m + j, (i + 1) * m + j, i * m + j + 1, (i + 1) * m + j + 1
    side = np.concatenate([np.stack([q00, q10, q11], 1), np.stack([q00, q11, q01], 1)])
    faces = np.concatenate([side + k * m * m for k in range(6)])
    _, first, inverse = np.unique(np.round(points * 1e7).astype(np.int64), axis=0, return_index=True,
                                  return_inverse=True)
    points, faces = points[first], inverse.ravel()[faces]
    d = points / np.linalg.norm(points, axis=1, keepdims=True)
    x, y, z = d.T
    r = 2.0 * (1 + 0.10 * np.sin(5 * x + 1) * np.sin(6 * y + 2) * np.sin(4 * z)
               + 0.03 * np.sin(17 * x) * np.cos(15 * y + 1) * np.sin(19 * z + 2)
               + 0.004 * np.sin(61 * x + 3) * np.sin(67 * y) * np.sin(59 * z + 1))
    v = np.round(d * r[:, None], 6)
    normals = np.zeros_like(v)
    flat = np.cross(v[faces[:, 1]] - v[faces[:, 0]], v[faces[:, 2]] - v[faces[:, 0]])
    for corner in range(3):
        for c in range(3):
            normals[:, c] += np.bincount(faces[:, corner], flat[:, c], len(v))
    return v, normals / np.linalg.norm(normals, axis=1, keepdims=True), faces


def write_blob(folder, size):
    v, n, f = blob(size)
    with open(os.path.join(folder, "mesh_%s.obj" % size), "w") as out:
        out.write(rows("v %.6f %.6f %.6f", v, "\n") + "\n" + rows("f %d %d %d", f + 1, "\n") + "\n")
    with open(os.path.join(folder, "mesh_%s.inc" % size), "w") as out:
        out.write("#declare TheMesh = mesh2 {\n")
        out.write("vertex_vectors { %d,\n%s\n}\n" % (len(v), rows("<%.6f,%.6f,%.6f>", v, ",\n")))
        out.write("normal_vectors { %d,\n%s\n}\n" % (len(n), rows("<%.5f,%.5f,%.5f>", n, ",\n")))
        out.write("face_indices { %d,\n%s\n}\n}\n" % (len(f), rows("<%d,%d,%d>", f, ",\n")))


def rectangle(path, low, high, y, scale):
    """OBJ: a rectangle in the plane y seen from above, with texture coordinates x / scale, z / scale"""
    corners = [(low[0], low[1]), (low[0], high[1]), (high[0], high[1]), (high[0], low[1])]
    with open(path, "w") as out:
        out.writelines("v %.9g %.9g %.9g\n" % (x, y, z) for x, z in corners)
        out.writelines("vt %.9g %.9g\n" % (x / scale, z / scale) for x, z in corners)
        out.write("f 1/1 2/2 3/3 4/4\n")
