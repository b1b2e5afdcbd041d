// script -> description -> compiled scene -> tiles -> film -> file.
#include "interrupts.h"
#include "output_names.h"
#include "rt/app/commands.h"
#include "rt/app/progress.h"
#include "rt/app/stats.h"
#include "rt/core/error.h"
#include "rt/output/atomic_file.h"
#include "rt/output/image_writer.h"
#include "scene_hash.h"
#include "scene_renderer.h"
#include "scene_report.h"

#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rt {
namespace {

/// A signal came while an image was rendered or saved; it is saved, in part or whole.
struct Interrupted {};

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
          renderer_(options),
          names_(options),
          progress_(standardError(options.color), options.quiet) {}

    int run() {
        if (options_.stats) checkWritable(*options_.stats);
        progress_.begin(renderer_.threads());
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
        const ScriptResult script = renderer_.runScript(path, frame, diagnostics);
        if (options_.listParams) return printParameters(script);
        const std::vector<std::string> outputs = names_.namesFor(script.scene, frame, diagnostics);
        for (std::size_t i = 0; i < outputs.size() && !options_.check; ++i) {
            for (const std::string& file : filesOf(outputs[i])) {
                refuseOverwriting(file, script.filesRead);
            }
            renderer_.checkOutput(outputs[i], script.scene.renders[i]);
        }
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            renderOne(script, i, frame, outputs[i], diagnostics);
        }
    }

    std::vector<std::string> filesOf(const std::string& output) const {
        if (options_.shard) return {partName(output, *options_.shard)};
        return imageFiles(output, namesOf(options_.aovs));
    }

    void renderOne(const ScriptResult& script, std::size_t index, std::int64_t frame,
                   const std::string& output, Diagnostics& diagnostics) {
        const SceneDesc& desc = script.scene;
        const PreparedScene prepared = renderer_.prepare(desc, index, diagnostics);
        if (options_.explain) progress_.message(explanation(prepared.scene));
        if (options_.check) return;
        const std::uint64_t hash =
            options_.shard ? sceneHash(options_, prepared.options, script, index, frame) : 0;

        std::optional<Interrupts::Deferred> deferred(std::in_place);
        Picture picture = rendered(desc, index, prepared, diagnostics);
        // Nobody may be reading a pipe, while a file takes a moment and must not be lost.
        if (isStream(output)) deferred.reset();
        picture.stats.output = output;
        picture.stats.warnings = diagnostics.total();
        if (picture.part) {
            picture.part->sceneHash = hash;
            savePart(picture, filesOf(output)[0]);
        } else {
            save(picture, picture.cancelled ? partialName(output) : output);
        }
        stats_.push_back(std::move(picture.stats));
        if (Interrupts::exitCode() != 0) throw Interrupted{};
    }

    Picture rendered(const SceneDesc& desc, std::size_t index, const PreparedScene& prepared,
                     Diagnostics& diagnostics) {
        progress_.startImage();
        const auto onProgress = [this](double share) { progress_.update(share); };
        return renderer_.render(desc, index, prepared, onProgress, diagnostics);
    }

    void save(const Picture& picture, const std::string& output) {
        noteIfAny(writeImage(output, picture.image, picture.settings, metadataOf(picture.stats)));
        if (picture.cancelled) {
            progress_.abandon();
            progress_.message("Interrupted; what was rendered so far is in " + output);
        } else {
            progress_.finish({output, picture.stats.renderSeconds, picture.stats.errorEstimate});
        }
    }

    /// Whole or not at all: half a shard would pass for one.
    void savePart(const Picture& picture, const std::string& name) {
        if (picture.cancelled) {
            progress_.abandon();
            progress_.message("Interrupted; a shard that is not whole is not written");
            return;
        }
        noteIfAny(writeFile(name, encodePart(*picture.part)));
        progress_.finish({name, picture.stats.renderSeconds, picture.stats.errorEstimate});
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
        for (const std::string& line : warningLines(diagnostics)) progress_.message(line);
    }

    void noteIfAny(const std::string& sentence) {
        if (!sentence.empty()) progress_.message("warning: " + sentence);
    }

    const Options& options_;
    SceneRenderer renderer_;
    OutputNames names_;
    Progress progress_;
    std::vector<RenderStats> stats_;
    int code_ = 0;
};

}  // namespace

int renderCommand(const Options& options) {
    requireDefaultScene(options);
    Interrupts::handle();
    return Batch(options).run();
}

}  // namespace rt
