#!/usr/bin/env python3
"""resume_kills.py [--kills N] [--seed N] [--size WxH] [--project PATH]: kills renders at random moments, and goes on from them.

Each of N renders (100) is ended by a random signal (half of them kill -9) at a random moment between its start and
a little after the time that it takes, with random threads; one in three is killed again when it goes on. The last
run of each must end with the bytes of a render that was left alone, with no checkpoint and no temporary file left.
Prints a line for each kind of render and a sum; exit 1 where anything differs.
"""
import argparse, collections, os, random, re, signal, subprocess, sys, tempfile, time

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENE = """
root = gr.node('root')
white = gr.material({0.8, 0.8, 0.8}, {0.3, 0.3, 0.3}, 20)
glass = gr.sphere('glass') glass:set_refraction(1.5, 0.1) root:add_child(glass, white)
for i = 1, 30 do root:add_child(gr.nh_sphere('s' .. i, {i / 9 - 2, math.sin(i), -1}, 0.3), white) end
gr.render(root, 'x.png', 240, 180, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 50, {0.3, 0.3, 0.3},
          {gr.light({3, 5, 9}, {0.7, 0.7, 0.7}, {1, 0, 0}, 1), gr.light({-4, 2, 3}, {0.3, 0.3, 0.3}, {1, 0, 0})},
          gr.focal(5, 0.1, 0.2))
"""
KINDS = {"--spp": ["--spp", "48"], "--error": ["--error", "0.0015"], "--crop": ["--error", "0.0015", "--crop", "9,7,50,40"],
         "--shard": ["--spp", "80", "--shard", "2/3"]}
SIGNALS = [signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT]


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(10 ** 9))
    parser.add_argument("--size", default="240x180", help="of the pictures: smaller ones for slower builds")
    parser.add_argument("--project", default=os.path.join(TOP, "Project"))
    return parser.parse_args()


def run(project, folder, options, seconds=None, kill=signal.SIGTERM):
    """-> (exit code, messages); ended by `kill` after `seconds`."""
    process = subprocess.Popen([project, "scene.lua", *options], cwd=folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    try:
        return process.wait(seconds), process.stderr.read()
    except subprocess.TimeoutExpired:
        process.send_signal(kill)
        return process.wait(60), process.stderr.read()


def folder_with_scene(around):
    folder = tempfile.mkdtemp(dir=around)
    with open(os.path.join(folder, "scene.lua"), "w") as f:
        f.write(SCENE)
    return folder


def picture(folder):
    """The bytes of what was rendered, or None."""
    for name in "x.png", "x.2-of-3.part":
        if os.path.exists(os.path.join(folder, name)):
            with open(os.path.join(folder, name), "rb") as f:
                return f.read()


class Trial:
    def __init__(self, project, around, options, seconds, rng):
        self.project, self.options, self.seconds, self.rng = project, options, seconds, rng
        self.folder = folder_with_scene(around)
        self.kills, self.resumed = 0, False

    def go(self):
        """Renders, killed and gone on from. -> what is wrong, or None"""
        for _ in range(2 if self.rng.random() < 1 / 3 else 1):
            again = ["--resume", "--checkpoint", "0.05", "-j", str(self.rng.choice((1, 2, 3)))]
            code, messages = run(self.project, self.folder, self.options + again, self.rng.uniform(0, 1.1 * self.seconds),
                                 self.rng.choice(SIGNALS))
            if code == 0:
                break
            self.kills += 1
            if picture(self.folder):
                break  # ended after the picture was written
            if code not in (-signal.SIGKILL, 128 + signal.SIGTERM, 128 + signal.SIGINT, -signal.SIGTERM, -signal.SIGINT):
                return "exit code %d: %s" % (code, messages)
        code, messages = run(self.project, self.folder, self.options + ["--resume", "-j", "2"])
        self.resumed = "Going on from" in messages
        if code != 0 or re.search("warning:|error:", messages):
            return "exit code %d of the last run: %s" % (code, messages)
        left = [name for name in os.listdir(self.folder) if name.endswith(".checkpoint") or ".tmp-" in name]
        return "left behind: %s" % left if left else None


def main():
    arguments = parse()
    project = os.path.abspath(arguments.project)
    rng = random.Random(arguments.seed)
    sums = collections.Counter()
    failures = []
    with tempfile.TemporaryDirectory() as around:
        wholes = {}
        kinds = {kind: options + ["--size", arguments.size] for kind, options in KINDS.items()}
        for kind, options in kinds.items():
            folder = folder_with_scene(around)
            began = time.monotonic()
            code, messages = run(project, folder, options + ["-j", "2"])
            if code:
                sys.exit("%s: exit code %d: %s" % (kind, code, messages))
            wholes[kind] = (picture(folder), time.monotonic() - began)
        number = 0
        while sums["kills"] < arguments.kills:
            kind = list(kinds)[number % len(kinds)]
            whole, seconds = wholes[kind]
            trial = Trial(project, around, kinds[kind], seconds, rng)
            wrong = trial.go() or (None if picture(trial.folder) == whole else "another picture")
            if wrong:
                failures.append("%s, render %d, --seed %d: %s" % (kind, number, arguments.seed, wrong))
                print(failures[-1], flush=True)
            number += 1
            sums["kills"] += trial.kills
            sums["resumed"] += trial.resumed
    print("%d kills in %d renders, %d of them gone on from a checkpoint, %d failed (--seed %d)"
          % (sums["kills"], number, sums["resumed"], len(failures), arguments.seed))
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
