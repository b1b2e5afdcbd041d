"""`make install` into a folder, and the program from there."""
import os, shutil, subprocess, unittest

from base import EndToEnd, TOP


@unittest.skipUnless(os.path.exists(os.path.join(TOP, "Project")), "the release build is not there")
class Installing(EndToEnd):
    def make(self, target):
        done = subprocess.run(["make", "-s", "config=release", target, "PREFIX=/opt/project", "DESTDIR=" + self.folder],
                              cwd=TOP, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr.decode()[-3000:])

    def installed(self):
        return sorted(os.path.relpath(os.path.join(folder, name), self.path("opt/project"))
                      for folder, _, names in os.walk(self.path("opt/project")) for name in names)

    def test_the_installed_program_renders_with_its_plugins_and_scenes(self):
        self.make("install")
        files = self.installed()
        for name in ("bin/Project", "lib/project/librt_oiio.so", "lib/project/librt_preview.so",
                     "share/man/man1/Project.1", "share/bash-completion/completions/Project",
                     "share/zsh/site-functions/_Project", "share/project/stubs/gr.lua", "share/project/README.md",
                     "share/project/Documentation/scene_language.md", "share/project/scenes/room.lua",
                     "share/project/tools/slurm_array.sh"):
            self.assertIn(name, files)
        # Elsewhere than the prefix says: the plugins lie by the program.
        shutil.move(self.path("opt/project"), self.path("moved"))
        self.project = self.path("moved/bin/Project")
        for scene in "first_light", "bump_map":
            self.run_project("moved/share/project/scenes/%s.lua" % scene, "-q", "--size", "40x30", "--spp", "1", "-o",
                             scene + ".exr")
            self.assertEqual(self.read(scene + ".exr")[:4], b"\x76\x2f\x31\x01")
        self.assertIn(b"stubs", self.run_project("--print", "man").stdout)

    def test_uninstall_leaves_no_file(self):
        self.make("install")
        self.make("uninstall")
        self.assertEqual(self.installed(), [])
