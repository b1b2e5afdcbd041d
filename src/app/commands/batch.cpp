#include "batch.h"

#include "interrupts.h"
#include "rt/app/stats.h"
#include "rt/core/error.h"
#include "rt/output/atomic_file.h"
#include "rt/output/image_writer.h"
#include "rt/script/parameter_file.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <new>

namespace rt {
namespace {

/// The outputs that are files; nothing can depend on a stream.
std::vector<std::string> imagesOf(const std::vector<std::string>& outputs) {
    std::vector<std::string> files;
    std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(files),
                 [](const std::string& output) { return !isStream(output); });
    return files;
}

void printParameters(const ScriptResult& script) {
    if (script.parameters.empty()) std::puts("# The scene reads no parameters.");
    std::fputs(parameterFileText(script.parameters).c_str(), stdout);
}

}  // namespace

Batch::Batch(const Options& options, RunConsole& console)
    : options_(options),
      console_(console),
      renderer_(options),
      image_(options, renderer_, console) {}

std::string Batch::Ended::line() const {
    const std::string count = std::to_string(images) + (images == 1 ? " image" : " images");
    return printable(name, 300) + ": " +
           (code == 0 ? "done, " : "failed with exit code " + std::to_string(code) + ", ") + count;
}

int Batch::run() {
    names_.emplace(options_);
    stats_.clear();
    rules_.clear();
    ended_.clear();
    left_ = false;
    int firstCode = 0;
    for (const auto& file : {options_.stats, options_.deps}) {
        if (file) checkWritable(*file);
    }
    if (!begun_) console_.progress().begin(renderer_.threads());
    begun_ = true;
    for (const std::string& scene : options_.scenes) {
        const std::size_t before = stats_.size();
        const int code = attempt(scene);
        ended_.push_back({scene, code, stats_.size() - before});
        if (firstCode == 0) firstCode = code;
        if (left_) break;
        if (code != 0 && (options_.failFast || Interrupts::exitCode() != 0)) break;
    }
    if (console_.isStale()) return firstCode;
    if (options_.pixel) return firstCode;
    if (options_.stats) console_.warnIfAny(writeStats(*options_.stats, stats_));
    // Of a run that failed not all is known: make tries again by the older rules.
    if (options_.deps && firstCode == 0 && !left_)
        console_.warnIfAny(writeDependencies(*options_.deps, rules_));
    if (options_.scenes.size() > 1 && !options_.quiet) sumUp();
    return firstCode;
}

void Batch::forget(const std::vector<std::string>& files) {
    for (const std::string& file : files) renderer_.forget(file);
}

int Batch::attempt(const std::string& scene) {
    Diagnostics diagnostics;
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
        console_.progress().abandon();
        left_ = true;
    } catch (const Error& error) {
        return failed(error, diagnostics);
    } catch (const std::bad_alloc&) {
        return failed(LimitError("the system has no memory left"), diagnostics);
    } catch (const std::exception& error) {
        const std::string words = std::string("internal error: ") + error.what();
        return failed(Error(ExitCode::kInternal, {}, words + "; please report it"), diagnostics);
    }
    report(diagnostics);
    const bool strict = options_.werror && diagnostics.total() > 0;
    return code != 0 ? code : static_cast<int>(strict ? ExitCode::kScene : ExitCode::kDone);
}

int Batch::failed(const Error& error, const Diagnostics& diagnostics) {
    console_.progress().abandon();
    report(diagnostics);
    console_.say(error.shown());
    if (options_.verbose && !error.details().empty()) console_.show(error.details());
    return static_cast<int>(error.code());
}

void Batch::runScene(const std::string& path, std::int64_t frame, Diagnostics& diagnostics) {
    const ScriptResult script = ranScript(path, frame, diagnostics);
    if (options_.listParams) return printParameters(script);
    const std::vector<std::string> outputs = names_->namesFor(script.scene, frame, diagnostics);
    rules_.push_back({imagesOf(outputs), script.filesRead});
    checkOutputs(script, outputs);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        image_.run({script, i, frame, outputs[i], scriptBegan_}, diagnostics, stats_);
    }
}

/// Before anything is rendered.
void Batch::checkOutputs(const ScriptResult& script,
                         const std::vector<std::string>& outputs) const {
    for (const auto& file : {options_.stats, options_.deps}) {
        if (file) refuseOverwriting(*file, script.filesRead);
    }
    if (options_.check || options_.pixel) return;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (const std::string& file : filesOf(options_, outputs[i])) {
            refuseOverwriting(file, script.filesRead);
        }
        renderer_.checkOutput(outputs[i], script.scene.renders[i]);
    }
}

ScriptResult Batch::ranScript(const std::string& path, std::int64_t frame,
                              Diagnostics& diagnostics) {
    ScriptFiles files;
    scriptBegan_ = std::chrono::system_clock::now();
    const auto tell = [&] {
        for (RunFollower* follower : console_.followers()) follower->ranScript(path, files);
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

/// One line for each scene: a failure may have scrolled away.
void Batch::sumUp() {
    for (const Ended& ended : ended_) console_.show(ended.line());
    for (std::size_t i = ended_.size(); i < options_.scenes.size(); ++i) {
        console_.show(printable(options_.scenes[i], 300) + ": not tried");
    }
}

void Batch::report(const Diagnostics& diagnostics) {
    for (const std::string& line : warningLines(diagnostics)) console_.say(line);
}

}  // namespace rt
