#include "image_render.h"

#include "interrupts.h"
#include "output_names.h"
#include "pixel_report.h"
#include "rt/app/aov.h"
#include "rt/core/error.h"
#include "rt/output/atomic_file.h"
#include "rt/output/image_writer.h"
#include "scene_report.h"

#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace rt {
namespace {

/// "name.partial.png", for an image that is not finished; a stream stays what it is.
std::string partialName(const std::string& name) {
    if (isStream(name)) return name;
    const auto [stem, extension] = splitExtension(name);
    return stem + ".partial" + extension;
}

RenderSummary summaryOf(const std::string& output, const RenderStats& stats) {
    RenderSummary summary{output, stats.renderSeconds, stats.errorEstimate};
    if (stats.caustics) summary.photons = {stats.caustics->noise, stats.caustics->bias};
    return summary;
}

}  // namespace

std::vector<std::string> filesOf(const Options& options, const std::string& output) {
    if (options.shard) return {partName(output, *options.shard)};
    return imageFiles(output, namesOf(options.aovs));
}

void ImageRender::run(const ImageRequest& request, Diagnostics& diagnostics,
                      std::vector<RenderStats>& stats) {
    const SceneDesc& desc = request.script.scene;
    const std::string& output = request.output;
    const PreparedScene prepared = renderer_.prepare(desc, request.index, diagnostics);
    if (options_.explain) console_.show(explanation(prepared.scene));
    if (options_.check) return;
    if (console_.isStale()) throw Left{};
    if (options_.pixel) return showPixel(request, prepared);
    const auto traits = [&] {
        return traitsOf(options_, prepared.options, request.script, request.index, request.frame);
    };
    const std::uint64_t hash = options_.shard ? sceneHash(traits()) : 0;
    keepCheckpoint(request, prepared, [&, traits] {
        std::vector<Trait> all = traits();
        for (Trait& trait : partTraitsOf(options_)) all.push_back(std::move(trait));
        return all;
    });

    for (RunFollower* follower : console_.followers()) follower->startsImage(output, prepared);
    std::optional<Interrupts::Deferred> deferred(std::in_place, checkpoint_.has_value());
    console_.progress().startImage();
    Picture picture = rendered(request, prepared, diagnostics);
    while (Interrupts::takeSnapshotRequest() && picture.cancelled) {
        saveSnapshot(picture, partialName(output));
        const double before = picture.stats.renderSeconds;
        picture = rendered(request, prepared, diagnostics);
        picture.stats.renderSeconds += before;
    }
    if (picture.cancelled && console_.isStale() && Interrupts::exitCode() == 0) throw Left{};
    // Nobody may be reading a pipe, while a file takes a moment and must not be lost.
    if (isStream(output)) deferred.reset();
    picture.stats.output = output;
    picture.stats.warnings = diagnostics.total();
    if (picture.part) {
        picture.part->sceneHash = hash;
        savePart(picture, filesOf(options_, output)[0]);
    } else {
        save(picture, picture.cancelled ? partialName(output) : output);
    }
    for (RunFollower* follower : console_.followers()) follower->savedImage(picture);
    if (checkpoint_ && !picture.cancelled) console_.warnIfAny(checkpoint_->finish());
    stats.push_back(std::move(picture.stats));
    if (Interrupts::exitCode() != 0) throw Interrupted{};
    if (picture.cancelled) throw Left{};
}

void ImageRender::showPixel(const ImageRequest& request, const PreparedScene& prepared) {
    console_.progress().startImage();
    const PixelTrace trace = renderer_.renderPixel(prepared, listener());
    console_.progress().abandon();
    if (trace.cancelled) throw Left{};
    reportPixel(trace, prepared.scene, request.script.scene, request.output,
                [](const std::string& text) { std::fputs(text.c_str(), stdout); });
    if (std::fflush(stdout) != 0) throw OutputError("standard output cannot be written");
}

/// Where the picture is a file, the same in every run, and nobody looks on.
void ImageRender::keepCheckpoint(const ImageRequest& request, const PreparedScene& prepared,
                                 std::function<std::vector<Trait>()> traits) {
    checkpoint_.reset();
    const std::string file = filesOf(options_, request.output)[0];
    const bool isAsked = options_.resume != Resume::kNo;
    if (isAsked && prepared.options.time) {
        throw UsageError(
            "--resume needs --spp or --error: with --time every run gives other pixels");
    }
    if (isAsked && isStream(file)) {
        throw UsageError("--resume: " + file + " is no file beside which a checkpoint can be");
    }
    const bool isLookedAt = options_.watch || options_.preview;
    const bool isNamed = !isStream(file) && request.script.scene.name != "-";
    if (!isAsked && (!isNamed || prepared.options.time || isLookedAt)) return;
    checkpoint_.emplace(options_, file, request.script.filesRead, request.scriptBegan,
                        std::move(traits));
    console_.warnIfAny(checkpoint_->open());
    if (checkpoint_->goesOn()) console_.tell("Going on from " + checkpoint_->file());
}

RenderListener ImageRender::listener() {
    RenderListener told;
    told.onProgress = [this](double share) { console_.progress().update(share); };
    told.onEstimate = [this](double error) { console_.progress().estimate(error); };
    for (RunFollower* follower : console_.followers()) follower->listen(told);
    return told;
}

Picture ImageRender::rendered(const ImageRequest& request, const PreparedScene& prepared,
                              Diagnostics& diagnostics) {
    RenderListener told = listener();
    if (checkpoint_) {
        checkpoint_->listen(told);
        told.onCheckpoint = [this, save = std::move(told.onCheckpoint)] {
            save();
            if (Interrupts::isSnapshotAsked()) checkpoint_->pause();
        };
    }
    return renderer_.render(request.script.scene, request.index, prepared, told, diagnostics);
}

void ImageRender::save(const Picture& picture, const std::string& output) {
    console_.warnIfAny(
        writeImage(output, picture.image, picture.settings, metadataOf(picture.stats)));
    // Another scene may read it as a texture, and have done so before.
    std::error_code failed;
    renderer_.forget(std::filesystem::weakly_canonical(output, failed).string());
    if (picture.cancelled) {
        console_.progress().abandon();
        interrupted("what was rendered so far is in " + output);
    } else {
        console_.progress().finish(summaryOf(output, picture.stats));
    }
}

/// Whole or not at all: half a shard would pass for one.
void ImageRender::savePart(const Picture& picture, const std::string& name) {
    if (picture.cancelled) {
        console_.progress().abandon();
        interrupted("a shard that is not whole is not written");
        return;
    }
    console_.warnIfAny(writeFile(name, encodePart(*picture.part)));
    console_.progress().finish(summaryOf(name, picture.stats));
}

void ImageRender::saveSnapshot(const Picture& picture, const std::string& name) {
    if (picture.part) {
        console_.tell("No snapshot: a shard that is not whole is not written");
        return;
    }
    console_.warnIfAny(
        writeImage(name, picture.image, picture.settings, metadataOf(picture.stats)));
    console_.tell("What is rendered so far is in " + name);
}

void ImageRender::interrupted(const std::string& what) {
    const bool isSaved = checkpoint_ && checkpoint_->isSaved();
    const std::string next = isSaved ? "; --resume goes on from " + checkpoint_->file() : "";
    console_.show("Interrupted; " + what + next);
    if (checkpoint_ && !isSaved) console_.warnIfAny("no checkpoint: " + checkpoint_->problem());
}

}  // namespace rt
