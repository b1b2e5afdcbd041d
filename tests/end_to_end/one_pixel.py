"""--pixel: the rays behind a pixel, held against a picture of floats that the same options give."""
import os, re, struct, subprocess

from base import EVERYTHING, EndToEnd

NUMBER = r"-?(?:\d[-+.\de]*|nan|inf)"
COLOUR = "(%s) (%s) (%s)" % (NUMBER, NUMBER, NUMBER)
SIZE = (40, 30)


class OnePixel(EndToEnd):
    def setUp(self):
        super().setUp()
        self.write("scene.lua", EVERYTHING)

    def told(self, x, y, *words, scene="scene.lua"):
        said = self.run_project(scene, "-q", "--size", "%dx%d" % SIZE, *words, "--pixel", "%d,%d" % (x, y))
        return said.stdout.decode()

    def picture(self, *words, scene="scene.lua"):
        """-> {(x, y): colour}, as 32-bit floats"""
        self.run_project(scene, "-q", "--size", "%dx%d" % SIZE, *words, "-o", "p.pfm")
        floats = struct.unpack("<%df" % (3 * SIZE[0] * SIZE[1]), self.read("p.pfm")[-12 * SIZE[0] * SIZE[1]:])
        # A PFM begins with the bottom row.
        return {(x, SIZE[1] - 1 - row): floats[3 * (row * SIZE[0] + x):][:3]
                for row in range(SIZE[1]) for x in range(SIZE[0])}

    def colours(self, pattern, text):
        return [tuple(map(float, found)) for found in re.findall(pattern + COLOUR, text)]

    def assertNear(self, a, b):
        """to the six digits that are shown of each of many numbers"""
        for x, y in zip(a, b):
            self.assertAlmostEqual(x, y, delta=2e-5 * max(1.0, abs(x)))

    def check(self, text, expected):
        """the sums that the text shows; -> how many rays"""
        colour = self.colours(r"\ncolour ", text)[0]
        self.assertEqual(struct.unpack("<3f", struct.pack("<3f", *colour)), expected)
        heads = list(re.finditer(r"^sample[ \d]* at .*?: ", text, re.MULTILINE))
        total = [0.0] * 3
        for head, after in zip(heads, heads[1:] + [None]):
            part = text[head.end():after.start() if after else None]
            value = self.colours("^", part)[0]
            brought = self.colours(r"\n +brings ", part)
            weight = float((re.findall(r"filter weight (%s)" % NUMBER, part.split("\n")[0]) + [1])[0])
            self.assertNear([weight * sum(channel) for channel in zip(*brought)], value)
            total = [a + b for a, b in zip(total, value)]
        if "told by its corners" not in text:
            self.assertNear([channel / len(heads) for channel in total], colour)
        return len(re.findall(r" ray from ", text))

    def test_the_rays_add_up_to_the_pixel_of_the_picture(self):
        for words in ("--spp", "3"), ("--spp", "2", "--filter", "mitchell"), ("--spp", "4", "--sampler", "jitter"), \
                ("--error", "0.02", "--seed", "5"), ("--reference", "--spp", "2"):
            picture = self.picture(*words)
            most = 0
            for x, y in (0, 0), (12, 14), (16, 17), (26, 16), (39, 29), (20, 28):
                with self.subTest(words=words, pixel=(x, y)):
                    most = max(most, self.check(self.told(x, y, *words), picture[x, y]))
            self.assertGreater(most, 8)

    def test_a_pixel_that_its_corners_tell_says_so(self):
        self.write("wall.lua", """
local root = gr.node('root')
root:add_child(gr.nh_box('wall', {-50, -50, -9}, {100, 100, 1}), gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 0))
gr.render(root, 'x.png', 8, 6, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 45, {0.5, 0.5, 0.5},
          {gr.light({2, 3, 5}, {0.5, 0.5, 0.5}, {1, 0, 0})})""")
        text = self.told(7, 9, scene="wall.lua")
        self.assertIn("told by its corners", text)
        self.check(text, self.picture(scene="wall.lua")[7, 9])
        self.assertIn("the mean of 1 sample", self.told(7, 9, "--spp", "1", scene="wall.lua"))

    def test_names_kinds_and_lights_of_a_mirror_and_glass(self):
        self.write("optics.lua", """
local root, grey = gr.node('root'), gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 0)
local mirror, glass = gr.nh_box('my mirror', {-9, -9, -1}, {9, 18, 1}), gr.nh_box("my\\nglass", {0.5, -9, -1}, {8, 18, 1})
mirror:set_reflection(0.25)
glass:set_refraction(1, 0)
root:add_child(mirror, grey)
root:add_child(glass, grey)
root:add_child(gr.nh_box('behind', {-9, -9, -9}, {18, 18, 1}), grey)
root:add_child(gr.mesh('roof', {{-9, 9, -9}, {9, 9, -9}, {0, 9, 9}}, {{0, 1, 2}}), grey)
gr.background({0, 0, 1}, {0, 0, 1})
gr.render(root, 'x.png', 4, 4, {0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 45, {0, 0, 0},
          {gr.light({0, 0, 5}, {1, 1, 1}, {1, 0, 0}), gr.light({0, 20, -5}, {1, 1, 1}, {1, 0, 0})})""")
        text = self.told(5, 15, "--spp", "1", "--size", "40x30", scene="optics.lua")
        self.assertIn("hits 'my mirror' (box)", text)
        self.assertIn("shares: own 0.25, reflected 0.75, refracted 0\n", text)
        self.assertRegex(text, r"\n    reflected ray .* weight 0\.75\n      hits nothing: background 0 0 1\n"
                               r"      brings 0 0 0\.75\n")
        self.assertIn("light 2 brings nothing", text)
        text = self.told(35, 15, "--spp", "1", scene="optics.lua")
        self.assertRegex(text, r"hits 'my.*glass' \(box\), from inside")
        self.assertRegex(text, r"refracted ray .* weight 1\n        hits 'behind'")
        self.assertRegex(text, r"light 2 brings 0 0 0: visible 0, behind 'roof' \(mesh\)")

    def test_a_sample_of_what_moves_has_its_time(self):
        self.write("moving.lua", """
local root, ball = gr.node('root'), gr.nh_sphere('ball', {-1, 0, 0}, 0.7)
ball:move(2, 0, 0)
root:add_child(ball, gr.material({1, 1, 1}, {0, 0, 0}, 0))
gr.render(root, 'x.png', 4, 4, {0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 20, {1, 1, 1}, {gr.light({2, 3, 9}, {1, 1, 1}, {1, 0, 0})})""")
        text = self.told(20, 15, "--spp", "16", scene="moving.lua")
        self.check(text, self.picture("--spp", "16", scene="moving.lua")[20, 15])
        shots = re.findall(r", at (%s) of the shutter's time\n.*\n +hits (.*)" % NUMBER, text)
        self.assertEqual(len(shots), 16)
        for time, what in shots:
            # The ball, of radius 0.7 at 2 time - 1, is before x = 0.05 or so.
            middle = abs(2 * float(time) - 1)
            if abs(middle - 0.7) > 0.1:
                self.assertEqual(what.startswith("'ball'"), middle < 0.7, (time, what))

    def test_every_primitive_has_its_name(self):
        for call, name in (("sphere('a')", "sphere"), ("cube('a')", "box"), ("cylinder('a')", "cylinder"),
                           ("nh_cone('a', {0, -1, 0}, 3, 2)", "cone"), ("torus('a', 0.5, 0.5)", "torus"),
                           ("hemisphere('a')", "hemisphere"), ("nh_frustum('a', {0, -1, 0}, 2, 1, 0.5)", "frustum"),
                           ("nh_disc('a', {0, 0, 0}, {0, 0, 1}, 1)", "disc"),
                           ("nh_quad('a', {-1, -1, 0}, {2, 0, 0}, {0, 2, 0})", "quad"),
                           ("nh_plane('a', {0, 0, 0}, {0, 0, 1})", "plane"),
                           ("mesh('a', {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}})", "mesh")):
            with self.subTest(name):
                self.write("one.lua", """
local root = gr.node('root')
root:add_child(gr.%s, gr.material({1, 1, 1}, {0, 0, 0}, 0))
gr.render(root, 'x.png', 4, 4, {0.3, 0.3, 9}, {0, 0, -1}, {0, 1, 0}, 5, {1, 1, 1}, {gr.light({0, 0, 9}, {1, 1, 1}, {1, 0, 0})})
""" % call)
                self.assertIn("hits 'a' (%s)" % name, self.told(20, 15, "--spp", "1", scene="one.lua"))

    def test_the_text_is_the_same_for_any_threads_and_instruction_set(self):
        for words in ("--spp", "2"), ("--error", "0.02"):
            texts = {self.told(12, 14, *words, "-j", threads, *more) for threads in "17"
                     for more in ((), ("--isa", "baseline"))}
            self.assertEqual(len(texts), 1)

    def test_nothing_is_written_and_what_cannot_be_is_refused(self):
        self.told(1, 1, "--spp", "1", "-o", "x.png", "--stats", "s.json", "--deps", "d", "--aov", "depth")
        self.assertEqual(os.listdir(self.folder), ["scene.lua"])
        for words, code in (("--time", "1"), 2), (("--preview",), 2), (("--spp", "1", "--size", "8x6"), 2):
            said = self.run_project("scene.lua", *words, "--pixel", "8,0", code=code).stderr
            self.assertIn(b"--pixel", said)
        self.write("timed.lua", "gr.options{time = 1}\n" + EVERYTHING)
        self.assertIn(b"--pixel", self.run_project("timed.lua", "--pixel", "0,0", code=2).stderr)
        for bad in "1", "1,2,3", "-1,0", "a,b", "1.5,2", "", "1, 2":
            self.assertIn(b"--pixel", self.run_project("scene.lua", "--pixel", bad, code=2).stderr)

    def test_a_full_disk_is_told(self):
        with open("/dev/full", "wb") as full:
            done = subprocess.run([self.project, "scene.lua", "-q", "--spp", "64", "--pixel", "12,14"], cwd=self.folder,
                                  stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"standard output", done.stderr)

    def test_frames_and_several_images_are_told_one_after_another(self):
        self.write("two.lua", EVERYTHING + "\n" + EVERYTHING.replace("everything.png", "second.png"))
        text = self.told(1, 1, "--spp", "1", "--frames", "3-4", "-o", "f###.png", scene="scene.lua")
        self.assertEqual(re.findall(r"^(\S+), pixel 1,1 of 40x30$", text, re.MULTILINE), ["f003.png", "f004.png"])
        text = self.told(1, 1, "--spp", "1", scene="two.lua")
        self.assertEqual(re.findall(r"^(\S+), pixel", text, re.MULTILINE), ["everything.png", "second.png"])
