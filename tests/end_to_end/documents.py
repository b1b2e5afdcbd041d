"""What --print prints is right for the tools that read it."""
import os, shutil, subprocess, unittest

from base import EndToEnd, TOP


class Documents(EndToEnd):
    def document(self, name):
        return self.run_project("--print", name).stdout.decode()

    def judged(self, *command, text=None):
        """what a tool says of a text, which must be nothing"""
        done = subprocess.run(command, input=text.encode(), capture_output=True, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout + done.stderr), (0, b""), command)

    def completed(self, *words):
        """what bash offers for the last word"""
        script = self.document("bash-completion") + """
            COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); compopt() { :; }
            _Project; printf '%s\\n' "${COMPREPLY[@]}" """
        done = subprocess.run(["bash", "-c", script, "bash", *words], capture_output=True, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        return sorted(done.stdout.decode().split())

    def test_the_stubs_are_lua(self):
        self.write("gr.lua", self.document("stubs"))
        self.judged("lua5.3", "gr.lua", text="")

    def test_the_reference_is_the_one_of_the_documentation(self):
        with open(os.path.join(TOP, "Documentation", "reference.md")) as f:
            self.assertEqual(self.document("reference"), f.read())

    @unittest.skipUnless(shutil.which("mandoc"), "mandoc is not installed")
    def test_mandoc_finds_nothing_wrong_with_the_manual_page(self):
        self.judged("mandoc", "-T", "lint", "-W", "warning", text=self.document("man"))

    def test_bash_completes_options_values_files_and_commands(self):
        self.judged("bash", "-n", text=self.document("bash-completion"))
        self.write("scene.lua", "")
        self.assertEqual(self.completed("Project", "--pre"), ["--preview", "--preview-port"])
        self.assertEqual(self.completed("Project", "--color", "a"), ["always", "auto"])
        self.assertEqual(self.completed("Project", "--color", "=", "n"), ["never"])
        self.assertEqual(self.completed("Project", "--color", "="), ["always", "auto", "never"])
        self.assertEqual(self.completed("Project", "sc"), ["scene.lua"])
        self.assertEqual(self.completed("Project", "-o", "sc"), ["scene.lua"])
        self.assertEqual(self.completed("Project", "me"), ["merge"])
        self.assertEqual(self.completed("Project", "compare", "--t"), ["--tolerance"])
        self.assertEqual(self.completed("Project", "--spp", ""), [])

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_its_completion(self):
        self.judged("zsh", "-n", text=self.document("zsh-completion"))

    def test_help_and_a_wrong_name(self):
        self.assertIn(b"Usage", self.run_project("--print", "man", "--help").stdout)
        self.assertIn(b"did you mean man?", self.run_project("--print", "mann", code=2).stderr)


class Parameters(EndToEnd):
    SCENE = """
local n = gr.param('n', 2, {min = 1, max = 9, doc = 'How many balls.'})
local title = gr.param('title', 'a b')
local root = gr.node(title)
for i = 1, n do root:add_child(gr.nh_sphere('ball ' .. i, {i, 0, 0}, 0.5), gr.material({1, 1, 1}, {0, 0, 0}, 0)) end
gr.render(root, 'balls.png', 8, 6, {0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 45, {1, 1, 1}, {})
"""

    def test_a_list_becomes_a_file_that_gives_the_same_picture(self):
        self.write("scene.lua", self.SCENE)
        listed = self.run_project("scene.lua", "-D", "n=5", "--list-params").stdout.decode()
        self.assertEqual(listed, "# How many balls.\nn = 5\ntitle = a b\n")
        self.write("five.params", listed)
        self.run_project("scene.lua", "-q", "-D", "n=5", "-o", "a.png")
        self.run_project("scene.lua", "-q", "--param-file", "five.params", "--deps", "b.d", "-o", "b.png")
        self.assertEqual(self.read("a.png"), self.read("b.png"))
        self.assertIn(b"five.params", self.read("b.d"))

    def test_an_unknown_name_is_an_error_at_its_line(self):
        self.write("scene.lua", self.SCENE)
        self.write("x.params", "# one too many\ntitel = c\n")
        said = self.run_project("scene.lua", "--param-file", "x.params", code=1).stderr
        self.assertIn(b"x.params:2: ", said)
        self.assertIn(b"did you mean 'title'?", said)
        self.assertIn(b"none.params", self.run_project("scene.lua", "--param-file", "none.params", code=1).stderr)

    def test_shards_of_other_parameters_are_of_another_picture(self):
        self.write("scene.lua", self.SCENE)
        for i in "12":
            self.write("x.params", "n = %s\n" % i)
            self.run_project("scene.lua", "-q", "--spp", "1", "--param-file", "x.params", "--shard", i + "/2", "-o",
                             "x.png")
        self.run_project("merge", "x.png", "x.1-of-2.part", "x.2-of-2.part", code=1)
