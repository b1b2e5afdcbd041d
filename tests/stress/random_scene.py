"""Random valid scenes of all that the language has, as scripts, with options to render them with."""
from solids import KINDS, Solid, number, triple

TEXTURES = ["bricks", "checker", "planks", "plaster", "uv_grid"]
BUMPS = ["bricks_normal", "ripples_height", "studs_normal"]
MESHES = ["blob", "dodecahedron", "vase", "ball80", "cup"]
SAMPLERS = ["joint", "jitter", "grid", "random"]
FILTERS = ["box", "gaussian", "mitchell", "blackman-harris"]


class RandomScene:
    """`script` and `options`, both made from `rng` alone; files are read from the folder `assets`."""

    def __init__(self, rng, assets):
        self.rng, self.assets = rng, assets
        self.script = "".join([self.backdrop(), self.palette(), self.nodes(), self.render()])
        self.options = self.quality() + self.ways()

    def colour(self, low=0.0, high=1.0):
        return triple([self.rng.uniform(low, high) for _ in range(3)])

    def place(self, reach):
        return triple([self.rng.uniform(-reach, reach) for _ in range(3)])

    def maybe(self, chance, text):
        return text if self.rng.random() < chance else ""

    def file(self, folder, name, ending):
        return "'%s/%s/%s.%s'" % (self.assets, folder, name, ending)

    def backdrop(self):
        kinds = ["", "gr.background(%s)\n" % self.colour(), "gr.background(%s, %s)\n" % (self.colour(), self.colour()),
                 "gr.background(%s)\n" % self.file("Texture", "sky", "png")]
        return self.rng.choice(kinds)

    def palette(self):
        rng = self.rng
        text = "materials, textures, bumps = {}, {}, {}\n"
        for i in range(4):
            specular = self.colour() if rng.random() < 0.6 else "{0, 0, 0}"
            text += "materials[%d] = gr.material(%s, %s, %s)\n" % (i + 1, self.colour(), specular, number(10 ** rng.uniform(0, 3)))
        for i in range(rng.choice((0, 0, 1, 2))):
            text += "textures[%d] = gr.texture(%s, %s, %s)\n" % (
                i + 1, self.file("Texture", rng.choice(TEXTURES), "png"), self.colour(0, 0.5), number(rng.uniform(1, 50)))
        if rng.random() < 0.3:
            text += "bumps[1] = gr.bumpmap(%s)\n" % self.file("Bump", rng.choice(BUMPS), "png")
        return text

    def solid(self):
        if self.rng.random() < 0.15:
            return "gr.mesh(%s, 'file', {smooth = %s})" % (self.file("Model", self.rng.choice(MESHES), "obj"),
                                                          self.rng.choice(("true", "false", "30")))
        if self.rng.random() < 0.12:
            return self.combined()
        if self.rng.random() < 0.08:
            return "gr.height_field('h', function(x, z) return 0.3 * math.sin(%s * x) * math.cos(%s * z) end, {resolution = 17, %s})" % (
                number(self.rng.uniform(1, 9)), number(self.rng.uniform(1, 9)), self.rng.choice(("base = -0.5", "smooth = false")))
        if self.rng.random() < 0.1:
            terms = ", ".join("%s = %s" % (term, number(self.rng.uniform(-2, 2))) for term in "xx yy zz xy yz zx x y z c".split())
            return "gr.quadric('q', {%s}, {-1, -0.8, -0.9}, {0.8, 1, 1.1})" % terms
        if self.rng.random() < 0.2:
            radii = [number(self.rng.uniform(0.1, 1.2)) for _ in range(2)]
            return self.rng.choice(["gr.disc('d')", "gr.quad('q')", "gr.hemisphere('h')",
                                    "gr.nh_frustum('f', {0, -0.5, 0}, 1.5, %s, %s)" % tuple(radii)])
        return Solid(self.rng.choice(KINDS), self.rng).lua()

    def combined(self, levels=2):
        """Solids within solids, each moved."""
        rng = self.rng
        parts = [Solid(rng.choice(KINDS), rng).lua() if levels == 0 or rng.random() < 0.6 else self.combined(levels - 1)
                 for _ in range(rng.randint(2, 3))]
        call = rng.choice(("union", "intersection", "difference"))
        return "gr.%s('%s', %s)" % (call, call, ", ".join(
            "moved(%s, %s)" % (part, ", ".join(number(rng.uniform(-0.6, 0.6)) for _ in range(3))) for part in parts))

    def look(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.2:
            return "node:set_reflection(%s)\n" % number(rng.random())
        if kind < 0.45:
            return ("node:set_refraction(%s, %s)\n" % (number(rng.uniform(1, 2.4)), number(rng.choice((0, rng.random()))))
                    + self.maybe(0.5, "node:set_fresnel(true)\n") + self.maybe(0.3, "node:set_absorption(%s)\n" % self.colour(0, 2)))
        return ""

    def move(self):
        rng = self.rng
        s = 10 ** rng.uniform(-0.6, 0.5)
        stretch = [s * rng.choice((1, rng.uniform(0.5, 2), -1)) for _ in range(3)]
        return ("node:scale(%s)\n" % ", ".join(map(number, stretch))
                + "node:rotate('%s', %s)\n" % (rng.choice("xyz"), number(rng.uniform(-180, 180)))
                + self.maybe(0.03, "node:spin('%s', %s)\n" % (rng.choice("xyz"), number(rng.uniform(-400, 400))))
                + "node:translate(%s)\n" % ", ".join(number(rng.uniform(-3, 3)) for _ in range(3)))

    def nodes(self):
        rng = self.rng
        text = "root = gr.node('root')\ngroups = {root}\n"
        text += "function moved(part, x, y, z) part:translate(x, y, z) return part end\n"
        for i in range(rng.randint(1, 14)):
            grouped = rng.random() < 0.2
            text += "node = %s\n" % ("gr.node('group')" if grouped else self.solid()) + self.move() + ("" if grouped else self.look())
            text += "groups[%d]:add_child(node, materials[%d]%s)\n" % (
                1, rng.randint(1, 4), self.maybe(0.3, ", textures[%d]%s" % (rng.randint(1, 2), self.maybe(0.5, ", bumps[1]"))))
            if grouped:
                # What hangs under two parents is one object in two places.
                text += "groups[#groups + 1] = node\nchild = %s\nnode:add_child(child, materials[1])\n" % self.solid()
                text += "again = gr.node('again')\nagain:translate(0, %s, -1)\nagain:add_child(child, materials[1])\nroot:add_child(again)\n" % number(
                    rng.uniform(-2, 2))
        floors = ["", "gr.nh_plane('floor', {0, -3, 0}, {0, 1, 0})", "gr.nh_box('floor', {-9, -4, -12}, {18, 1, 18})"]
        floor = rng.choice(floors)
        return text + ("root:add_child(%s, materials[1])\n" % floor if floor else "")

    def light(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.1:
            return "gr.spot_light{position = %s, direction = %s, colour = %s, outer = %s, radius = %s}" % (
                self.place(9), self.place(1), self.colour(), number(rng.uniform(5, 90)), number(rng.choice((0, 1))))
        if kind < 0.2:
            return "gr.sun_light{direction = %s, colour = %s, angle = %s}" % (
                self.place(1), self.colour(), number(rng.choice((0, rng.uniform(0.1, 20)))))
        if kind < 0.3:
            return "gr.rectangle_light{corner = %s, u = %s, v = %s, colour = %s}" % (
                self.place(6), self.place(2), self.place(2), self.colour())
        return "gr.light(%s, %s, {1, 0, %s}, %s, %s)" % (
            self.place(9), self.colour(), number(rng.choice((0, 0.02))), number(rng.choice((0, 0, rng.uniform(0.2, 2)))),
            number(rng.choice((0, 0, 0.2))))

    def render(self):
        rng = self.rng
        lights = [self.light() for _ in range(rng.choice((0, 1, 1, 1, 2, 2, 3, 3, 40)))]
        eye = [rng.uniform(-3, 3), rng.uniform(-1, 5), rng.uniform(6, 10)]
        focal = self.maybe(0.25, ", gr.focal(%s, 0.1, %s)" % (number(rng.uniform(4, 11)), number(rng.uniform(0, 0.4))))
        return "gr.render(root, 'out.png', %d, %d, %s, %s, {0, 1, 0}, %s, %s, {%s}%s)\n" % (
            rng.randint(1, 72), rng.randint(1, 54), triple(eye), triple([-0.1 * eye[0], -0.1 * eye[1], -1.0]),
            number(rng.uniform(15, 90)), self.colour(0, 0.4), ", ".join(lights), focal)

    def quality(self):
        rng = self.rng
        if rng.random() < 0.1:
            return ["--caustics", "--error", "0.05"]  # photons for the default error take most of a minute
        if rng.random() < 0.6:
            return ["--error", repr(rng.choice((0.005, 0.01, 0.02))), "--max-spp", "128"]
        return ["--spp", str(rng.choice((1, 2, 4, 7, 9)))] + (["--sampler", rng.choice(SAMPLERS)] if rng.random() < 0.5 else [])

    def ways(self):
        rng = self.rng
        options = ["--seed", str(rng.randrange(10 ** 6))]
        for chance, more in ((0.2, ["--filter", rng.choice(FILTERS)]), (0.15, ["--transfer", "srgb"]), (0.15, ["--bits", "16"]),
                             (0.1, ["--reference", "--max-depth", "4"]), (0.2, ["--aov", "depth,normal,id,uv,samples"]),
                             (0.15, ["--crop", "0,0,40,30"]), (0.1, ["--max-depth", str(rng.randint(0, 4))])):
            if rng.random() < chance:
                options += more
        return options + ["-o", "out." + rng.choice(("png", "png", "pfm", "exr"))]
