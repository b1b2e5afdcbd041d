#!/usr/bin/env python3
"""make_tutorial.py PROJECT: renders the pictures of Documentation/tutorial.md from its own snippets."""
import os, re, subprocess, sys, tempfile

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDER = os.path.join(TOP, "Documentation")
# What the pictures are made with.
OPTIONS = ["-q", "--werror", "--error", "0.003"]
LAST = "-- the picture"


class Tutorial:
    """What the page says, in its order.

    pictures: (name, parts of the script so far, parameters); mistakes: (script, message);
    commands: (words, parts, parameters)"""

    def __init__(self):
        with open(os.path.join(FOLDER, "tutorial.md")) as f:
            text = f.read()
        self.parts, self.parameters = {}, ""
        self.pictures, self.mistakes, self.commands = [], [], []
        pending = None
        for fence, block, picture, line in re.findall(
                r"^```(\w+)\n(.*?)^```$|^!\[[^\n]*\]\(([^\n]*)\)$|^    ([^\n]*)$", text, re.MULTILINE | re.DOTALL):
            if fence == "params":
                self.parameters = block
            elif fence and block.startswith("-- a mistake\n"):
                pending = self.script() + block
            elif fence:
                self.take(block)
            elif picture:
                self.pictures.append((picture, self.script(), self.parameters))
            elif pending:
                self.mistakes.append((pending, line))
                pending = None
            elif line.startswith("./Project "):
                self.commands.append((line.split()[1:], self.script(), self.parameters))

    def take(self, block):
        """parts begin with a comment at the start of a line; a new one goes before the picture"""
        for part in re.split(r"^(?=-- )", block, flags=re.MULTILINE):
            name = part.split("\n")[0]
            if part:
                self.parts[name] = part
        self.parts[LAST] = self.parts.pop(LAST)

    def script(self):
        return "\n".join(self.parts.values())


def put(folder, script, parameters):
    for name, text in ("lighthouse.lua", script), ("mine.params", parameters):
        with open(os.path.join(folder, name), "w") as f:
            f.write(text)


def render(project, folder, output, script, parameters):
    put(folder, script, parameters)
    more = ["--param-file", "mine.params"] if parameters else []
    subprocess.run([project, "lighthouse.lua", *OPTIONS, *more, "-o", output], cwd=folder, check=True)


def main():
    project = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        for name, script, parameters in Tutorial().pictures:
            render(project, folder, os.path.join(FOLDER, name), script, parameters)


if __name__ == "__main__":
    main()
