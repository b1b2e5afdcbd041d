#!/usr/bin/env python3
"""run.py PROJECT [--only NAME...]: the program from outside: exit codes, messages, files, equal bytes.

PROJECT is the executable. NAME is a class in small letters; threads is what the thread sanitizer should see.
"""
import glob, json, os, shutil, signal, struct, subprocess, sys, time, unittest, zlib

from base import BALL, EVERYTHING, EndToEnd, TOP
from documents import Documents, Parameters
from installing import Installing
from one_pixel import OnePixel
from walkthroughs import Batches, Walkthroughs
from writing_scenes import Dependencies, OnTerminal, Previewing, Watching

PROJECT = ""


def pfm(path):
    """-> width, height, rows of (r, g, b) from the top"""
    with open(path, "rb") as f:
        assert f.readline().strip() == b"PF"
        width, height = map(int, f.readline().split())
        order = "<" if float(f.readline()) < 0 else ">"
        values = struct.unpack("%s%df" % (order, 3 * width * height), f.read())
    pixels = [values[3 * i:3 * i + 3] for i in range(width * height)]
    return width, height, [pixels[width * y:width * (y + 1)] for y in range(height)][::-1]


def plane(path):
    """-> width, height, rows of values of a PFM of one channel, or rows of triples"""
    with open(path, "rb") as f:
        channels = {b"PF": 3, b"Pf": 1}[f.readline().strip()]
        width, height = map(int, f.readline().split())
        assert float(f.readline()) < 0
        values = struct.unpack("<%df" % (channels * width * height), f.read())
    rows = [values[channels * width * y:channels * width * (y + 1)] for y in range(height)]
    return width, height, rows[::-1]


def exr_channels(data):
    """-> name -> values, of a scan-line EXR of floats in ZIP blocks (The OpenEXR file layout, openexr.com)"""
    at, header = 8, {}
    while data[at]:
        name, kind = data[at:].split(b"\0", 2)[:2]
        at += len(name) + len(kind) + 2
        size, = struct.unpack_from("<i", data, at)
        header[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    names, rest = [], header["channels"]
    while rest[0]:
        name, rest = rest.split(b"\0", 1)
        assert struct.unpack_from("<i", rest)[0] == 2, "not a float channel"
        names.append(name.decode())
        rest = rest[16:]
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    assert header["compression"] == b"\3", "not ZIP"
    blocks = (height + 15) // 16
    values = {name: [] for name in names}
    for offset in struct.unpack_from("<%dQ" % blocks, data, at + 1):
        y, size = struct.unpack_from("<2i", data, offset)
        rows = min(16, height - y)
        packed = data[offset + 8:offset + 8 + size]
        if size < 4 * width * rows * len(names):
            raw = bytearray(zlib.decompress(packed))
            for i in range(1, len(raw)):
                raw[i] = (raw[i] + raw[i - 1] - 128) & 255
            half = (len(raw) + 1) // 2
            packed = bytearray(len(raw))
            packed[0::2], packed[1::2] = raw[:half], raw[half:]
        lines = struct.unpack("<%df" % (width * rows * len(names)), packed)
        for line in range(rows * len(names)):
            values[names[line % len(names)]].extend(lines[width * line:width * (line + 1)])
    return values


class Threads(EndToEnd):
    def test_everything_at_once_is_the_same_for_1_2_3_and_7_threads(self):
        self.write("scene.lua", EVERYTHING)
        images = []
        for threads in "1", "2", "3", "7":
            self.run_project("scene.lua", "-q", "--spp", "4", "-j", threads, "-o", "out.pfm")
            images.append(self.read("out.pfm"))
        self.assertEqual(len(set(images)), 1)


class SameBytes(EndToEnd):
    def test_every_instruction_set_gives_the_same_bytes(self):
        self.write("scene.lua", EVERYTHING)
        images = {}
        for isa in "baseline", "avx2", "avx512":
            done = self.run_project("scene.lua", "-q", "--spp", "4", "--isa", isa, "-o", isa + ".pfm", code=None)
            if done.returncode == 2 and b"cannot run" in done.stderr:
                continue
            self.assertEqual(done.returncode, 0, done.stderr)
            images[isa] = self.read(isa + ".pfm")
        self.assertIn("baseline", images)
        self.assertEqual(len(set(images.values())), 1, list(images))

    def test_masked_processor_features_change_nothing(self):
        self.write("scene.lua", EVERYTHING + "print(math.sin(1.25), 3.7 ^ 1.9, math.exp(0.3), math.log(7))")
        plain = self.run_project("scene.lua", "-q", "--spp", "4", "-o", "a.pfm")
        masked = self.run_project("scene.lua", "-q", "--spp", "4", "-o", "b.pfm",
                                  env={"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-BMI2"})
        self.assertEqual(self.read("a.pfm"), self.read("b.pfm"))
        self.assertEqual(plain.stdout, masked.stdout)

    def test_a_crop_has_the_bytes_that_the_whole_has_there(self):
        self.write("scene.lua", EVERYTHING)
        self.run_project("scene.lua", "-q", "--spp", "4", "-o", "whole.pfm")
        self.run_project("scene.lua", "-q", "--spp", "4", "-o", "crop.pfm", "--crop", "13,7,41,38")
        _, _, whole = pfm(self.path("whole.pfm"))
        width, height, crop = pfm(self.path("crop.pfm"))
        self.assertEqual((width, height), (28, 31))
        self.assertEqual(crop, [row[13:41] for row in whole[7:38]])

    def test_planes_are_the_same_for_any_threads_and_instruction_set_and_in_a_crop(self):
        self.write("scene.lua", EVERYTHING.replace(",\n          gr.focal({0, 0, 1}, 0.05, 0.05)", ""))
        names = "depth normal albedo position id uv samples error".split()
        aov = ("scene.lua", "-q", "--error", "0.02", "--aov", ",".join(names))
        self.run_project(*aov, "-o", "a.png", "-j", "1")
        self.run_project(*aov, "-o", "b.png", "-j", "3", "--isa", "baseline")
        self.run_project(*aov, "-o", "c.png", "--crop", "13,7,41,38")
        for name in names:
            with self.subTest(name):
                self.assertEqual(self.read("a.%s.pfm" % name), self.read("b.%s.pfm" % name))
                width, _, whole = plane(self.path("a.%s.pfm" % name))
                _, _, crop = plane(self.path("c.%s.pfm" % name))
                channels = len(whole[0]) // width
                self.assertEqual(crop, [row[13 * channels:41 * channels] for row in whole[7:38]])
        self.run_project("scene.lua", "-q", "--error", "0.02", "-o", "plain.png")
        self.assertEqual(self.read("plain.png"), self.read("a.png"))

    def test_another_seed_gives_other_noise(self):
        self.write("scene.lua", EVERYTHING)
        self.run_project("scene.lua", "-q", "--spp", "4", "-o", "a.pfm")
        self.run_project("scene.lua", "-q", "--spp", "4", "-o", "b.pfm", "--seed", "1")
        self.assertNotEqual(self.read("a.pfm"), self.read("b.pfm"))

    def test_a_script_gives_the_same_image_in_every_run(self):
        self.write("scene.lua", """
            local root = gr.node('root')
            local places = {a = 1, b = 2, c = 3, d = 4, [{}] = 5, [print] = 6, e = 7}
            local n = 0
            for key, value in pairs(places) do
                n = n + 1
                root:add_child(gr.nh_sphere('s', {n - 4, math.random() * 2 - 1, 0}, 0.1 * value),
                               gr.material({math.random(), math.random(), 1}, {0, 0, 0}, 0))
            end
            gr.render(root, 'out.png', 40, 30, {0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 50, {0.3, 0.3, 0.3},
                      {gr.light({3, 5, 9}, {0.7, 0.7, 0.7}, {1, 0, 0})})""")
        images = set()
        for _ in range(5):
            self.run_project("scene.lua", "-q")
            images.add(self.read("out.png"))
        self.assertEqual(len(images), 1)


class Rendering(EndToEnd):
    def test_the_default_scene_is_project_lua(self):
        self.write("project.lua", BALL)
        done = self.run_project()
        self.assertTrue(os.path.exists(self.path("ball.png")))
        lines = done.stderr.decode().splitlines()
        self.assertRegex(lines[0], r"^Threads: \d+$")
        self.assertIn("Render Complete!", lines[-1])
        self.assertIn("ball.png", lines[-1])
        self.assertEqual(done.stdout, b"")

    def test_no_default_scene_is_an_error_that_names_it(self):
        done = self.run_project(code=1)
        self.assertIn(b"project.lua", done.stderr)

    def test_a_picture_shows_what_the_script_says(self):
        self.write("scene.lua", BALL)
        self.run_project("scene.lua", "-q", "-o", "ball.pfm")
        width, height, rows = pfm(self.path("ball.pfm"))
        self.assertEqual((width, height), (64, 48))
        self.assertEqual(rows[0][0], (0.0, 0.0, 0.0))
        middle = rows[20][32]
        self.assertGreater(middle[0], middle[2])

    def test_size_and_spp_from_the_command_line_win(self):
        self.write("scene.lua", "gr.options{spp = 2}\n" + BALL)
        self.run_project("scene.lua", "-q", "--size", "20x10", "--spp", "3", "--stats", "stats.json")
        render = json.loads(self.read("stats.json"))["renders"][0]
        self.assertEqual((render["width"], render["height"]), (20, 10))
        self.assertEqual((render["spp_min"], render["spp_max"], render["rays"]["camera"]), (3, 3, 600))

    def test_statistics_hold_every_key(self):
        self.write("scene.lua", EVERYTHING)
        self.run_project("scene.lua", "-q", "--spp", "2", "--stats", "stats.json")
        stats = json.loads(self.read("stats.json"))
        render = stats["renders"][0]
        for key in ("scene output width height threads seed spp_mean spp_min spp_max error_estimate error_target caustics "
                    "converged triangles primitives instances lights build_seconds render_seconds cpu_seconds "
                    "peak_rss_bytes rays cut_paths cut_error_bound passes features skipped warnings").split():
            self.assertIn(key, render)
        self.assertEqual((render["triangles"], render["primitives"], render["instances"], render["lights"]),
                         (4, 5, 6, 2))
        self.assertGreater(render["rays"]["refraction"], 0)
        last = render["passes"][-1]
        self.assertEqual((last["samples"], last["error_estimate"]), (render["rays"]["camera"], render["error_estimate"]))
        self.run_project("scene.lua", "-q", "--error", "0.01", "--stats", "stats.json")
        render = json.loads(self.read("stats.json"))["renders"][0]
        samples = [one["samples"] for one in render["passes"]]
        seconds = [one["seconds"] for one in render["passes"]]
        self.assertGreater(len(samples), 1)
        self.assertEqual(samples, sorted(set(samples)))
        self.assertEqual(seconds, sorted(seconds))
        last = render["passes"][-1]
        self.assertEqual((last["samples"], last["error_estimate"]), (render["rays"]["camera"], render["error_estimate"]))
        self.assertGreater(render["peak_rss_bytes"], 1000000)

    def test_explain_says_what_was_left_out(self):
        self.write("scene.lua", BALL)
        done = self.run_project("scene.lua", "--explain")
        self.assertIn(b"Left out", done.stderr)
        self.assertIn(b"no object has set_refraction", done.stderr)

    # What a scene may use, by the name that --stats gives it, and what is left out without it.
    FEATURES = {
        "secondary rays": "secondary rays and the path stack", "reflection": "mirror rays",
        "refraction": "media around each ray, and Fresnel terms",
        "transparent shadows": "shadow rays that walk through glass",
        "textures and bump maps": "texture look-ups and tangents", "area lights": "light samples",
        "lens": "lens samples", "meshes": "mesh trees and normal interpolation",
        "background image": "background image look-ups", "lights": "shadow rays",
        "absorption": "what media absorb along each ray", "light kinds": "what spots, suns and rectangles give",
        "motion blur": "a moment of its own for each sample", "many lights": "a choice of lights at each point",
        "combined solids": "what solids have in common", "caustics": "photons",
    }
    USES = {
        "reflection": ("ball:set_reflection(0.5)", ["secondary rays"]),
        "refraction": ("ball:set_refraction(1.5, 0)", ["secondary rays", "transparent shadows"]),
        "absorption": ("ball:set_refraction(1.5, 0) ball:set_absorption({1, 2, 3})",
                       ["refraction", "secondary rays", "transparent shadows"]),
        "textures and bump maps": ("root:add_child(gr.sphere('b'), nil, gr.texture('white.png', {0, 0, 0}, 1))", []),
        "area lights": ("lights[1] = gr.light({0, 9, 9}, {1, 1, 1}, {1, 0, 0}, 1)", ["lights"]),
        "lights": ("lights[1] = gr.light({0, 9, 9}, {1, 1, 1}, {1, 0, 0})", []),
        "light kinds": ("lights[1] = gr.spot_light{position = {0, 9, 9}, direction = {0, -1, -1}, colour = {1, 1, 1}}",
                        ["lights"]),
        "motion blur": ("ball:spin('y', 90)", []),
        "many lights": ("for i = 1, 32 do lights[i] = gr.light({i, 9, 9}, {1, 1, 1}, {1, 0, 0}) end", ["lights"]),
        "combined solids": ("root:add_child(gr.difference('d', ball, gr.cube('c')), white)", []),
        "caustics": ("gr.options{caustics = true} ball:set_reflection(0.5) lights[1] = gr.light({0, 9, 9}, {1, 1, 1}, {1, 0, 0})",
                     ["reflection", "secondary rays", "lights"]),
        "lens": ("focal = gr.focal(9, 0.1, 0.1)", []),
        "meshes": ("root:add_child(gr.mesh('m', {{0,0,0}, {1,0,0}, {0,1,0}}, {{0,1,2}}), white)", []),
        "background image": ("gr.background('white.png')", []),
    }

    def test_each_feature_is_used_or_said_to_be_left_out(self):
        self.write("sky.lua", "gr.background({1, 1, 1})\n"
                   "gr.render(gr.node('n'), 'white.png', 4, 4, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})")
        self.run_project("sky.lua", "-q", "--spp", "1")
        for name, (call, others) in [("none", ("", [])), *self.USES.items()]:
            self.write("uses.lua", "root, ball, lights = gr.node('r'), gr.sphere('ball'), {}\n"
                       "white = gr.material({1,1,1}, {0,0,0}, 1)\nroot:add_child(ball, white)\n" + call + "\n"
                       "gr.render(root, 'x.png', 4, 4, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, lights, focal)")
            done = self.run_project("uses.lua", "--explain", "--spp", "1", "--stats", "stats.json")
            render = json.loads(self.read("stats.json"))["renders"][0]
            used = {name, *others} - {"none"}
            self.assertEqual(set(render["features"]), used)
            left_out = {what for feature, what in self.FEATURES.items() if feature not in used}
            self.assertEqual({skipped["what"] for skipped in render["skipped"]}, left_out)
            for what in left_out:
                self.assertIn(b"Left out: " + what.encode() + b", because ", done.stderr)

    def test_check_renders_nothing(self):
        self.write("scene.lua", BALL)
        self.run_project("scene.lua", "--check")
        self.assertFalse(os.path.exists(self.path("ball.png")))
        self.write("bad.lua", "local root = gr.node('r')\nroot:add_child(gr.sphere('bare'))\n"
                   "gr.render(root, 'x.png', 8, 8, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})")
        done = self.run_project("bad.lua", "--check", code=1)
        self.assertIn(b"bad.lua:2", done.stderr)
        self.assertIn(b"bare", done.stderr)

    TEXTURED = """
        local root = gr.node('r')
        root:add_child(gr.nh_box('b', {-1, -1, -1}, 2), nil, gr.texture('%s', {0, 0, 0}, 0))
        gr.render(root, '%s', 8, 8, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 20, {1, 1, 1}, {})"""

    def test_openimageio_is_opened_only_where_a_scene_needs_it(self):
        self.write("ball.lua", BALL)
        self.run_project("ball.lua", "-q", "--spp", "1")
        os.rename(self.path("ball.png"), self.path("image.png"))
        for picture, opened in ("image.png", False), ("image.tif", True):
            with self.subTest(picture):
                self.write("scene.lua", self.TEXTURED % (picture, "out.png"))
                if opened:
                    self.run_project("ball.lua", "-q", "--spp", "1", "-o", picture)
                done = self.run_project("scene.lua", "-q", "--spp", "1", env={"LD_DEBUG": "files"})
                self.assertEqual(b"libOpenImageIO" in done.stderr, opened)

    def test_textures_in_every_format_that_is_written_here_look_alike(self):
        self.write("ball.lua", BALL)
        pictures = []
        for ending in "png", "tif", "exr", "hdr":
            # 16 bits, so that a PNG is as near to the values as the rest.
            self.run_project("ball.lua", "-q", "--spp", "4", "--bits", "16", "-o", "image." + ending)
            self.write("scene.lua", self.TEXTURED % ("image." + ending, "out.pfm"))
            self.run_project("scene.lua", "-q", "--spp", "4")
            _, _, rows = pfm(self.path("out.pfm"))
            pictures.append([value for row in rows for pixel in row for value in pixel])
        for other in pictures[1:]:
            self.assertLess(max(abs(a - b) for a, b in zip(pictures[0], other)), 0.004)
        self.assertGreater(max(pictures[0]) - min(pictures[0]), 0.1)

    def test_planes_add_up_to_the_statistics(self):
        self.write("scene.lua", EVERYTHING.replace(",\n          gr.focal({0, 0, 1}, 0.05, 0.05)", ""))
        for quality in ("--error", "0.01"), ("--spp", "8"):
            with self.subTest(quality[0]):
                self.run_project("scene.lua", "-q", *quality, "--aov", "samples,error", "-o", "x.png", "--stats", "s")
                stats = json.loads(self.read("s"))["renders"][0]
                samples = sum(plane(self.path("x.samples.pfm"))[2], ())
                error = sum(plane(self.path("x.error.pfm"))[2], ())
                self.assertAlmostEqual(sum(samples) / len(samples), stats["spp_mean"], 9)
                self.assertEqual((min(samples), max(samples)), (stats["spp_min"], stats["spp_max"]))
                rms = (sum(e * e for e in error) / len(error)) ** 0.5
                self.assertAlmostEqual(rms + stats["cut_error_bound"], stats["error_estimate"], 8)
        self.run_project("scene.lua", "-q", "--spp", "1", "--aov", "error", "-o", "x.png")
        self.assertEqual(set(sum(plane(self.path("x.error.pfm"))[2], ())), {float("inf")})

    def test_an_exr_holds_the_planes_as_layers(self):
        self.write("ball.lua", BALL)
        ball = ("ball.lua", "-q", "--spp", "4", "--size", "40x35")
        channels = {"depth": "Z", "normal": "XYZ", "albedo": "RGB", "position": "XYZ", "id": "X", "uv": "UV",
                    "samples": "Y", "error": "Y"}
        self.run_project(*ball, "--aov", ",".join(channels), "-o", "layers.exr")
        self.run_project(*ball, "--aov", ",".join(channels), "-o", "files.pfm")
        self.run_project(*ball, "-o", "plain.exr")
        self.assertIn(b"RMSE        0\n", self.run_project("compare", "layers.exr", "plain.exr").stdout)
        layers = exr_channels(self.read("layers.exr"))
        self.assertEqual(len(layers), 3 + sum(map(len, channels.values())))
        for name, parts in channels.items():
            width, height, rows = plane(self.path("files.%s.pfm" % name))
            step = len(rows[0]) // width
            for c, part in enumerate(parts):
                with self.subTest(name + "." + part):
                    self.assertEqual(layers[name + "." + part], [row[i] for row in rows for i in range(c, step * width, step)])
        _, _, rows = pfm(self.path("files.pfm"))
        self.assertEqual(layers["G"], [pixel[1] for row in rows for pixel in row])

    def test_several_renders_and_folders_that_are_missing(self):
        self.write("scene.lua", BALL + BALL.replace("ball.png", "made/deeper/ball.png"))
        self.run_project("scene.lua", "-q")
        self.assertEqual(self.read("ball.png"), self.read("made/deeper/ball.png"))

    def test_numbered_output_for_several_renders(self):
        self.write("scene.lua", BALL + BALL)
        self.run_project("scene.lua", "-q", "-o", "image##.png")
        self.assertTrue(os.path.exists(self.path("image01.png")) and os.path.exists(self.path("image02.png")))
        done = self.run_project("scene.lua", "-q", "-o", "same.png", code=2)
        self.assertIn(b"#", done.stderr)

    def test_frames_run_the_script_once_each(self):
        self.write("scene.lua", BALL.replace("'ball.png'", "string.format('f%d-%.2f.png', gr.frame, gr.time)"))
        self.run_project("scene.lua", "-q", "--spp", "1", "--frames", "3-5")
        for name in "f3-0.00.png", "f4-0.50.png", "f5-1.00.png":
            self.assertTrue(os.path.exists(self.path(name)), name)

    def test_snapshots(self):
        self.write("scene.lua", BALL + """
            local root = gr.node('r')
            local ball = gr.sphere('s')
            root:add_child(ball, gr.material({1, 1, 1}, {0, 0, 0}, 0))
            local function shot(name)
                gr.render(root, name, 32, 32, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 50, {1, 1, 1}, {})
            end
            shot('a.pfm')
            ball:translate(100, 0, 0)
            shot('b.pfm')
            ball:translate(-100, 0, 0)
            shot('c.pfm')""")
        self.run_project("scene.lua", "-q")
        self.assertEqual(self.read("a.pfm"), self.read("c.pfm"))
        self.assertNotEqual(self.read("a.pfm"), self.read("b.pfm"))

    def test_a_scene_from_stdin_to_stdout(self):
        done = self.run_project("-", "-q", "-o", "-", stdin=BALL.encode() + b"print('a word')")
        self.assertTrue(done.stdout.startswith(b"\x89PNG"), done.stdout[:20])
        self.assertIn(b"a word", done.stderr)

    def test_time_limit_ends_a_render_that_would_take_long(self):
        self.write("scene.lua", EVERYTHING)
        began = time.time()
        self.run_project("scene.lua", "-q", "--time", "0.5", "--size", "640x480", "--stats", "s.json")
        self.assertLess(time.time() - began, 60)
        render = json.loads(self.read("s.json"))["renders"][0]
        self.assertGreaterEqual(render["spp_max"], 1)

    NOT_FINITE = BALL.replace("{0.8, 0.8, 0.8}, {1, 0, 0}", "{1e308, 1e308, 1e308}, {1e-300, 0, 0}")

    def test_a_light_too_bright_for_numbers_is_reported(self):
        self.write("scene.lua", self.NOT_FINITE)
        done = self.run_project("scene.lua")
        self.assertIn(b"not finite", done.stderr)


class Scenes(EndToEnd):
    """The project's own scenes: no warning, and the one that has everything against the slow truth."""

    def test_every_scene_and_example_renders_without_a_warning(self):
        scenes = glob.glob(os.path.join(TOP, "scenes", "*.lua"))
        scenes += glob.glob(os.path.join(TOP, "scenes", "objectives", "*.lua"))
        examples = glob.glob(os.path.join(TOP, "Documentation", "examples", "*.lua"))
        self.assertGreater(len(scenes), 30)
        self.assertGreater(len(examples), 25)
        for scene in scenes + examples:
            if os.path.basename(scene) == "stage.lua":
                continue
            with self.subTest(scene):
                # The examples find what they show in the assets of the folder that they are run in.
                done = subprocess.run([PROJECT, scene, "-q", "--werror", "--size", "32x18", "--spp", "1",
                                       "-o", self.path("x.png")], cwd=TOP, capture_output=True, timeout=300)
                self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_the_twin_of_every_objective_renders_without_a_warning(self):
        for scene in glob.glob(os.path.join(TOP, "scenes", "objectives", "*.lua")):
            # One thread instead of several is no matter of the script.
            if os.path.basename(scene) == "multithreading.lua":
                continue
            with self.subTest(scene):
                done = subprocess.run([PROJECT, scene, "-q", "--werror", "--size", "32x18", "--spp", "1", "-D",
                                       "without=true", "-o", self.path("x.png")], cwd=TOP, capture_output=True, timeout=300)
                self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_the_scene_with_everything_is_the_slow_truth_but_for_what_was_cut(self):
        scene = os.path.join(TOP, "scenes", "everything.lua")
        common = [scene, "-q", "--size", "48x27", "--spp", "16"]
        self.run_project(*common, "--stats", "stats.json", "-o", "fast.pfm")
        self.run_project(*common, "--reference", "-j", "1", "--isa", "baseline", "-o", "truth.pfm")
        render = json.loads(self.read("stats.json"))["renders"][0]
        for feature in ("reflection refraction lens meshes lights".split() +
                        ["textures and bump maps", "area lights", "background image", "transparent shadows", "absorption", "light kinds", "motion blur",
                         "combined solids"]):
            self.assertIn(feature, render["features"])
        # Where nodes move there are no caustics.
        self.assertEqual([skipped["what"] for skipped in render["skipped"]], ["a choice of lights at each point", "photons"])
        (_, _, fast), (_, _, truth) = pfm(self.path("fast.pfm")), pfm(self.path("truth.pfm"))
        # In the mean over the picture: averaged textures have less noise than the truth's samples, pixel by pixel.
        # They may be off by a third of the default error.
        means = [[sum(pixel[channel] for row in picture for pixel in row) / (48 * 27) for channel in range(3)]
                 for picture in (fast, truth)]
        for a, b in zip(*means):
            self.assertLessEqual(abs(a - b), render["cut_error_bound"] + 1e-3)
        self.assertLess(render["cut_error_bound"], 1e-2)

class Shards(EndToEnd):
    SIZE = ("--size", "70x50")

    def setUp(self):
        super().setUp()
        self.write("scene.lua", EVERYTHING)

    def merged(self, count, *words):
        parts = []
        for i in range(1, count + 1):
            self.run_project("scene.lua", "-q", *self.SIZE, *words, "--shard", "%d/%d" % (i, count), "-o", "m.png",
                             "-j", str(1 + i % 3))
            parts.append("m.%d-of-%d.part" % (i, count))
        return parts

    def test_shards_have_the_bytes_of_the_whole_in_every_format(self):
        aov = ("--aov", "depth,uv,samples,error")
        for words in (("--spp", "4"), ("--error", "0.03"), ("--spp", "3", "--crop", "5,9,50,47", "--seed", "7"),
                      ("--error", "0.03", "--crop", "5,9,50,47"), ("--spp", "1", "--cutoff", "0.1")):
            parts = self.merged(3, *words, *aov)
            for ending in "png", "exr", "pfm", "hdr", "tif":
                with self.subTest(" ".join(words) + " " + ending):
                    self.run_project("scene.lua", "-q", *self.SIZE, *words, *aov, "-o", "w." + ending)
                    self.run_project("merge", "m." + ending, *reversed(parts))
                    self.assertEqual(self.read("w." + ending), self.read("m." + ending))
                    for name in aov[1].split(",") if ending != "exr" else ():
                        self.assertEqual(self.read("w.%s.pfm" % name), self.read("m.%s.pfm" % name))

    def test_more_shards_than_tiles_are_as_good(self):
        parts = self.merged(23, "--spp", "2", "--bits", "16")
        self.run_project("scene.lua", "-q", *self.SIZE, "--spp", "2", "--bits", "16", "-o", "w.png")
        self.run_project("merge", "m.png", *parts)
        self.assertEqual(self.read("w.png"), self.read("m.png"))

    def test_a_shard_renders_its_own_tiles_only(self):
        rays = []
        for i in "1", "2":
            self.run_project("scene.lua", "-q", *self.SIZE, "--spp", "2", "--shard", i + "/2", "-o", "m.png", "--stats", "s")
            stats = json.loads(self.read("s"))["renders"][0]
            rays.append(stats["rays"]["camera"])
            self.assertEqual((stats["spp_min"], stats["spp_max"]), (2, 2))
        self.assertEqual(sum(rays), 70 * 50 * 2)
        self.assertLess(max(rays) - min(rays), 70 * 50 / 2)

    def test_a_task_that_runs_again_writes_the_same_bytes_from_any_folder(self):
        self.merged(2, "--spp", "1")
        first = self.read("m.1-of-2.part")
        self.write("elsewhere/scene.lua", EVERYTHING)
        os.chdir(self.path("elsewhere"))
        self.addCleanup(os.chdir, TOP)
        self.run_project("scene.lua", "-q", *self.SIZE, "--spp", "1", "--shard", "1/2", "-o", "again.part")
        self.assertEqual(first, self.read("again.part"))

    def test_an_interrupted_shard_is_not_written(self):
        child = subprocess.Popen([PROJECT, "scene.lua", "--spp", "100000", "--shard", "1/2"], cwd=self.folder,
                                 stderr=subprocess.PIPE)
        self.assertIn(b"Threads", child.stderr.readline())
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        errors = child.communicate()[1]
        self.assertEqual(child.returncode, 130)
        self.assertIn(b"not written", errors)
        left = [name for name in os.listdir(self.folder) if not name.endswith(".checkpoint")]
        self.assertEqual(left, ["scene.lua"])

    def test_damage_is_found_wherever_it_is(self):
        parts = self.merged(2, "--spp", "1", "--size", "20x20")
        whole = self.read(parts[0])
        damaged = [whole[:i] for i in range(0, len(whole), 1009)]
        for i in [*range(0, 120, 3), *range(120, len(whole), 997)]:
            damaged.append(whole[:i] + bytes([whole[i] ^ 1 << i % 8]) + whole[i + 1:])
        for data in damaged:
            with open(self.path(parts[0]), "wb") as f:
                f.write(data)
            self.assertIn(b"m.1-of-2.part", self.run_project("merge", "m.png", *parts, code=1).stderr)
        self.assertFalse(os.path.exists(self.path("m.png")))


class Golden(EndToEnd):
    """The golden command: what passes, what fails, and what it writes."""

    def make(self, extra=""):
        self.write("set/ball.lua", "gr.options{spp = 4}\nlocal at = gr.param('at', 0)\n" + extra +
                   BALL.replace("gr.sphere('ball')", "gr.nh_sphere('ball', {at, 0, 0}, 1)"))

    def golden(self, *args, code=0):
        done = self.run_project("golden", "set", *args, code=code)
        return done.stdout.decode()

    def test_a_reference_is_made_then_passes_and_a_change_fails_with_a_report(self):
        self.make()
        self.assertIn("--update", self.golden(code=10))
        self.assertFalse(os.path.exists(self.path("set/ball.png")))
        self.assertIn("is written", self.golden("--update"))
        self.run_project("set/ball.lua", "-q", "-o", "alone.png")
        self.assertEqual(self.read("alone.png"), self.read("set/ball.png"))
        self.assertIn("ok   ball.png: exact", self.golden("--tier", "exact"))
        self.assertEqual(self.golden("-q").splitlines()[:-1], [])
        self.assertIn("FAIL ball.png", self.golden("-D", "at=0.05", code=10))
        page = self.read("golden_report/index.html").decode()
        for kind in "picture", "reference", "difference", "flip":
            self.assertIn("1_%s.png" % kind, page)
            self.assertTrue(self.read("golden_report/1_%s.png" % kind).startswith(b"\x89PNG"))
        self.assertIn("changed", self.golden("--update", "-D", "at=0.05"))
        self.golden("-D", "at=0.05")
        before = os.stat(self.path("set/ball.png")).st_mtime_ns
        self.assertIn("unchanged", self.golden("--update", "-D", "at=0.05"))
        self.assertEqual(os.stat(self.path("set/ball.png")).st_mtime_ns, before)

    def test_references_that_cannot_be_compared_fail_and_say_why(self):
        self.make()
        self.golden("--update")
        good = self.read("set/ball.png")
        self.run_project("set/ball.lua", "-q", "--bits", "16", "-o", "bits.png")
        for name, bytes_, words in [("half a file", good[:len(good) // 2], "ball.png"), ("nothing", b"", "ball.png"),
                                    ("no image", b"text", "ball.png"), ("bits", self.read("bits.png"), "bits")]:
            with self.subTest(name), open(self.path("set/ball.png"), "wb") as f:
                f.write(bytes_)
                f.flush()
                self.assertIn(words, self.golden(code=10).splitlines()[0])
        with open(self.path("set/ball.png"), "wb") as f:
            f.write(good)
        self.assertIn("the sizes differ", self.golden("--size", "32x24", code=10))
        self.golden()

    def test_floats_and_values_that_are_not_numbers(self):
        self.write("set/ball.lua", "gr.options{spp = 1}\n" + BALL.replace("ball.png", "ball.pfm"))
        self.golden("--update")
        self.golden("--tier", "exact")
        reference = self.read("set/ball.pfm")
        with open(self.path("set/ball.pfm"), "wb") as f:
            f.write(reference[:-4] + struct.pack("<f", float("nan")))
        self.assertIn("not finite", self.golden(code=10))
        self.assertIn("not finite", self.golden("--tier", "statistical", code=10))

    def test_samples_that_are_not_finite_fail_and_are_not_written(self):
        self.write("set/nan.lua", Rendering.NOT_FINITE)
        self.assertIn("not finite", self.golden("--update", "--spp", "1", code=10))
        self.assertFalse(os.path.exists(self.path("set/ball.png")))

    def test_one_failure_does_not_stop_the_others_and_its_code_is_the_first(self):
        self.make()
        self.write("set/a_broken.lua", "x = = 1")
        self.write("set/helper.lua", "return {}")
        out = self.golden("--update", code=1)
        self.assertIn("FAIL set/a_broken.lua", out)
        self.assertIn("ok   ball.png", out)
        os.remove(self.path("set/a_broken.lua"))
        self.write("set/copy.lua", BALL)
        self.assertIn("reference is that of another image", self.golden("--spp", "4", code=10))

    def test_a_folder_without_scenes_fails(self):
        os.mkdir(self.path("set"))
        self.golden(code=2)
        self.write("set/helper.lua", "return {}")
        self.golden(code=2)
        self.run_project("golden", "nowhere", code=1)

    def test_a_scene_with_a_time_is_compared_by_its_statistics(self):
        self.write("set/timed.lua", "gr.options{time = 0.4, bits = 16}\nlocal shift = gr.param('shift', 0)\n" +
                   EVERYTHING.replace("{5, 8, 5}", "{5 + shift, 8, 5}"))
        self.golden("--update")
        self.assertIn("ok   everything.png: statistical", self.golden())
        self.assertIn("standard deviations", self.golden("-D", "shift=-9", code=10))


class Comparing(EndToEnd):
    def test_every_format_is_read_and_holds_the_same_picture(self):
        self.write("scene.lua", BALL)
        names = ["a.png", "a.tif", "a.exr", "a.hdr", "a.pfm"]
        for name in names:
            self.run_project("scene.lua", "-q", "--spp", "4", "--bits", "16", "-o", name)
        for a in names:
            for b in names:
                # The mantissas of .hdr have 8 bits.
                tolerance = "0" if a == b else "0.005" if "a.hdr" in (a, b) else "0.00001"
                done = self.run_project("compare", a, b, "--tolerance", tolerance)
                for line in b"RMSE", b"mean", b"max", b"over 4/255", b"FLIP":
                    self.assertIn(line, done.stdout)
        self.run_project("scene.lua", "-q", "--spp", "4", "--size", "32x24", "-o", "b.png")
        self.run_project("compare", "a.png", "b.png", code=10)


class Failures(EndToEnd):
    CASES = [
        # name, script, arguments, exit code, fragments of stderr
        ("missing scene", None, ["nothing.lua"], 1, ["nothing.lua", "No such file"]),
        ("unknown flag", BALL, ["scene.lua", "--treads", "2"], 2, ["--threads"]),
        ("bad size", BALL, ["scene.lua", "--size", "0x10"], 2, ["size"]),
        ("spp with error", BALL, ["scene.lua", "--spp", "4", "--error", "0.1"], 2, ["--spp"]),
        ("syntax error", "x = = 1", ["scene.lua"], 1, ["scene.lua:1", "near"]),
        ("wrong argument", "gr.nh_sphere('s', {0,0,0}, -1)", ["scene.lua"], 1,
         ["scene.lua:1", "gr.nh_sphere", "radius must be > 0", "-1"]),
        ("misspelt call", "\ngr.sphear('s')", ["scene.lua"], 1, ["scene.lua:2", "sphere"]),
        ("no material", "r = gr.node('r') r:add_child(gr.sphere('bare'))\n"
         "gr.render(r, 'x.png', 8, 8, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})", ["scene.lua"], 1,
         ["scene.lua:1", "bare", "material"]),
        ("missing mesh", "gr.mesh('m', 'cow.obj')", ["scene.lua"], 1, ["scene.lua:1", "cow.obj"]),
        ("broken mesh", "m = gr.mesh('m', 'broken.obj') m:set_material(gr.material({1,1,1},{0,0,0},0))\n"
         "gr.render(m, 'x.png', 8, 8, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})", ["scene.lua"], 1,
         ["broken.obj:4", "vertex 9 of 3", "scene.lua:1"]),
        ("broken texture", "s = gr.sphere('s') s:set_texture(gr.texture('broken.png', {0,0,0}, 0))\n"
         "gr.render(s, 'x.png', 8, 8, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})", ["scene.lua"], 1,
         ["broken.png", "scene.lua:1"]),
        ("cycle", "a = gr.node('a') b = gr.node('b') a:add_child(b)\nb:add_child(a)", ["scene.lua"], 1,
         ["scene.lua:2", "cycle"]),
        ("too many pixels", BALL.replace("64, 48", "40000, 40000"), ["scene.lua"], 4, ["--max-pixels"]),
        ("too many instances", "n = gr.sphere('s') n:set_material(gr.material({1,1,1},{0,0,0},0))\n"
         "for i = 1, 40 do local p = gr.node('p') p:add_child(n) p:add_child(n) n = p end\n"
         "gr.render(n, 'x.png', 8, 8, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})", ["scene.lua"], 4,
         ["--max-instances"]),
        ("endless script", "while true do end", ["scene.lua", "--script-time", "0.3"], 4, ["scene.lua:1", "--script-time"]),
        ("too much memory", "local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000) .. i end",
         ["scene.lua", "--script-memory", "32M"], 4, ["--script-memory"]),
        ("output into nowhere", BALL, ["scene.lua", "-o", "/proc/nowhere/x.png"], 3, ["/proc/nowhere"]),
        ("output over its own scene", BALL, ["scene.lua", "-o", "scene.lua"], None, ["scene.lua"]),
        ("unknown extension", BALL, ["scene.lua", "-o", "x.xyz"], None, ["xyz"]),
        ("unknown instruction set", BALL, ["scene.lua", "--isa", "mmx"], 2, ["isa"]),
        ("outside of the folder", "dofile('../x.lua')", ["scene.lua"], 1, ["scene.lua:1"]),
        ("writing", "io.open('x', 'w')", ["scene.lua"], 1, ["scene.lua:1", "--trust"]),
        ("script output outside", BALL.replace("ball.png", "../ball.png"), ["scene.lua"], None, ["../ball.png"]),
    ]

    def test_failures_say_what_where_and_what_would_be_right(self):
        self.write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
        self.write("broken.png", "\x7fno image")
        for name, script, arguments, code, fragments in self.CASES:
            with self.subTest(name):
                if script is not None:
                    self.write("scene.lua", script)
                done = self.run_project(*arguments, code=None)
                text = done.stderr.decode(errors="replace")
                if code is None:
                    self.assertIn(done.returncode, (1, 2, 3), text)
                else:
                    self.assertEqual(done.returncode, code, text)
                for fragment in fragments:
                    self.assertIn(fragment, text)
                self.assertFalse(os.path.exists(os.path.join(self.folder, "..", "ball.png")))

    def test_verbose_shows_the_stack(self):
        self.write("scene.lua", "local function inner() error('no') end\nlocal function outer() inner() end\nouter()")
        quiet = self.run_project("scene.lua", code=1)
        self.assertNotIn(b"traceback", quiet.stderr)
        verbose = self.run_project("scene.lua", "-v", code=1)
        self.assertIn(b"traceback", verbose.stderr)
        self.assertIn(b"scene.lua:2", verbose.stderr)

    def test_one_bad_scene_does_not_stop_the_others(self):
        self.write("bad.lua", "x = = 1")
        self.write("good.lua", BALL)
        done = self.run_project("bad.lua", "good.lua", code=1)
        self.assertTrue(os.path.exists(self.path("ball.png")))
        self.assertEqual(done.stderr.decode().splitlines()[-2:],
                         ["bad.lua: failed with exit code 1, 0 images", "good.lua: done, 1 image"])
        os.remove(self.path("ball.png"))
        done = self.run_project("bad.lua", "good.lua", "--fail-fast", code=1)
        self.assertIn(b"\ngood.lua: not tried\n", done.stderr)
        self.assertFalse(os.path.exists(self.path("ball.png")))

    def test_werror_turns_warnings_into_failure(self):
        self.write("scene.lua", BALL.replace("{1, 0, 0})})", "{0, 0, 0})})"))
        done = self.run_project("scene.lua", "-q")
        self.assertIn(b"warning", done.stderr)
        self.run_project("scene.lua", "-q", "--werror", code=1)

    def test_an_interrupt_saves_what_there_is(self):
        self.write("scene.lua", EVERYTHING)
        running = subprocess.Popen([PROJECT, "scene.lua", "--spp", "100000", "-o", "out.png"], cwd=self.folder,
                                   stderr=subprocess.PIPE)
        time.sleep(1.5)
        began = time.time()
        running.send_signal(signal.SIGINT)
        running.communicate(timeout=120)
        self.assertEqual(running.returncode, 130)
        self.assertTrue(os.path.exists(self.path("out.partial.png")))
        self.assertFalse(os.path.exists(self.path("out.png")))
        self.assertLess(time.time() - began, 10)


def main():
    global PROJECT
    if sys.argv[1:2] in ([], ["--help"]):
        sys.exit(__doc__)
    PROJECT = EndToEnd.project = os.path.abspath(sys.argv[1])
    suite = unittest.TestSuite()
    cases = [Threads, SameBytes, Rendering, OnTerminal, Scenes, Shards, Dependencies, Watching, Previewing,
             Documents, Parameters, Installing, OnePixel, Walkthroughs, Batches, Golden, Comparing, Failures]
    if sys.argv[2:3] == ["--only"]:
        cases = [case for case in cases if case.__name__.lower() in sys.argv[3:]]
    for case in cases:
        suite.addTests(unittest.defaultTestLoader.loadTestsFromTestCase(case))
    result = unittest.TextTestRunner(verbosity=1).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
