"""What the stress suite found, as tables; and how to repeat what failed."""
import sys

RAY_FORMAT = "%-9s %-10s %7d %7d %5d %5d %5d %4d %8.2f %7.2f%s"
LAW_FORMAT = "%-12s %-30s %8d %8d %6d %10s %10s%s"
MAX_SHOWN = 5


class Report:
    def __init__(self):
        self.rays = {}
        self.laws = {}
        self.failures = 0

    def fail(self, what):
        self.failures += 1
        if self.failures <= MAX_SHOWN:
            print("FAILED " + what, file=sys.stderr, flush=True)
        elif self.failures == MAX_SHOWN + 1:
            print("FAILED ... and more", file=sys.stderr, flush=True)

    def ray(self, prim, cls, kind, e, n, max_e, max_n, repeat):
        row = self.rays.setdefault((prim, cls), dict(all=0, free=0, ok=0, miss=0, false=0, wrong=0, nan=0, e=0.0,
                                                     n=0.0, short=False))
        row["all"] += 1
        row[kind] += 1
        if kind == "ok":
            row["e"], row["n"] = max(row["e"], e), max(row["n"], n)
        if kind not in ("ok", "free") or e > max_e or n > max_n:
            row["short"] = True
            self.fail("%s %s: %s, E %.2f (of %g), N %.2f (of %g): %s" % (prim, cls, kind, e, max_e, n, max_n, repeat))

    def law(self, group, name, cases, odd, worst=None, limit=None, bad=0, repeat=""):
        """`cases` comparisons, `odd` of them set aside as silhouettes, `bad` that break the law."""
        row = self.laws.setdefault((group, name), dict(cases=0, odd=0, bad=0, worst=None, limit=None))
        row["cases"] += cases
        row["odd"] += odd
        row["bad"] += bad
        if worst is not None:
            row["worst"] = worst if row["worst"] is None else max(worst, row["worst"])
            row["limit"] = limit if row["limit"] is None else max(limit, row["limit"])
        if bad:
            self.fail("%s, %s: %d of %d, worst %s: %s" % (group, name, bad, cases, worst, repeat))

    def show(self):
        if self.rays:
            print("\nprimitive class        cases  judged  miss false wrong  nan    max E   max N")
        for (prim, cls), r in sorted(self.rays.items()):
            print(RAY_FORMAT % (prim, cls, r["all"], r["all"] - r["free"], r["miss"], r["false"], r["wrong"], r["nan"],
                                r["e"], r["n"], "   <-- FAILED" if r["short"] else ""))
        judged = sum(r["all"] - r["free"] for r in self.rays.values())
        print("rays: %d cases, %d judged" % (sum(r["all"] for r in self.rays.values()), judged))
        if self.laws:
            print("\ngroup        law                               cases    aside    bad      worst      limit")
        for (group, name), r in self.laws.items():
            number = lambda x: "" if x is None else "%.2g" % x
            print(LAW_FORMAT % (group, name, r["cases"], r["odd"], r["bad"], number(r["worst"]), number(r["limit"]),
                                "   <-- FAILED" if r["bad"] else ""))
        print("\n" + ("all held" if not self.failures else "%d FAILURES" % self.failures))
