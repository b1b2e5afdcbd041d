#include "output_names.h"

#include "rt/core/error.h"
#include "rt/output/image_writer.h"

#include <filesystem>

namespace rt {
namespace {

/// Whether a name, relative to the current folder, leads out of it.
bool leavesFolder(const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    return path.is_absolute() || (path.begin() != path.end() && *path.begin() == "..");
}

}  // namespace

std::pair<std::string, std::string> splitExtension(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    const std::size_t slash = name.rfind('/');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {name, ""};
    return {name.substr(0, dot), name.substr(dot)};
}

std::vector<std::string> OutputNames::namesFor(const SceneDesc& scene, std::int64_t frame,
                                               Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const RenderDesc& render : scene.renders) {
        names.push_back(nameFor(render, frame));
        refuseTwice(names.back(), render, diagnostics);
    }
    return names;
}

std::string OutputNames::nameFor(const RenderDesc& render, std::int64_t frame) {
    ++rendersSoFar_;
    if (!options_.output && !options_.trust && leavesFolder(render.output)) {
        throw SceneError("gr.render: '" + printable(render.output, 300) +
                             "' lies outside of the current folder; name it with -o, or allow "
                             "scripts to write anywhere with --trust",
                         render.where);
    }
    const std::string pattern = options_.output.value_or(render.output);
    return numberedName(pattern, options_.frames ? frame : rendersSoFar_);
}

void OutputNames::refuseTwice(const std::string& name, const RenderDesc& render,
                              Diagnostics& diagnostics) {
    if (used_.insert(name).second) return;
    if (options_.output) {
        throw UsageError("-o " + *options_.output +
                         ": more than one image would be written to it; put # into the name, "
                         "which becomes the image's number");
    }
    if (options_.frames) {
        throw UsageError("--frames: two frames would be written to '" + printable(name, 300) +
                         "'; put # or gr.frame into the name that gr.render is given");
    }
    diagnostics.warn("overwritten", render.where,
                     "an earlier render of this run went to the same file '" +
                         printable(name, 300) + "', which is overwritten");
}

}  // namespace rt
