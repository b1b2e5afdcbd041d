#include "targets.h"

#include "rt/app/options.h"
#include "rt/compile/compile.h"
#include "rt/compile/mesh_file.h"
#include "rt/compile/trace_settings.h"
#include "rt/core/error.h"
#include "rt/image/image.h"
#include "rt/render/kernel_choice.h"
#include "rt/render/renderer.h"
#include "rt/script/scene_script.h"
#include "scene_writer.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>

namespace rt::fuzz {
namespace {

void hold(bool law, const char* what) {
    if (law) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

/// One folder for the process, its own so that the cage around scripts has nothing else in it.
class Scratch {
  public:
    Scratch() : folder_(pattern()) {}
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string write(const char* name, Bytes bytes) const {
        const std::string path = folder_ + "/" + name;
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
        return path;
    }

  private:
    static std::string pattern() {
        std::string name = (std::filesystem::temp_directory_path() / "rt-fuzz-XXXXXX").string();
        hold(mkdtemp(name.data()) != nullptr, "a temporary folder can be made");
        return name;
    }

    std::string folder_;
};

const Scratch& scratch() {
    static const Scratch folder;
    return folder;
}

/// What a scene may make of its input.
template <typename Work>
void answered(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        hold(std::strlen(error.what()) > 0, "an error has a message");
    }
}

bool unit(const Vec3& v) {
    return std::abs(v.x * v.x + v.y * v.y + v.z * v.z - 1.0) < 1e-9;
}

bool inRange(const std::vector<TriangleMesh::Corners>& corners, std::size_t count, bool mayLack) {
    return std::all_of(corners.begin(), corners.end(), [&](const TriangleMesh::Corners& triangle) {
        return std::all_of(triangle.begin(), triangle.end(), [&](Index corner) {
            return corner < count || (mayLack && corner == kNone);
        });
    });
}

void checkMesh(const TriangleMesh& mesh) {
    hold(inRange(mesh.triangles, mesh.positions.size(), false), "corners are in range");
    hold(inRange(mesh.normalCorners, mesh.normals.size(), true), "corners' normals are in range");
    hold(inRange(mesh.uvCorners, mesh.uvs.size(), true), "corners' uvs are in range");
    hold(mesh.normalCorners.empty() || mesh.normalCorners.size() == mesh.triangles.size(),
         "every triangle has normals");
    for (const TriangleMesh::Corners& corners : mesh.normalCorners) {
        for (const Index corner : corners) {
            hold(corner == kNone || unit(mesh.normals[corner]), "normals in use are unit vectors");
        }
    }
    for (const Vec3& p : mesh.positions) {
        hold(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "vertices are finite");
    }
}

constexpr int kPictureWidth = 6;
constexpr int kPictureHeight = 5;

Film filmOf(const RenderScene& scene, const TraceKernel& kernel) {
    RenderJob job;
    RenderOptions options;
    options.spp = 1;
    job.settings = samplingGoal(options).trace;
    job.area = {0, 0, scene.width, scene.height};
    job.kernel = &kernel;
    // Anything is good enough: the least photons that there can be.
    job.causticTarget = kInfinity;
    return render(scene, job).film;
}

bool sameBits(const Color& a, const Color& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void renderAll(const std::string& path) {
    Diagnostics diagnostics;
    ScriptSettings settings;
    settings.memoryLimit = std::size_t{64} << 20;
    settings.timeLimit = 0.2;
    settings.printToStderr = true;
    const SceneDesc scene = runScript(path, settings, diagnostics).scene;
    AssetCache assets(1);
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.renders.size(), 2); ++i) {
        CompileSettings compile;
        compile.width = kPictureWidth;
        compile.height = kPictureHeight;
        compile.maxInstances = 10'000;
        const RenderScene compiled = compileScene(scene, i, compile, assets, diagnostics);
        const Film fast = filmOf(compiled, chooseKernel(""));
        const Film plain = filmOf(compiled, chooseKernel("baseline"));
        for (std::size_t k = 0; k < fast.pixels.size(); ++k) {
            const Color value = fast.pixels[k].mean();
            hold(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z),
                 "pixels are finite");
            hold(sameBits(value, plain.pixels[k].mean()),
                 "every instruction set gives the same bits");
        }
    }
}

}  // namespace

void obj(Bytes bytes) {
    const std::string path = scratch().write("mesh.obj", bytes);
    answered([&] {
        Diagnostics diagnostics;
        checkMesh(loadObj(path, {}, diagnostics));
        AssetCache(1).mesh(MeshFileDesc{path, {}}, 40.0, diagnostics);
    });
}

void image(Bytes bytes) {
    // OpenImageIO's formats are its own affair.
    static constexpr std::uint8_t kMagic[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    std::vector<std::uint8_t> png(std::begin(kMagic), std::end(kMagic));
    const bool whole =
        bytes.size() >= png.size() && std::equal(png.begin(), png.end(), bytes.begin());
    if (whole) png.clear();
    png.insert(png.end(), bytes.begin(), bytes.end());
    const std::string path = scratch().write("image.png", png);
    answered([&] {
        Diagnostics diagnostics;
        ImageLimits limits;
        limits.maxPixels = std::uint64_t{1} << 22;
        const Image read = loadImage(path, limits, diagnostics);
        const std::size_t samples =
            std::visit([](const auto& all) { return all.size(); }, read.samples);
        hold(read.channels == 1 || read.channels == 3, "an image is grey or coloured");
        hold(samples == static_cast<std::size_t>(read.width) *
                            static_cast<std::size_t>(read.height) *
                            static_cast<std::size_t>(read.channels),
             "an image has all its samples");
    });
}

void scene(Bytes bytes) {
    const std::string text = SceneWriter(bytes).script();
    const std::string path = scratch().write(
        "scene.lua", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    answered([&] { renderAll(path); });
}

void script(Bytes bytes) {
    const std::string path = scratch().write("script.lua", bytes);
    answered([&] { renderAll(path); });
}

void options(Bytes bytes) {
    std::vector<std::string> arguments{""};
    for (const std::uint8_t byte : bytes) {
        if (byte == 0) {
            arguments.emplace_back();
        } else {
            arguments.back() += static_cast<char>(byte);
        }
    }
    answered([&] {
        const Options first = parseOptions(arguments);
        const Options second = parseOptions(arguments);
        hold(first.scenes == second.scenes && first.parameters == second.parameters &&
                 first.threads == second.threads && first.output == second.output,
             "the same arguments mean the same");
        if (first.command != Command::kRender) return;
        hold(!first.scenes.empty(), "there is a scene");
        hold(0 <= first.threads && first.threads <= kMostThreads, "threads are in range");
        hold(first.maxPixels > 0 && first.maxInstances > 0, "limits are positive");
        if (first.size) hold(first.size->width > 0 && first.size->height > 0, "sizes are positive");
        if (first.crop) {
            hold(first.crop->x0 < first.crop->x1 && first.crop->y0 < first.crop->y1, "crops hold");
        }
        samplingGoal(first.render);
    });
}

const std::vector<Target>& targets() {
    static const std::vector<Target> all = {
        {"obj", obj}, {"image", image}, {"scene", scene}, {"script", script}, {"options", options},
    };
    return all;
}

}  // namespace rt::fuzz
