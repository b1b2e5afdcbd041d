#!/usr/bin/env python3
"""unions.py [--program ./Project ...] [--rounds N] [--spp N]: what a solid of many parts costs.

Balls and boxes at random places under one light: a union of them, and the same beside each other under a node; and a
slab less as many. Overlapping parts fill the picture from 100 on; parts that lie apart stand in a grid. Several programs
are measured in turns. Numbers are medians over rounds of user and system time of one thread.
"""
import argparse, os, resource, statistics, subprocess, tempfile

SCENE = """
local n, kind, overlap = gr.param('parts', 100), gr.param('kind', 'union'), gr.param('overlap', true)
math.randomseed(11)
local root, grey = gr.node('root'), gr.material({0.6, 0.6, 0.6}, {0.3, 0.3, 0.3}, 20)
local side = math.ceil(n ^ (1 / 3))
local size = 2 / side * (overlap and 0.6 or 0.35)
local parts = {}
for i = 0, n - 1 do
    local x, y, z = i % side, i // side % side, i // side // side
    local function place(k) return 2 / side * ((overlap and side * math.random() - 0.5 or k) + 0.5) - 1 end
    x, y, z = place(x), place(y), place(z)
    parts[i + 1] = i % 2 == 0 and gr.nh_sphere('ball ' .. i, {x, y, z}, size) or
                   gr.nh_box('box ' .. i, {x - size, y - size, z - size}, 2 * size)
end
if kind == 'union' then
    root:add_child(gr.union('u', table.unpack(parts)), grey)
elseif kind == 'difference' then
    root:add_child(gr.difference('d', gr.nh_box('slab', {-1.2, -1.2, -1.2}, {2.4, 2.4, 2.4}), table.unpack(parts)), grey)
else
    for _, part in ipairs(parts) do root:add_child(part, grey) end
end
gr.background({0.3, 0.4, 0.6})
gr.render(root, 'x.png', 160, 160, {3, 2.5, 5}, {-3, -2.5, -5}, {0, 1, 0}, 30, {0.3, 0.3, 0.3},
          {gr.light({6, 20, 10}, {0.7, 0.7, 0.7}, {1, 0, 0})})
"""
KINDS = ("beside", "union", "difference")


def render(program, scene, spp, parts, kind, overlap):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, scene, "-q", "-j", "1", "--spp", str(spp), "-o", kind + ".png", "-D", "parts=%d" % parts,
                    "-D", "kind=" + kind, "-D", "overlap=" + ("true" if overlap else "false")],
                   check=True, cwd=os.path.dirname(scene))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", nargs="+", default=["./Project"])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--spp", type=int, default=36)
    parser.add_argument("--most", type=int, default=1000)
    given = parser.parse_args()
    programs = [os.path.abspath(program) for program in given.program]
    print("| parts | program | beside each other | union | ratio | difference |")
    print("| --: | --- | --: | --: | --: | --: |")
    with tempfile.TemporaryDirectory(prefix="unions-") as folder:
        scene = os.path.join(folder, "unions.lua")
        with open(scene, "w") as file:
            file.write(SCENE)
        for overlap in (True, False):
            for parts in (count for count in (3, 10, 100, 1000, 10000) if count <= given.most):
                times = {(program, kind): [] for program in programs for kind in KINDS}
                for _ in range(given.rounds):
                    for program, kind in times:
                        times[program, kind].append(render(program, scene, given.spp, parts, kind, overlap))
                for program in programs:
                    beside, union, difference = (statistics.median(times[program, kind]) for kind in KINDS)
                    print("| %d %s | %s | %.3f | %.3f | %.2f | %.3f |" %
                          (parts, "overlapping" if overlap else "apart", os.path.relpath(program), beside, union,
                           union / beside, difference), flush=True)


if __name__ == "__main__":
    main()
