-- Everything compiles from globs: a new source or test file needs no edit here, only a fresh
-- `premake4 gmake`. Base names must differ within src/ (and within tests/): objects lie flat.
--
-- The hot folders are compiled once for each instruction set. Each such library is sealed: all of
-- its symbols but one entry become local, so that an inline function compiled for AVX-512 can
-- never be picked by the linker for a processor without it (tools/seal_kernel.sh).

newoption { trigger = "bench", description = "Also build the benchmarks (Google Benchmark, Embree)" }
newoption { trigger = "clang", description = "Into build/clang-*; then `make CXX=clang++`" }

newoption { trigger = "fuzz", description = "Into build/fuzz-*, with libFuzzer and clang (tools/fuzz.sh)" }

local FUZZ = _OPTIONS["fuzz"] ~= nil
local PREFIX = FUZZ and "fuzz-" or _OPTIONS["clang"] and "clang-" or ""
local CLANG = PREFIX ~= ""

-- All variants of the tracer are one source, and give the same bytes. Instrumented, two of them, with
-- nothing and with everything, do for all: a quarter of the time to build.
local TWO_VARIANTS = " -DRT_TWO_VARIANTS"
local CONFIGURATIONS = {
  Release = "-O2 -g1 -DNDEBUG",
  Debug = "-O0 -g",
  Sanitize = "-O1 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all"
    .. TWO_VARIANTS,
  Threads = "-O1 -g1 -fsanitize=thread" .. TWO_VARIANTS,
}
local LINK_FLAGS = {
  Sanitize = "-fsanitize=address,undefined",
  Threads = "-fsanitize=thread",
}
if FUZZ then
  CONFIGURATIONS.Sanitize = CONFIGURATIONS.Sanitize .. " -fsanitize=fuzzer-no-link"
end
local WARNINGS = "-Wall -Wextra -Wshadow -Wconversion -Werror"
-- No contraction: a product and a sum are fused where the source says so, on every processor alike.
local COMMON = "-std=c++20 -ffp-contract=off -fPIC -pthread -DGLM_FORCE_INLINE " .. WARNINGS

local KERNELS = {
  avx2 = "-mavx2 -mfma -mbmi -mbmi2 -mlzcnt",
  avx512 = "-mavx2 -mfma -mbmi -mbmi2 -mlzcnt -mavx512f -mavx512vl -mavx512dq -mavx512bw "
    .. "-mprefer-vector-width=256",
}
-- A "unique" symbol cannot be made local; only g++ makes any.
local SEALABLE = CLANG and "" or " -fno-gnu-unique"
local HOT = {
  "src/core/transform.cpp", "src/core/motion.cpp", "src/math/portable*.cpp", "src/geometry/*.cpp", "src/accel/*.cpp",
  "src/sampling/*.cpp", "src/shading/*.cpp", "src/trace/*.cpp",
}

-- libm picks its functions by processor, and their last bits differ. Every call in the program,
-- Lua's included, goes to the project's own (src/math/wrap_libm.cpp).
local WRAPPED = {
  "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "exp2", "log", "log2", "log10", "pow",
  "sinh", "cosh", "tanh", "cbrt", "hypot", "sincos",
}

-- A changed flag rebuilds: every object depends on a header that holds the flags.
local function flag_stamp(name, text)
  os.mkdir("build/flags")
  local path = "build/flags/" .. name .. ".h"
  local old = io.open(path, "r")
  local same = old and old:read("*a") == "// " .. text .. "\n"
  if old then old:close() end
  if not same then
    local file = assert(io.open(path, "w"))
    file:write("// " .. text .. "\n")
    file:close()
  end
  return "-include ../build/flags/" .. name .. ".h"
end

-- A text file as a C++ constant, in a folder of generated files, which it returns.
local function embed(name, path, header)
  local folder = "build/generated"
  os.mkdir(folder)
  local file = assert(io.open(path))
  local text = ('constexpr const char* %s = R"embedded(%s)embedded";\n'):format(name, file:read("*a"))
  file:close()
  local old = io.open(folder .. "/" .. header)
  local same = old and old:read("*a") == text
  if old then old:close() end
  if not same then
    local new = assert(io.open(folder .. "/" .. header, "w"))
    new:write(text)
    new:close()
  end
  return folder
end

-- A source that has moved or gone leaves an object behind, in its folder and in a library, that make
-- knows nothing of: the object and the libraries go, too.
local function source_of(dependencies)
  local file = assert(io.open(dependencies))
  local source = file:read("*a"):gsub("\\\n", ""):match(":%s+(%S+)")
  file:close()
  return source
end

local stale = false
for _, dependencies in ipairs(os.matchfiles("build/**.d")) do
  local source = source_of(dependencies)
  if source and not os.isfile("build/" .. source) then
    os.remove(dependencies)
    os.remove((dependencies:gsub("%.d$", ".o")))
    stale = true
  end
end
if stale then
  for _, library in ipairs(os.matchfiles("build/**.a")) do os.remove(library) end
end

local function directory(config) return "build/" .. PREFIX .. config:lower() end

-- Applies flags and folders to the project being defined, in each configuration; `release` are flags
-- of that configuration alone.
local function compile(name, extra, release)
  language "C++"
  location "build"
  includedirs { "include", "/usr/include/lua5.3" }
  extra = extra or ""
  for config, flags in pairs(CONFIGURATIONS) do
    if config == "Release" and release then flags = flags .. " " .. release end
    local text = table.concat({ COMMON, flags, extra }, " ")
    configuration(config)
      targetdir(directory(config))
      objdir(directory(config) .. "/obj")
      buildoptions { COMMON, flags, extra, flag_stamp(PREFIX .. name .. "-" .. config:lower(), text) }
      if LINK_FLAGS[config] then linkoptions { LINK_FLAGS[config] } end
  end
  configuration {}
  flags { "Symbols" }
end

local KERNEL_NAMES = {}
for isa in pairs(KERNELS) do KERNEL_NAMES[#KERNEL_NAMES + 1] = isa end
table.sort(KERNEL_NAMES)

local CORE_LIBRARIES = { "rtcore" }
for _, isa in ipairs(KERNEL_NAMES) do CORE_LIBRARIES[#CORE_LIBRARIES + 1] = "kernel_" .. isa end

-- The project's own libraries refer to each other in a circle (dispatch), hence the group.
local function link_program()
  links(CORE_LIBRARIES)
  local group = {}
  for _, name in ipairs(CORE_LIBRARIES) do group[#group + 1] = "-l" .. name end
  local wrap = {}
  for _, name in ipairs(WRAPPED) do wrap[#wrap + 1] = "-Wl,--wrap=" .. name end
  linkoptions {
    "-pthread",
    "-Wl,-u,__wrap_sin " .. table.concat(wrap, " "),
    "-Wl,--start-group " .. table.concat(group, " ") .. " -Wl,--end-group",
    "-l:liblua5.3.a -llodepng -lz -ldl -lm",
  }
end

solution "Project"
  configurations { "Release", "Debug", "Sanitize", "Threads" }
  location "."

project "rtcore"
  kind "StaticLib"
  compile("rtcore")
  files { "src/**.cpp", "include/**.h" }
  excludes { "src/app/*main.cpp", "src/app/intersect/**", "src/oiio_plugin/**", "src/preview_plugin/**" }
  includedirs { embed("kPreviewPage", "src/app/preview/preview.html", "preview_page.inc") }

for _, isa in ipairs(KERNEL_NAMES) do
  project("kernel_" .. isa)
    kind "StaticLib"
    compile("kernel_" .. isa, KERNELS[isa] .. SEALABLE .. " -DRT_KERNEL_" .. isa:upper(), "-O3")
    files(HOT)
    excludes { "src/accel/build_*.cpp", "src/trace/traced_sample.cpp" }
    configuration {}
    postbuildcommands { "sh ../tools/seal_kernel.sh $(TARGET) rtKernel_" .. isa .. " $(OBJECTS)" }
end

project "rt_oiio"
  kind "SharedLib"
  compile("rt_oiio")
  files { "src/oiio_plugin/*.cpp" }
  links { "OpenImageIO", "OpenImageIO_Util" }

project "rt_preview"
  kind "SharedLib"
  compile("rt_preview")
  files { "src/preview_plugin/*.cpp" }
  links { "microhttpd" }

project "Project"
  kind "ConsoleApp"
  compile("Project")
  files { "src/app/main.cpp" }
  configuration "Release"
    if PREFIX == "" then targetdir "." end
  configuration {}
  link_program()

project "intersect"
  kind "ConsoleApp"
  compile("intersect")
  files { "src/app/intersect_main.cpp", "src/app/intersect/*.cpp" }
  configuration "Release"
    if PREFIX == "" then targetdir "build" end
  configuration {}
  link_program()

project "tests"
  kind "ConsoleApp"
  compile("tests", "-g1")
  includedirs { "tests", "src" }
  files { "tests/**_test.cpp", "tests/support/*.cpp", "tests/test_main.cpp" }
  files { "tests/fuzz/targets.cpp", "tests/fuzz/scene_writer.cpp" }
  link_program()
  linkoptions { "-lquadmath" }

if FUZZ then
  for _, name in ipairs { "obj", "image", "scene", "script", "options" } do
    project("fuzz_" .. name)
      kind "ConsoleApp"
      compile("fuzz_" .. name, "-DRT_FUZZ_TARGET=" .. name)
      files { "tests/fuzz/*.cpp", "tests/fuzz/*.h" }
      excludes { "tests/fuzz/*_test.cpp" }
      link_program()
      linkoptions { "-fsanitize=fuzzer" }
  end
end

if _OPTIONS["bench"] then
  for _, path in ipairs(os.matchfiles("tests/bench/*_bench.cpp")) do
    local name = path:match("([%w_]+)%.cpp$")
    project(name)
      kind "ConsoleApp"
      compile(name, "-mavx2 -mfma")
      files { path }
      link_program()
      links { "benchmark", "embree3", "fmt" }
  end
end
