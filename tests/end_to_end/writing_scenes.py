"""Seeing and iterating: the program on a terminal, --deps, --watch and --preview."""
import http.client, json, os, re, shutil, signal, socket, subprocess, time, unittest

from base import BALL, EVERYTHING, EndToEnd, TOP
from terminal import ESCAPE, bars, on_terminal

# Seconds from a signal to the end: one, and what a busy machine and a sanitizer may add.
PROMPT = 1.0 + 2.0


class OnTerminal(EndToEnd):
    """Standard error is a terminal, standard output is not."""

    def shown(self, *args, **more):
        self.write("scene.lua", EVERYTHING)
        code, out, shown = on_terminal([self.project, "scene.lua", *args], self.folder, **more)
        self.assertEqual(code, 0, shown)
        self.assertEqual(out, b"")
        return shown

    def test_a_bar_with_percent_error_and_time_left(self):
        shown = self.shown("--error", "0.004")
        drawn = bars(shown)
        percents = [int(bar.split("%")[0].split("]")[-1]) for bar in drawn]
        self.assertEqual(percents, sorted(percents))
        self.assertEqual(percents[-1], 100)
        self.assertTrue(any(re.fullmatch(r"\[=* *\] +\d+ %  error 0\.\d+  \d+:\d\d left", bar) for bar in drawn), drawn)
        self.assertRegex(shown, r"^Threads: \d+\r\n")
        self.assertRegex(ESCAPE.sub("", shown), r"\r\nRender Complete! everything.png in .*\r\n$")

    def test_the_bar_keeps_to_the_width_of_the_terminal(self):
        for columns, has_bar in (20, False), (34, True), (100, True):
            drawn = bars(self.shown("--spp", "2", columns=columns))
            self.assertLess(max(map(len, drawn)), columns)
            self.assertEqual(any("[" in bar for bar in drawn), has_bar)

    def test_colours_by_option_and_environment(self):
        for args, env, coloured in ((), {}, True), ((), {"NO_COLOR": "1"}, False), ((), {"NO_COLOR": ""}, True), \
                (("--color", "never"), {}, False), (("--color", "always"), {"NO_COLOR": "1"}, True):
            with self.subTest(args=args, env=env):
                self.assertEqual("\x1b[32m" in self.shown("--spp", "2", *args, env=env), coloured)

    def test_a_terminal_that_cannot_redraw_gets_plain_lines(self):
        shown = self.shown("--spp", "2", env={"TERM": "dumb"})
        self.assertNotIn("\x1b", shown)
        self.assertIn("\r\n100 %\r\n", shown)

    def test_the_image_on_stdout_is_free_of_progress(self):
        self.write("scene.lua", EVERYTHING)
        _, out, shown = on_terminal([self.project, "scene.lua", "--spp", "1", "-o", "-"], self.folder)
        self.assertTrue(out.startswith(b"\x89PNG") and out.endswith(b"IEND\xaeB`\x82"))
        self.assertIn("Render Complete!", shown)


class Dependencies(EndToEnd):
    """--deps, as make and ninja read it."""

    USING = """
        require 'lib.part one'
        local root = gr.node('root')
        root:add_child(gr.mesh('m', 'm$x #1.obj'), gr.material({1, 1, 1}, {0, 0, 0}, 0))
        root:add_child(gr.sphere('s'), nil, gr.texture('white.png', {0, 0, 0}, 0))
        gr.render(root, '%s', 4, 4, {0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 50, {1, 1, 1}, {})"""
    NEEDED = "using.lua", "lib/part one.lua", "m$x #1.obj", "white.png"

    def setUp(self):
        super().setUp()
        self.write("sky.lua", "gr.background({1, 1, 1})\n"
                   "gr.render(gr.node('n'), 'white.png', 4, 4, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})")
        self.run_project("sky.lua", "-q", "--spp", "1")
        os.remove(self.path("sky.lua"))
        self.write("using.lua", self.USING % "using.png")
        self.write("lib/part one.lua", "")
        self.write("m$x #1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

    def built(self, *command):
        """-> whether the image was made again"""
        before = os.stat(self.path("using.png")).st_mtime_ns if os.path.exists(self.path("using.png")) else None
        done = subprocess.run(command, cwd=self.folder, capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return os.stat(self.path("using.png")).st_mtime_ns != before

    def again_for_each_file(self, *command):
        self.assertTrue(self.built(*command))
        self.assertFalse(self.built(*command))
        for name in self.NEEDED:
            with self.subTest(name):
                later = time.time() + 2
                os.utime(self.path(name), (later, later))
                self.assertTrue(self.built(*command))
                os.utime(self.path(name), (1e9, 1e9))
                self.assertFalse(self.built(*command))

    def test_the_example_makefile_renders_what_changed(self):
        shutil.copy(os.path.join(TOP, "Documentation", "examples", "Makefile"), self.path("Makefile"))
        self.again_for_each_file("make", "PROJECT=" + self.project)
        # A module that is needed no more and gone does not stop make.
        self.write("using.lua", (self.USING % "using.png").replace("require 'lib.part one'", ""))
        os.remove(self.path("lib/part one.lua"))
        self.assertTrue(self.built("make", "PROJECT=" + self.project))

    @unittest.skipUnless(shutil.which("ninja"), "ninja is not installed")
    def test_ninja_renders_what_changed(self):
        self.write("build.ninja", "rule render\n  command = %s $in -q -o $out --deps $out.d\n  depfile = $out.d\n"
                   "  deps = gcc\nbuild using.png: render using.lua\n" % self.project)
        self.again_for_each_file("ninja")

    def test_a_failure_leaves_the_older_rules_and_a_check_writes_them(self):
        self.run_project("using.lua", "--check", "--deps", "d")
        rules = self.read("d")
        self.assertTrue(rules.startswith(b"using.png:"))
        self.write("bad.lua", "error('no')")
        self.run_project("using.lua", "bad.lua", "-q", "--deps", "d", code=1)
        self.assertEqual(self.read("d"), rules)
        self.run_project("using.lua", "-q", "--deps", "using.lua", code=2)
        self.run_project("using.lua", "-q", "--deps", "using.lua/d", code=3)


class Followed(EndToEnd):
    """The program while it runs."""

    QUIET = r"Watching \d+ files?;"

    def start(self, *args, command=()):
        time.sleep(0.05)  # what is written in the tick in which a run begins is read again
        self.said = open(self.path("said"), "wb+")
        self.addCleanup(self.said.close)
        self.running = subprocess.Popen([*command, self.project, *args], cwd=self.folder, stderr=self.said)
        self.addCleanup(self.running.communicate)
        self.addCleanup(self.running.kill)
        self.heard = 0

    def hear(self, pattern, seconds=30):
        """Waits for the next message of this form. -> the messages up to it"""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            with open(self.path("said"), errors="replace") as f:
                text = f.read()[self.heard:]
            found = re.search(pattern, text)
            if found:
                self.heard += found.end()
                return text[:found.end()]
            self.assertIsNone(self.running.poll(), text)
            time.sleep(0.02)
        self.fail("nothing like %r in %r" % (pattern, text[-2000:]))

    def interrupt(self):
        began = time.monotonic()
        self.running.send_signal(signal.SIGINT)
        self.running.communicate(timeout=30)
        self.assertEqual(self.running.returncode, 130)
        return time.monotonic() - began


class Watching(Followed):
    """--watch."""

    USING = """
        require 'part'
        local root = gr.node('root')
        root:add_child(gr.mesh('m', 'm.obj'), gr.material({1, 1, 1}, {0, 0, 0}, 0))
        root:add_child(gr.nh_box('s', {0, 0, -2}, 1), nil, gr.texture('t.png', {0, 0, 0}, 0))
        gr.render(root, 'x.png', 16, 16, {0, 0, 4}, {0, 0, -1}, {0, 1, 0}, 50, {grey, 1, 1}, {})"""
    MESH = "v %g 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    def texture(self, grey):
        self.write("sky.lua", "gr.background({%g, 1, 1})\n" % grey +
                   "gr.render(gr.node('n'), 't.png', 4, 4, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})")
        self.run_project("sky.lua", "-q", "--spp", "1")

    def prepare(self):
        self.texture(0.2)
        self.write("part.lua", "grey = 0.5")
        self.write("m.obj", self.MESH % 0)
        self.write("scene.lua", self.USING)

    def renders_again(self, name, text, rename=False):
        before = self.read("x.png")
        self.write(name + ".new" if rename else name, text)
        if rename:
            os.rename(self.path(name + ".new"), self.path(name))
        self.assertIn(os.path.basename(name), self.hear("Changed: .*"))
        self.hear(self.QUIET)
        self.assertNotEqual(self.read("x.png"), before, name)

    def test_scripts_modules_meshes_and_textures_are_watched(self):
        self.prepare()
        self.start("scene.lua", "--spp", "1", "--watch")
        self.hear(self.QUIET)
        self.renders_again("part.lua", "grey = 0.9")
        self.renders_again("m.obj", self.MESH % 0.5)
        self.renders_again("scene.lua", self.USING.replace("{1, 1, 1}", "{1, 0, 1}"), rename=True)
        before = self.read("x.png")
        self.texture(0.9)
        self.hear("Changed: .*t.png")
        self.hear(self.QUIET)
        self.assertNotEqual(self.read("x.png"), before)
        self.assertLess(self.interrupt(), PROMPT)

    def test_a_scene_alone_is_one_file(self):
        self.write("scene.lua", BALL)
        self.start("./scene.lua", "--spp", "1", "--watch")
        self.hear("Watching 1 file;")
        self.write("scene.lua", BALL + "-- changed")
        self.assertNotIn("...", self.hear("Changed: .*"))
        self.hear(self.QUIET)
        self.interrupt()

    def test_an_error_keeps_the_image_and_shows_its_line(self):
        self.prepare()
        self.start("scene.lua", "--spp", "1", "--watch")
        self.hear(self.QUIET)
        before = self.read("x.png")
        for bad, message in (("x = = 1", r"error: .*'='"), ("grey = 0.5\nerror('no')", r"part.lua:2: error: no"),
                             ("grey = 0.5\nrequire 'later'", r"part.lua:2: error: .*later")):
            self.write("part.lua", bad)
            self.hear(message)
            self.hear(self.QUIET)
            self.assertEqual(self.read("x.png"), before)
        # What was not found is looked out for, in folders that come later, too.
        self.write("later/init.lua", "grey = 0.1")
        self.hear("Changed: .*later/init.lua")
        self.hear("Render Complete!")
        self.hear(self.QUIET)
        self.write("m.obj", "v 0 0 0\nf 1 2 9\n")
        self.hear("m.obj:2: error")
        self.hear(self.QUIET)
        self.write("m.obj", self.MESH % 0.2)
        self.hear("Render Complete!")
        self.hear(self.QUIET)
        self.assertNotEqual(self.read("x.png"), before)
        os.remove(self.path("scene.lua"))
        self.hear("scene.lua: error: cannot be opened")
        self.write("scene.lua", self.USING)
        self.hear("Render Complete!")

    def test_a_change_during_a_render_starts_it_anew(self):
        self.write("scene.lua", EVERYTHING)
        self.start("scene.lua", "--spp", "1000000", "--watch", "-o", "x.png")
        self.hear("Threads")
        time.sleep(0.5)
        self.write("scene.lua", BALL + "-- another")
        said = self.hear("Changed: .*scene.lua")
        self.assertNotIn("Interrupted", said)
        time.sleep(0.3)
        self.assertLess(self.interrupt(), PROMPT)
        self.assertEqual(sorted(name for name in os.listdir(self.folder) if "png" in name), ["x.partial.png"])

    def test_an_image_of_one_scene_that_another_reads(self):
        sky = ("gr.background({%g, 1, 1})\n"
               "gr.render(gr.node('n'), 't.png', 4, 4, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})")
        self.texture(0.2)
        self.write("part.lua", "grey = 1")
        self.write("m.obj", self.MESH % 0)
        self.write("scene.lua", self.USING)
        self.write("sky.lua", sky % 0.2)
        for number, order in enumerate((("sky.lua", "scene.lua"), ("scene.lua", "sky.lua"))):
            self.start(*order, "--spp", "1", "--watch")
            self.hear(self.QUIET)
            before = self.read("x.png")
            time.sleep(0.5)
            self.assertNotIn("Changed", self.hear("$"))
            self.write("sky.lua", sky % (0.5 + 0.2 * number))
            self.hear("Changed: .*sky.lua")
            self.hear(self.QUIET)
            if order[0] == "sky.lua":
                self.assertNotEqual(self.read("x.png"), before)
            self.interrupt()

    def test_an_editor_that_empties_the_file_first(self):
        self.write("scene.lua", BALL)
        self.start("scene.lua", "--spp", "1", "--watch")
        self.hear(self.QUIET)
        with open(self.path("scene.lua"), "w") as f:
            f.flush()
            time.sleep(0.05)
            f.write(BALL.replace("0.8, 0.4, 0.2", "0.1, 0.9, 0.2"))
        said = self.hear(self.QUIET)
        self.assertIn("Render Complete!", said)
        self.assertNotIn("nothing was rendered", said)

    def test_where_the_kernel_gives_no_notices(self):
        without = ["unshare", "-Ur", "sh", "-c", "echo 0 > /proc/sys/user/max_inotify_instances && exec \"$@\"", "sh"]
        if subprocess.run([*without, "true"], capture_output=True).returncode != 0:
            self.skipTest("no user namespaces here")
        self.prepare()
        self.start("scene.lua", "--spp", "1", "--watch", command=without)
        self.hear(self.QUIET)
        self.renders_again("part.lua", "grey = 0.9")

    def test_one_mesh_that_is_wrong_fails_every_scene_that_uses_it(self):
        self.write("m.obj", "v 0 0 0\nf 1 2 9\n")
        for name in "a", "b":
            self.write(name + ".lua", "local r = gr.node('r') r:add_child(gr.mesh('m', 'm.obj'), gr.material({1,1,1}, {0,0,0}, 0))\n"
                       "gr.render(r, '%s.png', 4, 4, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {1,1,1}, {})" % name)
        done = self.run_project("a.lua", "b.lua", "--spp", "1", code=1)
        self.assertIn(b"b.lua: failed with exit code 1", done.stderr)


class Previewing(Followed):
    """--preview over HTTP; tests/browser/ looks at its page."""

    def open(self, *args, address=r"Preview: http://127.0.0.1:(\d+)/"):
        self.start(*args, "--preview", "--preview-port", "0")
        self.port = int(re.search(address, self.hear(address))[1])

    def ask(self, path, method="GET", host=None, body=None, **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.putrequest(method, path, skip_host=True)
        connection.putheader("Host", host or "127.0.0.1:%d" % self.port)
        for name, value in headers.items():
            connection.putheader(name.replace("_", "-"), value)
        connection.putheader("Content-Length", str(len(body or b"")))
        connection.endheaders(body)
        answer = connection.getresponse()
        content = answer.read()
        connection.close()
        return answer.status, answer.headers, content

    def status(self):
        return json.loads(self.ask("/status.json")[2])

    def wait_for(self, true, seconds=60):
        end = time.monotonic() + seconds
        while not true(self.status()):
            self.assertLess(time.monotonic(), end, self.status())
            time.sleep(0.05)

    def token(self):
        return re.search(r'name="token" content="([0-9a-f]{32})"', self.ask("/")[2].decode())[1]

    def test_an_image_refines_and_is_in_the_end_what_its_file_holds(self):
        self.write("scene.lua", EVERYTHING)
        self.open("scene.lua", "--spp", "600", "-o", "x.png", "--stats", "x.json")
        self.wait_for(lambda status: status["version"] > 0)
        status = self.status()
        self.assertTrue(status["running"])
        self.assertEqual((status["width"], status["height"], status["output"]), (80, 60, "x.png"))
        self.wait_for(lambda later: later["version"] > status["version"] and later["share"] > status["share"])
        self.wait_for(lambda status: not status["running"])
        for name in "image", "samples", "error":
            code, headers, content = self.ask("/map.png?map=" + name)
            self.assertEqual((code, headers["Content-Type"]), (200, "image/png"))
            with open(self.path(name + ".png"), "wb") as f:
                f.write(content)
        self.run_project("compare", "image.png", "x.png", "--tolerance", "0")
        self.run_project("compare", "samples.png", "error.png", "--tolerance", "0", code=10)
        pixel = json.loads(self.ask("/pixel.json?x=40&y=30")[2])
        self.assertEqual((pixel["x"], pixel["y"], pixel["samples"]), (40, 30, 600))
        self.assertEqual(len(pixel["value"]), 3)
        self.assertLess(0, self.status()["largestError"])
        # The same pixels as without anybody who looks on.
        self.run_project("scene.lua", "-q", "--spp", "600", "-o", "y.png", "--stats", "y.json")
        self.run_project("compare", "x.png", "y.png", "--tolerance", "0")
        errors = [json.loads(self.read(name))["renders"][0]["error_estimate"] for name in ("x.json", "y.json")]
        self.assertAlmostEqual(errors[0] / errors[1], 1, delta=1e-9)

    def test_towards_an_error_the_bytes_are_the_same_too(self):
        self.write("scene.lua", EVERYTHING)
        self.open("scene.lua", "--error", "0.002", "-o", "x.png")
        self.wait_for(lambda status: not status["running"])
        self.run_project("scene.lua", "-q", "--error", "0.002", "-o", "y.png")
        self.assertEqual(self.read("x.png"), self.read("y.png"))

    def test_strangers_are_refused(self):
        self.write("scene.lua", BALL)
        self.open("scene.lua", "--spp", "1")
        self.wait_for(lambda status: not status["running"])
        for host in "example.org", "example.org:%d" % self.port, "127.0.0.1", "127.0.0.1:1", "127.0.0.1.example.org:%d" % self.port:
            self.assertEqual(self.ask("/status.json", host=host)[0], 403, host)
        self.assertEqual(self.ask("/", host="localhost:%d" % self.port)[0], 200)
        self.assertEqual(self.ask("/status.json", Origin="http://example.org")[0], 403)
        self.assertEqual(self.ask("/status.json", Origin="http://127.0.0.1:%d" % self.port)[0], 200)
        for path in ("/../scene.lua", "/scene.lua", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/status.json/", "/x" * 500,
                     "/map.png?map=../x", "/pixel.json", "/pixel.json?x=1", "/pixel.json?x=64&y=0", "/pixel.json?x=1e1&y=0",
                     "/pixel.json?x=-1&y=0", "/pixel.json?x=99999999999&y=0"):
            self.assertEqual(self.ask(path)[0], 404, path)
        for method in "POST", "PUT", "DELETE", "OPTIONS":
            self.assertEqual(self.ask("/status.json", method)[0], 405, method)
        self.assertEqual(self.ask("/stop")[0], 405)
        self.assertEqual(self.ask("/stop", "POST")[0], 403)
        self.assertEqual(self.ask("/stop", "POST", X_Token="0" * 32)[0], 403)
        self.assertEqual(self.ask("/stop", "POST", X_Token="0" * 32, body=b"x" * 100000)[0], 403)
        headers = self.ask("/")[1]
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
        self.assertNotIn("Access-Control-Allow-Origin", headers)
        self.assertIsNone(self.running.poll())
        # Bound to the loopback address alone: no other of this machine's answers.
        with open("/proc/net/tcp") as f:
            listening = [line.split()[1] for line in f if line.split()[3] == "0A"]
        self.assertIn("0100007F:%04X" % self.port, listening)
        self.assertNotIn("00000000:%04X" % self.port, listening)

    def test_stop_saves_what_there_is_and_ends(self):
        self.write("scene.lua", EVERYTHING)
        self.open("scene.lua", "--error", "1e-7", "--max-spp", "1000000", "-o", "x.png")
        self.wait_for(lambda status: status["version"] > 0)
        self.assertEqual(self.ask("/stop", "POST", X_Token=self.token())[0], 200)
        self.running.communicate(timeout=20)
        self.assertEqual(self.running.returncode, 0)
        self.assertTrue(os.path.exists(self.path("x.partial.png")))

    def test_with_watch_the_page_tells_of_an_error_and_keeps_the_image(self):
        self.write("scene.lua", BALL)
        self.open("scene.lua", "--spp", "1", "--watch")
        self.hear(self.QUIET)
        self.assertEqual(self.status()["messages"], [])
        before = self.ask("/map.png")[2]
        self.write("scene.lua", BALL + "error('a wall is missing')")
        self.wait_for(lambda status: status["messages"] and not status["running"])
        self.assertRegex(self.status()["messages"][0], r"^scene.lua:\d+: error: a wall is missing")
        self.assertEqual(self.ask("/map.png")[2], before)
        self.write("scene.lua", BALL.replace("0.8, 0.4, 0.2", "0.1, 0.9, 0.2"))
        self.wait_for(lambda status: not status["messages"] and not status["running"])
        self.assertNotEqual(self.ask("/map.png")[2], before)
        self.assertLess(self.interrupt(), PROMPT)

    def test_a_port_in_use_and_a_missing_plugin_say_what_to_do(self):
        self.write("scene.lua", BALL)
        with socket.create_server(("127.0.0.1", 0)) as other:
            port = str(other.getsockname()[1])
            done = self.run_project("scene.lua", "--preview", "--preview-port", port, code=3)
        self.assertIn(b"error: --preview: port " + port.encode() + b" of 127.0.0.1: Address already in use; choose another",
                      done.stderr)
        os.link(self.project, self.path("alone")) if os.stat(self.project).st_dev == os.stat(self.folder).st_dev \
            else shutil.copy(self.project, self.path("alone"))
        done = subprocess.run([self.path("alone"), "scene.lua", "--preview"], cwd=self.folder, capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"install libmicrohttpd-dev", done.stderr)

    def test_a_plain_render_does_not_open_the_server(self):
        self.write("scene.lua", BALL)
        done = self.run_project("scene.lua", "-q", "--spp", "1", env={"LD_DEBUG": "files"})
        self.assertNotIn(b"rt_preview", done.stderr)
        self.assertNotIn(b"microhttpd", done.stderr)
