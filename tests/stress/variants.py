"""The ways in which one question can be asked: instruction sets, masked processors, other builds."""
import os, subprocess

ISAS = ["baseline", "avx2", "avx512"]
MASK = "glibc.cpu.hwcaps=-AVX2,-FMA"
OTHER_BUILDS = ["clang-release", "debug", "clang-debug"]


def ways(program, top, name, probe):
    """[(name, command, environment)] of `program`; `probe` are arguments with which it just starts and ends."""
    found = []
    starts = lambda command: subprocess.run(command + probe, input="", text=True, capture_output=True).returncode == 0
    for isa in ISAS:
        if starts([program, "--isa", isa]):
            found.append((isa, [program, "--isa", isa], None))
    if not found:
        raise SystemExit("stress: %s does not run with --isa baseline: build it again" % program)
    found.append(("masked", [program], dict(os.environ, GLIBC_TUNABLES=MASK)))
    for build in OTHER_BUILDS:
        path = os.path.join(top, "build", build, name)
        if os.path.exists(path):
            found.append((build, [path], None))
    return found


def has_plugin(project):
    """Whether the library that writes EXR lies where the program looks for it."""
    folder = os.path.dirname(os.path.realpath(project))
    return any(os.path.exists(os.path.join(folder, where, "librt_oiio.so")) for where in (".", "build/release"))


# Everything that a path can meet; %s is a list of solids.
EVERYTHING = """
gr.background({0.1, 0.1, 0.2}, {0.4, 0.5, 0.7})
root = gr.node('root')
local function put(solid, i)
  if i %% 3 == 0 then solid:set_refraction(1.5, 0.2) solid:set_fresnel(true) end
  if i %% 3 == 1 then solid:set_reflection(0.4) end
  solid:rotate('x', 40 * i) solid:rotate('z', 25 * i)
  solid:translate(2.2 * (i %% 3) - 2.2, 2.2 * (i // 3), -0.5 * i)
  root:add_child(solid, gr.material({0.7, 0.2 + 0.1 * i, 0.4}, {0.4, 0.4, 0.4}, 30))
end
for i, solid in ipairs{%s} do put(solid, i - 1) end
root:add_child(gr.nh_box('floor', {-9, -3, -9}, {18, 1, 18}), gr.material({0.5, 0.5, 0.5}, {0.1, 0.1, 0.1}, 10))
gr.render(root, 'everything.png', 64, 48, {0.3, 3, 9}, {0, -0.15, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {0.6, 0.6, 0.6}, {1, 0, 0}, 0.8), gr.light({-6, 5, 3}, {0.3, 0.3, 0.3}, {1, 0, 0})},
          gr.focal({0, 0, 1}, 0.05, 0.05))
"""
