"""A12 and K: shards of a picture, and joining them."""
import os

from harness import BALL, Case

QUIET = ("-q", "--spp", "1")


def shell(script):
    """A script after shards 1/2 and 2/2 of scene.lua went to m.1-of-2.part and m.2-of-2.part; $P is the program."""
    def command(project, folder):
        both = "'$P' scene.lua -q --spp 1 -o m.png --shard 1/2 && '$P' scene.lua -q --spp 1 -o m.png --shard 2/2 && "
        return ["bash", "-c", (both + script).replace("$P", project)]
    return command


def merge(ids, name, before, parts, code, says, **more):
    return Case(ids, name, BALL, code=code, says=says, command=shell(before + "'$P' merge x.png " + parts), **more)


def like_the_whole(run):
    if run.read("whole.png") != run.read("x.png"):
        yield "the merged image is not the whole one"


def unwritten(run):
    if [name for name in os.listdir(run.folder) if name.endswith(".part")]:
        yield "a part was written"


CASES = [
    *[Case("A12", "--shard " + s, BALL, ("scene.lua", *QUIET, "--shard", s), 2, "--shard.*i/n", also=unwritten)
      for s in ("5/4", "0/4", "-1/4", "1/0", "1", "a/b", "1/2/3", "", "1/1000001", "1.5/2")],
    Case("A12", "--shard with --time", BALL, ("scene.lua", "-q", "--time", "1", "--shard", "1/2"), 2, "--shard.*--time",
         also=unwritten),
    Case("A12", "a shard of a scene from stdin", None, ("-", *QUIET, "--shard", "1/2"), 1, "standard input",
         stdin=BALL.encode(), also=unwritten),
    Case("A12", "merge without parts", BALL, ("merge", "x.png"), 2, "merge"),
    merge("K4", "a missing shard", "", "m.1-of-2.part", 1, "missing of 2 shards: 2"),
    merge("K4", "a missing file", "", "m.1-of-2.part m.3-of-2.part", 1, r"m\.3-of-2\.part.*No such file"),
    merge("K4", "another seed", "'$P' scene.lua -q --spp 1 --seed 5 --shard 2/2 -o other.png && ",
          "m.1-of-2.part other.2-of-2.part", 1, r"other\.2-of-2\.part: error: its seed is 5"),
    merge("K4", "another size", "'$P' scene.lua -q --spp 1 --size 9x6 --shard 2/2 -o other.png && ",
          "m.1-of-2.part other.2-of-2.part", 1, r"other\.2-of-2\.part: error: .*size is 9x6"),
    merge("K4", "another number of shards", "'$P' scene.lua -q --spp 1 --shard 2/3 -o other.png && ",
          "m.1-of-2.part other.2-of-3.part", 1, r"other\.2-of-3\.part: error: the number of shards is 3"),
    merge("K4", "another scene", "echo >> scene.lua; '$P' scene.lua -q --spp 1 --shard 2/2 -o other.png && ",
          "m.1-of-2.part other.2-of-2.part", 1, r"other\.2-of-2\.part: error: it is of another scene"),
    merge("K4", "other options", "'$P' scene.lua -q --spp 2 --shard 2/2 -o other.png && ",
          "m.1-of-2.part other.2-of-2.part", 1, r"other\.2-of-2\.part: error: it is of another scene"),
    merge("K4", "a double shard with the same bytes", "cp m.1-of-2.part again.part && ",
          "m.1-of-2.part again.part m.2-of-2.part", 0, r"again\.part: warning: shard 1 is also in m\.1-of-2\.part",
          writes="x.png"),
    merge("K4", "a damaged part", "printf x | dd of=m.2-of-2.part bs=1 seek=300 conv=notrunc status=none && ",
          "m.1-of-2.part m.2-of-2.part", 1, r"m\.2-of-2\.part: error: the part is damaged"),
    merge("K4", "a part of another version", "printf 'RTPART9' | dd of=m.2-of-2.part bs=1 conv=notrunc status=none && ",
          "m.1-of-2.part m.2-of-2.part", 1, r"m\.2-of-2\.part: error: .*another version"),
    merge("K4", "an image for a part", "", "m.1-of-2.part scene.lua", 1, r"scene\.lua: error: not a part"),
    Case("K4", "a part for the output", BALL, code=2, says="m.1-of-2.part",
         command=shell("'$P' merge m.1-of-2.part m.1-of-2.part m.2-of-2.part")),
    Case("K4", "an output of an unknown kind", BALL, code=3, says="unknown extension",
         command=shell("'$P' merge x.xyz m.1-of-2.part m.2-of-2.part")),
    merge("K5", "shards merged", "'$P' scene.lua -q --spp 1 -o whole.png && ", "m.2-of-2.part m.1-of-2.part", 0, (),
          also=like_the_whole),
    merge("K9", "a task that runs again over what it left", "head -c 99 m.1-of-2.part > m.1-of-2.part.tmp-1-1; head -c 50 m.1-of-2.part "
          "> cut && mv cut m.1-of-2.part && '$P' scene.lua -q --spp 1 -o m.png --shard 1/2 && '$P' scene.lua -q --spp 1 "
          "-o whole.png && ", "m.1-of-2.part m.2-of-2.part", 0, (), also=like_the_whole),
]
