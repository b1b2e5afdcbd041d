"""Tables and plots of error_time.py."""
import os
from . import front

COLORS = {"joint": "#c0392b", "jitter": "#2980b9", "grid": "#7f8c8d", "random": "#8e44ad", "povray": "#27ae60"}
NAMES = {"joint": "--error", "jitter": "--sampler jitter", "grid": "--sampler grid", "random": "--sampler random",
         "povray": "POV-Ray"}

PLOT = """

![RMSE against CPU seconds for each scene](images/error_against_time.png)

The dots are all settings of POV-Ray that were tried, its line the best of them."""


def number(value, mark=""):
    if value is None:
        return "-"
    return mark + ("%.3f" % value if value < 1 else "%.2f" % value if value < 10 else "%.0f" % value)


def pairs(rows, key="cpu"):
    return [(r["rmse"], r[key]) for r in rows or []]


def over(a, b):
    return None if a is None or b is None else a / b


class Report:
    def __init__(self, judged, results):
        self.judged, self.results = judged, results

    def add(self, result):
        """in the place of what is there of the same scene"""
        others = [r for r in self.results if r["scene"] != result["scene"]]
        self.results = sorted(others + [result], key=lambda r: r["scene"])

    def points(self, result):
        """every setting of one scene; POV-Ray's on its front"""
        lines = ["%s, %s, %dx%d" % (result["scene"], result["title"], *result["size"])]
        for sampler, rows in result["here"].items():
            lines += ["  %-8s %-16s RMSE %.5f  %7.3f CPU s, tracing %7.3f  samples %.1f" % (
                sampler, r["label"], r["rmse"], r["cpu"], r["trace"], r["spp"]) for r in rows]
        if result["povray"]:
            edge = front.pareto(pairs(result["povray"]))
            lines += ["  POV-Ray  %-48s RMSE %.5f  %7.3f CPU s, tracing %7.3f  (%d runs)" % (
                r["label"], r["rmse"], r["cpu"], r["trace"], r["runs"]) for r in
                sorted(result["povray"], key=lambda r: -r["rmse"]) if (r["rmse"], r["cpu"]) in edge]
        return "\n".join(lines)

    def compare(self, result, error):
        """CPU seconds for an error, here and elsewhere, and what they are to each other"""
        own, other = result["here"]["joint"], result["povray"]
        here, mark = front.cost_at(pairs(own), error)
        trace, _ = front.cost_at(pairs(own, "trace"), error)
        peer, peer_mark = front.cost_at(pairs(other), error)
        peer_trace, _ = front.cost_at(pairs(other, "trace"), error)
        jitter, jitter_mark = front.cost_at(pairs(result["here"].get("jitter")), error, extrapolate=True)
        return dict(here=here, mark=mark, peer=peer, peer_mark=peer_mark, ratio=over(peer, here), trace=trace,
                    peer_trace=peer_trace, trace_ratio=over(peer_trace, trace), jitter=jitter, jitter_mark=jitter_mark,
                    jitter_ratio=over(jitter, here))

    def summary(self):
        """Markdown: seconds for the judged errors"""
        lines = ["| scene | size | RMSE | here | POV-Ray | ratio | tracing: here | POV-Ray | ratio | jitter | ratio |",
                 "| --- | --- | --: | --: | --: | --: | --: | --: | --: | --: | --: |"]
        ratios = {key: [] for key in ("ratio", "trace_ratio", "jitter_ratio")}
        for result in self.results:
            for error in self.judged:
                c = self.compare(result, error)
                for key in ratios:
                    if c[key] is not None:
                        ratios[key].append(c[key])
                lines.append("| %s %s | %dx%d | %g | %s | %s | %s | %s | %s | %s | %s | %s |" % (
                    result["scene"], result["title"], *result["size"], error, number(c["here"], c["mark"]),
                    number(c["peer"], c["peer_mark"]), number(c["ratio"]), number(c["trace"]), number(c["peer_trace"]),
                    number(c["trace_ratio"]), number(c["jitter"], c["jitter_mark"]), number(c["jitter_ratio"])))
        means = {key: number(front.geometric_mean(values)) for key, values in ratios.items()}
        lines.append("| geometric mean | | | | | %(ratio)s | | | %(trace_ratio)s | | %(jitter_ratio)s |" % means)
        return "\n".join(lines)

    def plot(self, path):
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        columns = min(2, len(self.results))
        rows = (len(self.results) + columns - 1) // columns
        figure, axes = plt.subplots(rows, columns, figsize=(5 * columns, 3.6 * rows), squeeze=False)
        for axis in axes.flat[len(self.results):]:
            axis.axis("off")
        for axis, result in zip(axes.flat, self.results):
            series = dict(result["here"], **({"povray": result["povray"]} if result["povray"] else {}))
            for name, values in series.items():
                line = front.pareto(pairs(values)) if name == "povray" else sorted(pairs(values))
                if name == "povray":
                    axis.plot(*zip(*pairs(values)), ".", color=COLORS[name], markersize=3, alpha=0.5)
                axis.plot([e for e, _ in line], [c for _, c in line], "o-",
                          color=COLORS[name], markersize=3.5, linewidth=1.2, label=NAMES[name])
            axis.set(xscale="log", yscale="log", xlabel="RMSE", ylabel="CPU seconds", xlim=(6e-4, 0.06),
                     title="%s %s, %dx%d" % (result["scene"], result["title"], *result["size"]))
            axis.grid(True, which="major", alpha=0.4)
            axis.invert_xaxis()
        axes.flat[0].legend(fontsize=8)
        figure.tight_layout()
        figure.savefig(path, dpi=90)

    def write(self, top):
        images = os.path.join(top, "Documentation", "images")
        self.plot(os.path.join(images, "error_against_time.png"))
        put(os.path.join(top, "Documentation", "performance.md"), "error_time", self.summary() + PLOT)


def put(path, marker, text):
    """Replaces what stands between <!-- marker --> and <!-- /marker --> in a file."""
    with open(path) as f:
        page = f.read()
    begin, end = "<!-- %s -->\n" % marker, "<!-- /%s -->" % marker
    if begin not in page or end not in page:
        raise ValueError("%s has no %s ... %s" % (path, begin.strip(), end))
    head, rest = page.split(begin, 1)
    with open(path, "w") as f:
        f.write(head + begin + text.rstrip("\n") + "\n" + end + rest.split(end, 1)[1])
