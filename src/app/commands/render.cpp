// script -> description -> compiled scene -> tiles -> film -> file.
#include "interrupts.h"
#include "output_names.h"
#include "rt/app/commands.h"
#include "rt/app/progress.h"
#include "rt/app/stats.h"
#include "rt/compile/compile.h"
#include "rt/compile/trace_settings.h"
#include "rt/core/error.h"
#include "rt/core/parallel.h"
#include "rt/core/text.h"
#include "rt/output/atomic_file.h"
#include "rt/output/image_writer.h"
#include "rt/render/kernel_choice.h"
#include "rt/render/renderer.h"
#include "rt/script/scene_script.h"
#include "scene_report.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rt {
namespace {

/// A signal came while an image was rendered or saved; it is saved, in part or whole.
struct Interrupted {};

ScriptSettings scriptSettings(const Options& options, std::int64_t frame) {
    ScriptSettings settings;
    settings.arguments = options.scriptArguments;
    settings.parameters = options.parameters;
    settings.frame = static_cast<int>(frame);
    if (options.frames && options.frames->last > options.frames->first) {
        settings.time = static_cast<double>(frame - options.frames->first) /
                        static_cast<double>(options.frames->last - options.frames->first);
    }
    settings.trust = options.trust;
    settings.legacyTransforms = options.legacyTransforms;
    settings.memoryLimit = options.scriptMemory;
    settings.timeLimit = options.scriptTime;
    settings.printToStderr = options.output == "-";
    return settings;
}

ImageSettings imageSettings(const RenderOptions& options) {
    ImageSettings settings;
    settings.bits = options.bits.value_or(8);
    if (options.transfer.value_or("raw") == "srgb") settings.transfer = Transfer::kSrgb;
    return settings;
}

PixelImage imageOf(const Film& film, const Tile& area) {
    PixelImage image{area.width(), area.height(), {}};
    for (int y = area.y0; y < area.y1; ++y) {
        for (int x = area.x0; x < area.x1; ++x) image.pixels.push_back(film.at(x, y).mean());
    }
    return image;
}

/// "name.partial.png", for an image that is not finished; a stream stays what it is.
std::string partialName(const std::string& name) {
    if (isStream(name)) return name;
    const std::size_t dot = name.rfind('.');
    const std::size_t slash = name.rfind('/');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) {
        return name + ".partial";
    }
    return name.substr(0, dot) + ".partial" + name.substr(dot);
}

/// One run of the program over its scenes.
class Batch {
  public:
    explicit Batch(const Options& options)
        : options_(options),
          threads_(options.threads > 0 ? options.threads : availableThreads()),
          kernel_(chooseKernel(options.isa.value_or(""))),
          names_(options),
          progress_(standardError(options.color), options.quiet),
          assets_(threads_) {}

    int run() {
        if (options_.stats) checkWritable(*options_.stats);
        progress_.begin(threads_);
        for (const std::string& scene : options_.scenes) {
            const int code = attempt(scene);
            if (code_ == 0) code_ = code;
            if (code != 0 && (options_.failFast || Interrupts::exitCode() != 0)) break;
        }
        if (options_.stats) noteIfAny(writeStats(*options_.stats, stats_));
        return code_;
    }

  private:
    int attempt(const std::string& scene) {
        Diagnostics diagnostics;
        int code = 0;
        try {
            const FrameRange frames = options_.frames.value_or(FrameRange{});
            for (std::int64_t frame = frames.first; frame <= frames.last; ++frame) {
                runScene(scene, frame, diagnostics);
            }
        } catch (const Interrupted&) {
            code = Interrupts::exitCode();
        } catch (const Error& error) {
            return failed(error, diagnostics);
        } catch (const std::bad_alloc&) {
            return failed(LimitError("the system has no memory left"), diagnostics);
        } catch (const std::exception& error) {
            const std::string words = std::string("internal error: ") + error.what();
            return failed(Error(ExitCode::kInternal, {}, words + "; please report it"),
                          diagnostics);
        }
        report(diagnostics);
        const bool strict = options_.werror && diagnostics.total() > 0;
        return code != 0 ? code : static_cast<int>(strict ? ExitCode::kScene : ExitCode::kDone);
    }

    int failed(const Error& error, const Diagnostics& diagnostics) {
        progress_.abandon();
        report(diagnostics);
        progress_.message(error.shown());
        if (options_.verbose && !error.details().empty()) progress_.message(error.details());
        return static_cast<int>(error.code());
    }

    void runScene(const std::string& path, std::int64_t frame, Diagnostics& diagnostics) {
        assets_.forgetTables();
        const ScriptResult script = runScript(path, scriptSettings(options_, frame), diagnostics);
        if (options_.listParams) return printParameters(script);
        const std::vector<std::string> outputs = names_.namesFor(script.scene, frame, diagnostics);
        for (std::size_t i = 0; i < outputs.size() && !options_.check; ++i) {
            refuseOverwriting(outputs[i], script.filesRead);
            checkOutput(outputs[i], script.scene.renders[i]);
        }
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            renderOne(script.scene, i, outputs[i], diagnostics);
        }
    }

    void renderOne(const SceneDesc& desc, std::size_t index, const std::string& output,
                   Diagnostics& diagnostics) {
        const RenderOptions options = options_.render.over(desc.renders[index].options);
        const auto began = std::chrono::steady_clock::now();
        const RenderScene scene = compiled(desc, index, options, diagnostics);
        const double buildSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        if (options_.crop && clipped(*options_.crop, scene.width, scene.height).second) {
            diagnostics.warn("crop", desc.renders[index].where,
                             "--crop reaches beyond the image and is clipped");
        }
        if (options_.explain) progress_.message(explanation(scene));
        if (options_.check) return;

        std::optional<Interrupts::Deferred> deferred(std::in_place);
        const RenderOutcome outcome = rendered(scene, options);
        // Nobody may be reading a pipe, while a file takes a moment and must not be lost.
        if (isStream(output)) deferred.reset();
        warnOfNonFinite(outcome.counts, desc.renders[index], diagnostics);
        RenderStats stats = statsOf(scene, options, outcome);
        warnIfNotConverged(stats, desc.renders[index], diagnostics);
        stats.scene = desc.name;
        stats.output = output;
        stats.buildSeconds = buildSeconds;
        stats.warnings = diagnostics.total();
        save(outcome, areaOf(scene), outcome.cancelled ? partialName(output) : output, options,
             stats);
        stats_.push_back(std::move(stats));
        if (Interrupts::exitCode() != 0) throw Interrupted{};
    }

    /// What can be known about an output before there is anything to write.
    void checkOutput(const std::string& output, const RenderDesc& render) const {
        refuseTooManyPixels(render);
        ImageSize size = options_.size.value_or(ImageSize{render.width, render.height});
        if (options_.crop) {
            const Crop crop = clipped(*options_.crop, size.width, size.height).first;
            size = {crop.x1 - crop.x0, crop.y1 - crop.y0};
        }
        checkImageOutput(output, size.width, size.height,
                         imageSettings(options_.render.over(render.options)));
    }

    RenderScene compiled(const SceneDesc& desc, std::size_t index, const RenderOptions& options,
                         Diagnostics& diagnostics) {
        CompileSettings settings;
        if (options_.size) {
            settings.width = options_.size->width;
            settings.height = options_.size->height;
        }
        settings.threads = threads_;
        settings.smoothAngleDegrees = options.smoothAngle.value_or(settings.smoothAngleDegrees);
        settings.flipV = options.flipV.value_or(false);
        settings.srgb = options.transfer.value_or("raw") == "srgb";
        settings.maxInstances = static_cast<std::uint64_t>(options_.maxInstances);
        settings.maxPixels = static_cast<std::uint64_t>(options_.maxPixels);
        refuseTooManyPixels(desc.renders[index]);
        return compileScene(desc, index, settings, assets_, diagnostics);
    }

    void refuseTooManyPixels(const RenderDesc& render) const {
        const std::int64_t width = options_.size ? options_.size->width : render.width;
        const std::int64_t height = options_.size ? options_.size->height : render.height;
        if (width * height <= options_.maxPixels) return;
        throw LimitError(
            "gr.render: " + std::to_string(width) + "x" + std::to_string(height) + " pixels need " +
                std::to_string((width * height * std::int64_t{sizeof(PixelState)}) >> 20) +
                " MB, more than the limit of " + std::to_string(options_.maxPixels) +
                " pixels (see --max-pixels)",
            render.where);
    }

    RenderOutcome rendered(const RenderScene& scene, const RenderOptions& options) {
        const SamplingGoal goal = samplingGoal(options);
        RenderJob job;
        job.settings = goal.trace;
        job.errorTarget = goal.errorTarget;
        job.adaptive = goal.adaptive;
        // Towards an error target a pixel's samples depend on the whole image's error.
        job.area = goal.errorTarget > 0.0 ? wholeOf(scene) : areaOf(scene);
        job.threads = threads_;
        job.timeLimit = goal.timeLimit;
        job.kernel = &kernel_;
        job.cancel = &Interrupts::requested();
        job.onProgress = [this](double share) { progress_.update(share); };
        progress_.startImage();
        return render(scene, job);
    }

    static Tile wholeOf(const RenderScene& scene) { return {0, 0, scene.width, scene.height}; }

    Tile areaOf(const RenderScene& scene) const {
        if (!options_.crop) return wholeOf(scene);
        const Crop crop = clipped(*options_.crop, scene.width, scene.height).first;
        return {crop.x0, crop.y0, crop.x1, crop.y1};
    }

    void save(const RenderOutcome& outcome, const Tile& area, const std::string& output,
              const RenderOptions& options, const RenderStats& stats) {
        const PixelImage image = imageOf(outcome.film, area);
        ImageMetadata metadata;
        metadata.scene = stats.scene;
        metadata.seed = stats.seed;
        metadata.samplesPerPixel = stats.sppMean;
        metadata.error = stats.errorEstimate;
        noteIfAny(writeImage(output, image, imageSettings(options), metadata));
        if (outcome.cancelled) {
            progress_.abandon();
            progress_.message("Interrupted; what was rendered so far is in " + output);
        } else {
            progress_.finish({output, stats.renderSeconds, stats.errorEstimate});
        }
    }

    RenderStats statsOf(const RenderScene& scene, const RenderOptions& options,
                        const RenderOutcome& outcome) const {
        RenderStats stats;
        stats.width = areaOf(scene).width();
        stats.height = areaOf(scene).height();
        stats.threads = threads_;
        stats.seed = static_cast<std::uint64_t>(options.seed.value_or(0.0));
        countSamples(outcome.film, stats);
        stats.converged = outcome.converged;
        stats.errorEstimate = outcome.errorEstimate;
        const double target = samplingGoal(options).errorTarget;
        if (target > 0.0) stats.errorTarget = target;
        const SceneCounts counts = countsOf(scene);
        stats.triangles = counts.triangles;
        stats.primitives = counts.primitives;
        stats.instances = scene.instances.size();
        stats.lights = scene.lights.size();
        stats.renderSeconds = outcome.seconds;
        stats.cpuSeconds = outcome.cpuSeconds;
        stats.peakRssBytes = peakResidentBytes();
        stats.rays = outcome.counts.rays;
        stats.cutPaths = outcome.counts.cutPaths;
        stats.cutErrorBound = outcome.counts.cutBound /
                              std::max(1.0, static_cast<double>(outcome.counts.rays.camera));
        stats.features = featuresOf(scene);
        stats.skipped = skippedBy(scene);
        return stats;
    }

    static void countSamples(const Film& film, RenderStats& stats) {
        stats.sppMin = std::numeric_limits<std::uint64_t>::max();
        std::uint64_t total = 0;
        for (const PixelState& pixel : film.pixels) {
            total += pixel.samples;
            stats.sppMin = std::min(stats.sppMin, pixel.samples);
            stats.sppMax = std::max(stats.sppMax, pixel.samples);
        }
        stats.sppMean = static_cast<double>(total) / static_cast<double>(film.pixels.size());
    }

    static void warnIfNotConverged(const RenderStats& stats, const RenderDesc& render,
                                   Diagnostics& diagnostics) {
        if (stats.converged || !stats.errorTarget || !stats.errorEstimate) return;
        diagnostics.warn("not-converged", render.where,
                         "the estimated error is " + shortest(*stats.errorEstimate) +
                             ", more than the target of " + shortest(*stats.errorTarget) +
                             " (see --max-spp)");
    }

    static void warnOfNonFinite(const TraceCounts& counts, const RenderDesc& render,
                                Diagnostics& diagnostics) {
        if (counts.nonFinite == 0) return;
        diagnostics.warn("non-finite", render.where,
                         std::to_string(counts.nonFinite) +
                             " samples were not finite and count as black, the first in pixel " +
                             std::to_string(counts.nonFiniteX) + "," +
                             std::to_string(counts.nonFiniteY));
    }

    static void printParameters(const ScriptResult& script) {
        for (const ScriptParameter& parameter : script.parameters) {
            std::printf("%s = %s%s%s\n", printable(parameter.name, 200).c_str(),
                        printable(parameter.value, 200).c_str(),
                        parameter.doc.empty() ? "" : "  -- ",
                        printable(parameter.doc, 400).c_str());
        }
    }

    void report(const Diagnostics& diagnostics) {
        for (const Diagnostics::Warning& warning : diagnostics.shown()) {
            progress_.message(warning.where.prefix() + "warning: " + warning.message + " [-W" +
                              warning.kind + "]");
        }
        for (const auto& [kind, count] : diagnostics.countByKind()) {
            if (count <= Diagnostics::kShownPerKind) continue;
            progress_.message("warning: " + std::to_string(count - Diagnostics::kShownPerKind) +
                              " more of [-W" + kind + "]");
        }
    }

    void noteIfAny(const std::string& sentence) {
        if (!sentence.empty()) progress_.message("warning: " + sentence);
    }

    const Options& options_;
    int threads_;
    const TraceKernel& kernel_;
    OutputNames names_;
    Progress progress_;
    AssetCache assets_;
    std::vector<RenderStats> stats_;
    int code_ = 0;
};

}  // namespace

int renderCommand(const Options& options) {
    requireDefaultScene(options);
    const Interrupts interrupts;
    return Batch(options).run();
}

}  // namespace rt
