// script -> description -> compiled scene -> tiles -> film -> file.
#include "../preview/preview_server.h"
#include "checkpoint_keeper.h"
#include "dependency_file.h"
#include "interrupts.h"
#include "output_names.h"
#include "pixel_report.h"
#include "rt/app/commands.h"
#include "rt/app/progress.h"
#include "rt/app/stats.h"
#include "rt/core/error.h"
#include "rt/output/atomic_file.h"
#include "rt/output/image_writer.h"
#include "rt/script/parameter_file.h"
#include "scene_hash.h"
#include "scene_renderer.h"
#include "scene_report.h"
#include "watcher.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace rt {
namespace {

/// A signal came while an image was rendered or saved; it is saved, in part or whole.
struct Interrupted {};

/// A render was left because a file changed, or somebody stopped it, and the program goes on.
struct Left {};

/// "name.partial.png", for an image that is not finished; a stream stays what it is.
std::string partialName(const std::string& name) {
    if (isStream(name)) return name;
    const auto [stem, extension] = splitExtension(name);
    return stem + ".partial" + extension;
}

/// The outputs that are files; nothing can depend on a stream.
std::vector<std::string> imagesOf(const std::vector<std::string>& outputs) {
    std::vector<std::string> files;
    std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(files),
                 [](const std::string& output) { return !isStream(output); });
    return files;
}

/// What came of a scene.
struct EndedScene {
    std::string name;
    int code = 0;
    int images = 0;

    std::string line() const {
        const std::string count = std::to_string(images) + (images == 1 ? " image" : " images");
        return printable(name, 300) + ": " +
               (code == 0 ? "done, " : "failed with exit code " + std::to_string(code) + ", ") +
               count;
    }
};

/// One run of the program over its scenes.
class Batch {
  public:
    explicit Batch(const Options& options)
        : options_(options),
          renderer_(options),
          progress_(standardError(options.color), options.quiet) {}

    /// Called before the first run; it must outlive the last.
    void add(RunFollower& follower) { followers_.push_back(&follower); }

    /// From anew each time, but that files which were loaded need not be loaded again.
    int run() {
        names_.emplace(options_);
        stats_.clear();
        rules_.clear();
        ended_.clear();
        code_ = 0;
        left_ = false;
        for (const auto& file : {options_.stats, options_.deps}) {
            if (file) checkWritable(*file);
        }
        if (!begun_) progress_.begin(renderer_.threads());
        begun_ = true;
        for (const std::string& scene : options_.scenes) {
            const int code = attempt(scene);
            ended_.push_back({scene, code, images_});
            if (code_ == 0) code_ = code;
            if (left_) break;
            if (code != 0 && (options_.failFast || Interrupts::exitCode() != 0)) break;
        }
        if (isStale()) return code_;
        if (options_.pixel) return code_;
        if (options_.stats) noteIfAny(writeStats(*options_.stats, stats_));
        // Of a run that failed not all is known: make tries again by the older rules.
        if (options_.deps && code_ == 0 && !left_)
            noteIfAny(writeDependencies(*options_.deps, rules_));
        if (options_.scenes.size() > 1 && !options_.quiet) sumUp();
        return code_;
    }

    /// What came of the renders so far stays; these files are loaded again.
    void forget(const std::vector<std::string>& files) {
        for (const std::string& file : files) renderer_.forget(file);
    }

    void show(const std::string& line) { progress_.message(line); }
    /// A line that --quiet leaves out.
    void tell(const std::string& line) {
        if (!options_.quiet) progress_.message(line);
    }

  private:
    int attempt(const std::string& scene) {
        Diagnostics diagnostics;
        images_ = 0;
        int code = 0;
        try {
            const FrameRange all = options_.frames.value_or(FrameRange{});
            const FrameRange frames = options_.subset.value_or(all);
            for (std::int64_t frame = frames.first; frame <= frames.last; ++frame) {
                runScene(scene, frame, diagnostics);
            }
        } catch (const Interrupted&) {
            code = Interrupts::exitCode();
        } catch (const Left&) {
            progress_.abandon();
            left_ = true;
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
        say(error.shown());
        if (options_.verbose && !error.details().empty()) progress_.message(error.details());
        return static_cast<int>(error.code());
    }

    void runScene(const std::string& path, std::int64_t frame, Diagnostics& diagnostics) {
        const ScriptResult script = ranScript(path, frame, diagnostics);
        if (options_.listParams) return printParameters(script);
        const std::vector<std::string> outputs = names_->namesFor(script.scene, frame, diagnostics);
        rules_.push_back({imagesOf(outputs), script.filesRead});
        for (const auto& file : {options_.stats, options_.deps}) {
            if (file) refuseOverwriting(*file, script.filesRead);
        }
        const bool writes = !options_.check && !options_.pixel;
        for (std::size_t i = 0; i < outputs.size() && writes; ++i) {
            for (const std::string& file : filesOf(outputs[i])) {
                refuseOverwriting(file, script.filesRead);
            }
            renderer_.checkOutput(outputs[i], script.scene.renders[i]);
        }
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            renderOne(script, i, frame, outputs[i], diagnostics);
        }
    }

    ScriptResult ranScript(const std::string& path, std::int64_t frame, Diagnostics& diagnostics) {
        ScriptFiles files;
        scriptBegan_ = std::chrono::system_clock::now();
        const auto tell = [&] {
            for (RunFollower* follower : followers_) follower->ranScript(path, files);
        };
        try {
            ScriptResult script = renderer_.runScript(path, frame, diagnostics, &files);
            tell();
            return script;
        } catch (const Error&) {
            tell();
            throw;
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
        if (isStale()) throw Left{};
        if (options_.pixel) return showPixel(desc, prepared, output);
        const auto traits = [&] {
            return traitsOf(options_, prepared.options, script, index, frame);
        };
        const std::uint64_t hash = options_.shard ? sceneHash(traits()) : 0;
        keepCheckpoint(script, filesOf(output)[0], prepared, [&, traits] {
            std::vector<Trait> all = traits();
            for (Trait& trait : partTraitsOf(options_)) all.push_back(std::move(trait));
            return all;
        });

        for (RunFollower* follower : followers_) follower->startsImage(output, prepared);
        std::optional<Interrupts::Deferred> deferred(std::in_place, checkpoint_.has_value());
        progress_.startImage();
        Picture picture = rendered(desc, index, prepared, diagnostics);
        while (Interrupts::takeSnapshotRequest() && picture.cancelled) {
            saveSnapshot(picture, partialName(output));
            const double before = picture.stats.renderSeconds;
            picture = rendered(desc, index, prepared, diagnostics);
            picture.stats.renderSeconds += before;
        }
        if (picture.cancelled && isStale() && Interrupts::exitCode() == 0) throw Left{};
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
        for (RunFollower* follower : followers_) follower->savedImage(picture);
        const bool left = picture.cancelled;
        if (checkpoint_ && !picture.cancelled) noteIfAny(checkpoint_->finish());
        stats_.push_back(std::move(picture.stats));
        ++images_;
        if (Interrupts::exitCode() != 0) throw Interrupted{};
        if (left) throw Left{};
    }

    void showPixel(const SceneDesc& desc, const PreparedScene& prepared,
                   const std::string& output) {
        progress_.startImage();
        const PixelTrace trace = renderer_.renderPixel(prepared, listener());
        progress_.abandon();
        if (trace.cancelled) throw Left{};
        reportPixel(trace, prepared.scene, desc, output,
                    [](const std::string& text) { std::fputs(text.c_str(), stdout); });
        if (std::fflush(stdout) != 0) throw OutputError("standard output cannot be written");
    }

    /// Where the picture is a file, the same in every run, and nobody looks on.
    void keepCheckpoint(const ScriptResult& script, const std::string& file,
                        const PreparedScene& prepared, std::function<std::vector<Trait>()> traits) {
        checkpoint_.reset();
        const bool isAsked = options_.resume != Resume::kNo;
        if (isAsked && prepared.options.time) {
            throw UsageError(
                "--resume needs --spp or --error: with --time every run gives other pixels");
        }
        if (isAsked && isStream(file)) {
            throw UsageError("--resume: " + file + " is no file beside which a checkpoint can be");
        }
        const bool isLookedAt = options_.watch || options_.preview;
        const bool isNamed = !isStream(file) && script.scene.name != "-";
        if (!isAsked && (!isNamed || prepared.options.time || isLookedAt)) return;
        checkpoint_.emplace(options_, file, script.filesRead, scriptBegan_, std::move(traits));
        noteIfAny(checkpoint_->open());
        if (checkpoint_->goesOn()) tell("Going on from " + checkpoint_->file());
    }

    bool isStale() const {
        return std::any_of(followers_.begin(), followers_.end(),
                           [](const RunFollower* follower) { return follower->isStale(); });
    }

    RenderListener listener() {
        RenderListener told;
        told.onProgress = [this](double share) { progress_.update(share); };
        told.onEstimate = [this](double error) { progress_.estimate(error); };
        for (RunFollower* follower : followers_) follower->listen(told);
        return told;
    }

    Picture rendered(const SceneDesc& desc, std::size_t index, const PreparedScene& prepared,
                     Diagnostics& diagnostics) {
        RenderListener told = listener();
        if (checkpoint_) {
            checkpoint_->listen(told);
            told.onCheckpoint = [this, save = std::move(told.onCheckpoint)] {
                save();
                if (Interrupts::isSnapshotAsked()) checkpoint_->pause();
            };
        }
        return renderer_.render(desc, index, prepared, told, diagnostics);
    }

    void save(const Picture& picture, const std::string& output) {
        noteIfAny(writeImage(output, picture.image, picture.settings, metadataOf(picture.stats)));
        // Another scene may read it as a texture, and have done so before.
        std::error_code failed;
        renderer_.forget(std::filesystem::weakly_canonical(output, failed).string());
        if (picture.cancelled) {
            progress_.abandon();
            interrupted("what was rendered so far is in " + output);
        } else {
            progress_.finish({output, picture.stats.renderSeconds, picture.stats.errorEstimate});
        }
    }

    void saveSnapshot(const Picture& picture, const std::string& name) {
        if (picture.part) {
            tell("No snapshot: a shard that is not whole is not written");
            return;
        }
        noteIfAny(writeImage(name, picture.image, picture.settings, metadataOf(picture.stats)));
        tell("What is rendered so far is in " + name);
    }

    void interrupted(const std::string& what) {
        const bool isSaved = checkpoint_ && checkpoint_->isSaved();
        const std::string next = isSaved ? "; --resume goes on from " + checkpoint_->file() : "";
        progress_.message("Interrupted; " + what + next);
        if (checkpoint_ && !isSaved) noteIfAny("no checkpoint: " + checkpoint_->problem());
    }

    /// One line for each scene: a failure may have scrolled away.
    void sumUp() {
        for (const EndedScene& ended : ended_) progress_.message(ended.line());
        for (std::size_t i = ended_.size(); i < options_.scenes.size(); ++i) {
            progress_.message(printable(options_.scenes[i], 300) + ": not tried");
        }
    }

    /// Whole or not at all: half a shard would pass for one.
    void savePart(const Picture& picture, const std::string& name) {
        if (picture.cancelled) {
            progress_.abandon();
            interrupted("a shard that is not whole is not written");
            return;
        }
        noteIfAny(writeFile(name, encodePart(*picture.part)));
        progress_.finish({name, picture.stats.renderSeconds, picture.stats.errorEstimate});
    }

    static void printParameters(const ScriptResult& script) {
        if (script.parameters.empty()) std::puts("# The scene reads no parameters.");
        std::fputs(parameterFileText(script.parameters).c_str(), stdout);
    }

    void report(const Diagnostics& diagnostics) {
        for (const std::string& line : warningLines(diagnostics)) say(line);
    }

    void say(const std::string& line) {
        progress_.message(line);
        for (RunFollower* follower : followers_) follower->said(line);
    }

    void noteIfAny(const std::string& sentence) {
        if (!sentence.empty()) say("warning: " + sentence);
    }

    const Options& options_;
    SceneRenderer renderer_;
    CheckpointKeeper::Time scriptBegan_;
    std::optional<CheckpointKeeper> checkpoint_;  ///< of the render at hand
    std::optional<OutputNames> names_;
    Progress progress_;
    std::vector<RunFollower*> followers_;
    std::vector<RenderStats> stats_;
    std::vector<DependencyRule> rules_;
    std::vector<EndedScene> ended_;
    int images_ = 0;  ///< that the scene at hand has written
    int code_ = 0;
    bool begun_ = false;
    bool left_ = false;  ///< the run was left before its end
};

/// Runs once, and shows what came of it until somebody closes the page or a signal comes.
int shown(Batch& batch, PreviewBoard& board) {
    board.beginRound();
    const int code = batch.run();
    board.endRound();
    if (Interrupts::exitCode() == 0) {
        batch.tell("The preview stays until Ctrl-C, or Close on the page");
        board.waitForStop();
    }
    return code;
}

/// Runs again whenever a file changes, until a signal ends it.
int watched(Batch& batch, PreviewBoard* board) {
    Watcher watcher;
    batch.add(watcher);
    while (true) {
        watcher.beginRound();
        if (board) board->beginRound();
        batch.run();
        if (Interrupts::exitCode() != 0) return Interrupts::exitCode();
        watcher.endRound();
        if (board) board->endRound();
        if (!watcher.isStale()) {
            const std::size_t files = watcher.fileCount();
            batch.tell("Watching " + std::to_string(files) + (files == 1 ? " file" : " files") +
                       "; renders again when one changes; Ctrl-C ends");
        }
        const std::vector<std::string> changed = watcher.changes();
        batch.tell("Changed: " + printable(changed.front(), 300) +
                   (changed.size() > 1 ? ", ..." : ""));
        batch.forget(changed);
    }
}

}  // namespace

int renderCommand(const Options& options) {
    requireDefaultScene(options);
    Interrupts::handle();
    Batch batch(options);
    if (!options.preview) return options.watch ? watched(batch, nullptr) : batch.run();
    PreviewServer server(options.previewPort, options.watch);
    batch.add(server.board());
    batch.show("Preview: " + server.address());
    return options.watch ? watched(batch, &server.board()) : shown(batch, server.board());
}

}  // namespace rt
