#include "render_script.h"

#include "rt/compile/compile.h"
#include "rt/compile/trace_settings.h"
#include "rt/render/kernel_choice.h"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

namespace rt::test {

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "rt-test-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
    const std::string path = file(name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

Picture renderScript(const std::string& script, const PictureSettings& settings) {
    const TemporaryFolder temporary;
    const std::filesystem::path folder =
        settings.folder.empty() ? temporary.path() : std::filesystem::path(settings.folder);
    const std::string path = (folder / "scene.lua").string();
    std::ofstream(path, std::ios::binary) << script;

    Diagnostics diagnostics;
    const ScriptResult run = runScript(path, {}, diagnostics);
    const RenderOptions options =
        settings.options.over(run.scene.renders.at(settings.render).options);
    CompileSettings compileSettings;
    compileSettings.smoothAngleDegrees = options.smoothAngle.value_or(40.0);
    compileSettings.flipV = options.flipV.value_or(false);
    compileSettings.caustics = options.caustics.value_or(false);
    AssetCache assets(1);
    const RenderScene scene =
        compileScene(run.scene, settings.render, compileSettings, assets, diagnostics);

    RenderJob job;
    const SamplingGoal goal = samplingGoal(options);
    job.settings = goal.trace;
    job.errorTarget = goal.errorTarget;
    job.causticTarget = goal.causticTarget;
    job.adaptive = goal.adaptive;
    job.area = {0, 0, scene.width, scene.height};
    job.threads = settings.threads;
    job.kernel = &chooseKernel(settings.kernel);
    if (settings.adjust) settings.adjust(job);
    const RenderOutcome outcome = render(scene, job);

    Picture picture{scene.width,    scene.height,          {},
                    outcome.counts, outcome.errorEstimate, outcome.converged};
    for (const PixelState& pixel : outcome.film.pixels) picture.pixels.push_back(pixel.mean());
    return picture;
}

Described describe(const std::string& script) {
    const TemporaryFolder folder;
    Described described;
    described.scene = runScript(folder.write("scene.lua", script), {}, described.diagnostics).scene;
    return described;
}

}  // namespace rt::test
