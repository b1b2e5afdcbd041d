#!/usr/bin/env python3
"""make_gallery.py [NAME...]: renders the gallery's pictures and writes Documentation/gallery.html.

Run it in the root, or through make_gallery.sh. With names, only the pictures of these scenes are rendered
again. PROJECT is the program (default ./Project). Needs python3-pil, for JPEG. Captions are the first comments of
the scripts. PNG files and statistics stay in build/gallery/.
"""
import html, json, os, re, subprocess, sys

try:
    from PIL import Image
except ImportError:
    sys.exit("make_gallery.py needs python3-pil")

PROJECT = os.environ.get("PROJECT", "./Project")
WORK = "build/gallery"
IMAGES = "Documentation/images/gallery"
PAGE = "Documentation/gallery.html"

# Errors by what a scene costs: the whole gallery is to take minutes.
COSTLY = {"multithreading", "refraction", "everything"}
OLD = ["--error", "0.005"]
OBJECTIVES = ["primitives", "bump_mapping", "multithreading", "supersampling", "phong_shading", "reflection",
              "refraction", "soft_shadow", "depth_of_field", "texture_mapping"]
EFFECTS = ["reflection", "refraction", "fresnel", "soft_shadow", "depth_of_field", "texture", "textured_floor", "bump_map",
           "phong_mesh", "supersampling", "primitives", "background", "instances", "parameters", "animation"]
OLD_SCENES = ["hier", "nonhier", "meadow", "village", "dodeca", "sponge", "simple"]


def options(size, name):
    return ["--size", size, "--error", "0.01" if name in COSTLY else "0.005"]


class Shot:
    """One run of the program: its picture or pictures, and what it said about them."""

    def __init__(self, scene, name, options, twin=False):
        self.scene, self.name, self.options, self.twin = scene, name, options, twin

    def render(self):
        print(self.name, flush=True)
        output = "%s/%s.png" % (WORK, self.name if self.name != "a4_simple" else self.name + "_#")
        subprocess.run([PROJECT, self.scene, "-q", "-o", output, "--stats", "%s/%s.json" % (WORK, self.name), *self.options],
                       check=True)
        for render in self.renders():
            with Image.open(render["output"]) as image:
                image.convert("RGB").save("%s/%s" % (IMAGES, self.picture(render)), quality=92, subsampling=0)

    def renders(self):
        with open("%s/%s.json" % (WORK, self.name)) as f:
            return json.load(f)["renders"]

    @staticmethod
    def picture(render):
        return os.path.basename(render["output"])[:-4] + ".jpg"

    def command(self):
        return " ".join(["./Project", self.scene, *self.options])


def objective(name):
    scene, chosen = "scenes/objectives/%s.lua" % name, options("960x540", name)
    shots = [Shot(scene, "objective_" + name, chosen)]
    # The twin of supersampling says its own number of samples, one.
    if name == "supersampling":
        chosen = chosen[:2]
    if name != "multithreading":
        shots.append(Shot(scene, "objective_%s_without" % name, [*chosen, "-D", "without=true"], twin=True))
    return shots


def single(name, size, *chosen):
    return [Shot("scenes/%s.lua" % name, name, list(chosen) or options(size, name))]


SECTIONS = [
    ("The room", [single("room", "", "--size", "1280x720", "--error", "0.01")]),
    ("One objective each, and its twin without it", [objective(name) for name in OBJECTIVES]),
    ("What a script can do", [single("city", "960x540"), single("menger", "", "--size", "960x540", "--spp", "64"),
                              *(single(name, "960x540") for name in ("tori", "waves", "seashell", "carved"))]),
    ("All at once", [single("everything", "960x540"), single("first_light", "800x450")]),
    ("Caustics", [single("caustic_" + name, "", "--size", "640x360", "--error", "0.01") for name in ("glass", "ring", "lens")]),
    ("One effect each", [single(name, "800x450") for name in EFFECTS]),
    ("The older form of the language", [[Shot("scenes/a4/%s.lua" % name, "a4_" + name, OLD)] for name in OLD_SCENES]),
]

STYLE = """
body { font: 16px/1.45 sans-serif; margin: 0 auto; padding: 1em 2em; max-width: 1800px; background: #f6f5f2; color: #222; }
h2 { margin: 2.5em 0 0.5em; border-bottom: 1px solid #bbb; }
article { margin: 0 0 3em; }
h3 { margin: 1.5em 0 0.4em; }
.beside { display: grid; grid-template-columns: fit-content(1280px) minmax(26em, 1fr); gap: 1.2em; align-items: stretch; }
figure { margin: 0 0 0.8em; }
figcaption { color: #555; font-size: 0.88em; width: 0; min-width: 100%; }
img { max-width: 100%; height: auto; display: block; }
.script { position: relative; min-height: 30em; }
pre { position: absolute; inset: 0; margin: 0; padding: 0.8em; overflow: auto; background: #fff; border: 1px solid #ccc;
      font: 12px/1.4 monospace; }
details pre { position: static; max-height: 40em; }
.comment { color: #6a737d; } .string { color: #7a3e00; } .word { color: #003a8c; }
p { max-width: 80em; } code { font-size: 0.9em; }
@media (max-width: 1200px) { .beside { display: block; } pre { position: static; max-height: 30em; } }
"""

WORDS = "and break do else elseif end false for function if in local nil not or repeat return then true until while"
TOKENS = re.compile(r"(?P<comment>--[^\n]*)|(?P<string>'[^'\n]*'|\"[^\"\n]*\")|(?P<word>\b(?:%s)\b)" % WORDS.replace(" ", "|"))


def coloured(script):
    out, end = [], 0
    for token in TOKENS.finditer(script):
        out += [html.escape(script[end:token.start()]),
                '<span class="%s">%s</span>' % (token.lastgroup, html.escape(token.group()))]
        end = token.end()
    return "".join(out) + html.escape(script[end:])


def text_of(path):
    with open(path, encoding="utf-8") as f:
        return f.read()


def caption_of(script):
    """The paragraphs of the first comment."""
    lines = []
    for line in script.splitlines():
        if not line.startswith("--"):
            break
        lines.append(line[2:].strip())
    return [p.strip() for p in re.split(r"\n\n|\n(?=Look at:|Without:)", "\n".join(lines))]


def number(value):
    return "{:,.0f}".format(value) if value >= 10 else "%.2g" % value


def facts(render):
    parts = ["%d x %d" % (render["width"], render["height"]),
             "%s samples a pixel (%d to %d)" % (number(render["spp_mean"]), render["spp_min"], render["spp_max"])]
    if render["error_estimate"] is not None:
        parts.append("estimated error %.2g" % render["error_estimate"])
    parts.append("%s s of processor time on %d threads" % (number(render["cpu_seconds"]), render["threads"]))
    parts.append("%s objects, %s triangles stored, %d lights" %
                 (number(render["instances"]), number(render["triangles"]), render["lights"]))
    return ", ".join(parts)


def figures(shot):
    for render in shot.renders():
        picture = "images/gallery/" + shot.picture(render)
        what = "without" if shot.twin else "picture"
        yield ('<figure><a href="{0}"><img src="{0}" width="{1}" height="{2}" alt="{3}"></a>\n'
               "<figcaption>{4}{5}<br><code>{6}</code></figcaption></figure>").format(
                   picture, render["width"], render["height"], html.escape("%s: %s" % (shot.scene, what)),
                   "<b>Without.</b> " if shot.twin else "", html.escape(facts(render)), html.escape(shot.command()))


def article(shots):
    scene = shots[0].scene
    script = text_of(scene)
    lines = ["<article>", "<h3>%s</h3>" % html.escape(scene)]
    lines += ["<p>%s</p>" % html.escape(paragraph) for paragraph in caption_of(script)]
    lines += ['<div class="beside">', "<div>", *(figure for shot in shots for figure in figures(shot)), "</div>",
              '<div class="script"><pre>%s</pre></div>' % coloured(script), "</div>"]
    parts = scene[:-4]
    if os.path.isdir(parts):
        for name in sorted(os.listdir(parts)):
            path = "%s/%s" % (parts, name)
            lines.append("<details><summary>%s</summary><pre>%s</pre></details>" % (html.escape(path), coloured(text_of(path))))
    return lines + ["</article>"]


def write_page():
    lines = ["<!DOCTYPE html>", '<html lang="en">', '<head><meta charset="utf-8"><title>Gallery</title>',
             '<meta name="viewport" content="width=device-width">', "<style>%s</style></head>" % STYLE, "<body>",
             "<h1>Gallery</h1>",
             "<p>Every scene of the project, with its script. <code>sh tools/make_gallery.sh</code> renders all of it. A picture's "
             "error is the estimated root mean square error of its pixels, of which 1 is white; models, textures and bump "
             "maps are the project's own (Assets/README.md).</p>"]
    for title, entries in SECTIONS:
        lines.append("<h2>%s</h2>" % html.escape(title))
        for shots in entries:
            lines += article(shots)
    with open(PAGE, "w", encoding="utf-8") as f:
        f.write("\n".join([*lines, "</body>", "</html>"]) + "\n")


def main():
    os.makedirs(WORK, exist_ok=True)
    os.makedirs(IMAGES, exist_ok=True)
    shots = [shot for _, entries in SECTIONS for entry in entries for shot in entry]
    wanted = set(sys.argv[1:])
    unknown = wanted - {shot.name for shot in shots}
    if unknown:
        sys.exit("no such picture: %s; there are %s" % (", ".join(sorted(unknown)), ", ".join(s.name for s in shots)))
    for shot in shots:
        if not wanted or shot.name in wanted:
            shot.render()
    write_page()


if __name__ == "__main__":
    main()
