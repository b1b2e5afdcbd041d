"""What the suites of the program from outside share."""
import os, shutil, subprocess, tempfile, unittest

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

BALL = """
local root = gr.node('root')
root:add_child(gr.sphere('ball'), gr.material({0.8, 0.4, 0.2}, {0.3, 0.3, 0.3}, 20))
root:add_child(gr.nh_box('floor', {-5, -2, -5}, {10, 1, 10}), gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 0))
gr.render(root, 'ball.png', 64, 48, {0, 1, 5}, {0, -0.2, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {0.8, 0.8, 0.8}, {1, 0, 0})})
"""

# Everything that a path can meet, small: what determinism has to hold for.
EVERYTHING = """
gr.background({0.1, 0.1, 0.2}, {0.4, 0.5, 0.7})
local root = gr.node('root')
local grey = gr.material({0.6, 0.6, 0.6}, {0.2, 0.2, 0.2}, 30)
root:add_child(gr.nh_box('floor', {-6, -2, -6}, {12, 1, 12}), grey)
local glass = gr.nh_sphere('glass', {-1.2, 0, 1}, 1)
glass:set_refraction(1.5, 0.1)
glass:set_fresnel(true)
root:add_child(glass, grey)
local mirror = gr.nh_cylinder('mirror', {1.4, -1, -1}, 2.5, 0.8)
mirror:set_reflection(0.2)
root:add_child(mirror, gr.material({0.2, 0.3, 0.5}, {0.5, 0.5, 0.5}, 60))
local ring = gr.torus('ring', 0.7, 0.2)
ring:rotate('x', 70)
ring:translate(0.5, -0.6, 2)
root:add_child(ring, gr.material({0.8, 0.5, 0.1}, {0.5, 0.5, 0.5}, 40))
local cone = gr.nh_cone('cone', {0, -1, -2.5}, 2, 1)
root:add_child(cone, gr.material({0.2, 0.6, 0.3}, {0, 0, 0}, 0))
local tetra = gr.mesh('tetra', {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
tetra:rotate('y', 30)
tetra:translate(2, -1, 1.5)
root:add_child(tetra, gr.material({0.7, 0.2, 0.2}, {0.1, 0.1, 0.1}, 10))
gr.render(root, 'everything.png', 80, 60, {0, 1.5, 7}, {0, -0.3, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {0.6, 0.6, 0.6}, {1, 0, 0}, 0.8),
           gr.light({-6, 5, 3}, {0.3, 0.3, 0.3}, {1, 0, 0})},
          gr.focal({0, 0, 1}, 0.05, 0.05))
"""


class EndToEnd(unittest.TestCase):
    project = ""  # the executable

    def setUp(self):
        outside = tempfile.mkdtemp(prefix="rt-end-to-end-")
        self.addCleanup(shutil.rmtree, outside, ignore_errors=True)
        self.folder = os.path.join(outside, "inside")
        os.mkdir(self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w") as f:
            f.write(text)
        return name

    def run_project(self, *args, code=0, stdin=None, env=None):
        environment = dict(os.environ, **(env or {}))
        done = subprocess.run([self.project, *args], cwd=self.folder, input=stdin, capture_output=True, timeout=300,
                              env=environment)
        if code is not None:
            self.assertEqual(done.returncode, code, done.stderr.decode(errors="replace")[-3000:])
        return done

    def read(self, name):
        with open(self.path(name), "rb") as f:
            return f.read()
