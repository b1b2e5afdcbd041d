"""What the pages for readers tell them to do, done."""
import os, re, subprocess, sys

from base import EndToEnd, TOP

sys.path.insert(0, os.path.join(TOP, "tools"))
from make_tutorial import OPTIONS, Tutorial, put

TINY = ["-q", "--size", "32x18"]


class Walkthroughs(EndToEnd):
    def test_the_tutorials_steps_make_its_pictures(self):
        pictures = Tutorial().pictures
        self.assertEqual(len(pictures), 7)
        for name, script, parameters in pictures:
            with self.subTest(name):
                put(self.folder, script, parameters)
                more = ["--param-file", "mine.params"] if parameters else []
                self.run_project("lighthouse.lua", *OPTIONS, *more, "-o", "now.png")
                # As far as two machines' roundings may part.
                self.run_project("compare", "now.png", os.path.join(TOP, "Documentation", name), "--tolerance", "0.001")

    def test_the_tutorials_mistakes_are_told_as_it_says(self):
        mistakes = Tutorial().mistakes
        self.assertEqual(len(mistakes), 2)
        for script, message in mistakes:
            put(self.folder, script, "")
            line = len(script.rstrip().split("\n"))
            said = self.run_project("lighthouse.lua", *TINY, code=1).stderr.decode()
            self.assertIn("lighthouse.lua:%d: %s" % (line, message), said)

    def test_the_tutorials_commands_do_what_it_says(self):
        commands = [(words, *more) for words, *more in Tutorial().commands if "--watch" not in words]
        self.assertEqual(len(commands), 4)
        for words, script, parameters in commands:
            put(self.folder, script, parameters)
            listed = self.run_project(*words, *TINY, "--werror").stdout.decode()
            if "--list-params" in words:
                self.assertEqual(listed, "# Stripes of the tower.\nstripes = 5\n"
                                         "# Another number gives other rocks.\nseed = 1\n")
        frames = [self.read("sail-%02d.png" % i) for i in range(1, 49)]
        self.assertEqual(len(set(frames)), 48)
        self.assertNotEqual(self.read("mine.png"), frames[0])

    def test_the_scene_from_pov_ray_is_what_the_page_shows(self):
        here, there = (os.path.join(TOP, "Documentation", "images", "from_pov_ray_%s.png" % who) for who in ("here", "povray"))
        self.run_project(os.path.join(TOP, "Documentation", "examples", "pov_ray", "still.lua"), "-q", "--werror", "-o",
                         "now.png")
        self.run_project("compare", "now.png", here, "--tolerance", "0.001")
        self.run_project("compare", "now.png", there, "--tolerance", "0.015")


class Batches(EndToEnd):
    SCENE = """
local shapes = require 'shapes'
local root = gr.node('root')
root:add_child(shapes.ball(gr.param('size', 1)), gr.material({0.8, 0.4, 0.2}, {0, 0, 0}, 1))
gr.render(root, 'x.png', 16, 12, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 45, {0.5, 0.5, 0.5},
          {gr.light({5, 8, 5}, {0.8, 0.8, 0.8}, {1, 0, 0})})
"""
    SHAPES = "return {ball = function(size) return gr.nh_sphere('ball', {0, 0, 0}, size) end}\n"

    def setUp(self):
        super().setUp()
        with open(os.path.join(TOP, "Documentation", "batches.md")) as f:
            page = f.read()
        self.blocks = dict(re.findall(r"^```(\w+)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL))
        self.write("scene.lua", self.SCENE)
        self.write("shapes.lua", self.SHAPES)

    def made(self):
        """the images that make renders anew"""
        done = subprocess.run(["make", "PROJECT=" + self.project], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return sorted(re.findall(r"-o (\S+)", done.stdout))

    def change(self, name, text):
        """as if a second later"""
        self.write(name, text)
        later = max(os.stat(self.path(f)).st_mtime for f in os.listdir(self.folder)) + 1
        os.utime(self.path(name), (later, later))

    def test_the_makefile_of_variants_renders_what_changed(self):
        self.write("Makefile", self.blocks["make"])
        for size in "0.5", "1", "1.5":
            self.write("size-%s.params" % size, "size = %s\n" % size)
        every = ["size-0.5.png", "size-1.5.png", "size-1.png"]
        self.assertEqual(self.made(), every)
        self.assertEqual(self.made(), [])
        self.change("size-1.params", "size = 0.9\n")
        self.assertEqual(self.made(), ["size-1.png"])
        self.change("shapes.lua", self.SHAPES + "-- changed\n")
        self.assertEqual(self.made(), every)

    def test_the_lines_of_continuous_integration_tell_a_changed_picture(self):
        self.write("looks/ball.lua", "gr.options{spp = 4}\n" + self.SCENE.replace("shapes.ball", "require('shapes').ball"))
        self.write("looks/shapes.lua", self.SHAPES)
        self.run_project("golden", "looks", "--update")
        script = self.blocks["sh"].replace("./Project", self.project)

        def code():
            done = subprocess.run(["sh", "-eu", "-c", script], cwd=self.folder, capture_output=True, text=True)
            return done.returncode, "pictures changed" in done.stdout

        self.assertEqual(code(), (0, False))
        self.write("looks/shapes.lua", self.SHAPES.replace("0}, size", "0}, 0.9 * size"))
        self.assertEqual(code(), (10, True))
        self.write("looks/shapes.lua", "return 1")
        self.assertEqual(code(), (1, False))

    def test_a_subset_of_frames_has_the_times_of_the_whole(self):
        self.write("moving.lua", self.SCENE.replace("{0, 0, 5}", "{gr.time, 0, 5}"))
        shots = ["moving.lua", "-q", "--spp", "1", "--frames", "1-5"]
        self.run_project(*shots, "-o", "w#.png")
        self.run_project(*shots, "--subset", "2-3", "-o", "s#.png")
        self.assertEqual([name for name in sorted(os.listdir(self.folder)) if name.startswith("s") and name.endswith("png")],
                         ["s2.png", "s3.png"])
        for i in "23":
            self.assertEqual(self.read("w%s.png" % i), self.read("s%s.png" % i))
