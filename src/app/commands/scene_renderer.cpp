#include "scene_renderer.h"

#include "interrupts.h"
#include "rt/compile/compile.h"
#include "rt/compile/trace_settings.h"
#include "rt/core/error.h"
#include "rt/core/parallel.h"
#include "rt/core/text.h"
#include "rt/output/atomic_file.h"
#include "rt/render/first_hits.h"
#include "rt/render/kernel_choice.h"
#include "scene_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace rt {
namespace {

ScriptSettings scriptSettings(const Options& options, std::int64_t frame) {
    ScriptSettings settings;
    settings.arguments = options.scriptArguments;
    settings.parameters = options.parameters;
    settings.parameterFiles = options.parameterFiles;
    settings.frame = static_cast<int>(frame);
    if (options.frames && options.frames->last > options.frames->first) {
        settings.time = static_cast<double>(frame - options.frames->first) /
                        static_cast<double>(options.frames->last - options.frames->first);
    }
    if (options.size) settings.largestSide = std::max(options.size->width, options.size->height);
    settings.trust = options.trust;
    settings.legacyTransforms = options.legacyTransforms;
    settings.memoryLimit = options.scriptMemory;
    settings.timeLimit = options.scriptTime;
    settings.printToStderr = options.output == "-" || options.pixel;
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

Tile wholeOf(const RenderScene& scene) {
    return {0, 0, scene.width, scene.height};
}

/// `inPart`: pixels without samples are another shard's.
void countSamples(const Film& film, bool inPart, RenderStats& stats) {
    stats.sppMin = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t total = 0;
    std::uint64_t pixels = 0;
    for (const PixelState& pixel : film.pixels) {
        if (inPart && pixel.samples == 0) continue;
        ++pixels;
        total += pixel.samples;
        stats.sppMin = std::min(stats.sppMin, pixel.samples);
        stats.sppMax = std::max(stats.sppMax, pixel.samples);
    }
    if (pixels == 0) stats.sppMin = 0;
    stats.sppMean =
        static_cast<double>(total) / static_cast<double>(std::max<std::uint64_t>(pixels, 1));
}

void warnIfNotConverged(const RenderStats& stats, const RenderDesc& render,
                        Diagnostics& diagnostics) {
    if (stats.converged || !stats.errorTarget || !stats.errorEstimate) return;
    diagnostics.warn("not-converged", render.where,
                     "the estimated error is " + shortest(*stats.errorEstimate) +
                         ", more than the target of " + shortest(*stats.errorTarget) +
                         " (see --max-spp)");
}

void warnOfCaustics(const RenderOutcome& outcome, const RenderStats& stats,
                    const RenderDesc& render, Diagnostics& diagnostics) {
    if (!outcome.caustics || outcome.caustics->isEnough || outcome.cancelled) return;
    if (!stats.errorTarget || stats.converged) return;
    diagnostics.warn("caustics", render.where,
                     "the light of photons is off by about " +
                         shortest(std::sqrt(outcome.caustics->squaredError())) +
                         ", and more than the " + std::to_string(outcome.caustics->kept) +
                         " of them do not help, or do not fit into memory");
}

void warnOfNonFinite(const TraceCounts& counts, const RenderDesc& render,
                     Diagnostics& diagnostics) {
    if (counts.nonFinite == 0) return;
    diagnostics.warn("non-finite", render.where,
                     std::to_string(counts.nonFinite) +
                         " samples were not finite and count as black, the first in pixel " +
                         std::to_string(counts.nonFiniteX) + "," +
                         std::to_string(counts.nonFiniteY));
}

}  // namespace

std::vector<std::string> warningLines(const Diagnostics& diagnostics) {
    std::vector<std::string> lines;
    for (const Diagnostics::Warning& warning : diagnostics.shown()) {
        lines.push_back(warning.where.prefix() + "warning: " + warning.message + " [-W" +
                        warning.kind + "]");
    }
    for (const auto& [kind, count] : diagnostics.countByKind()) {
        if (count <= Diagnostics::kShownPerKind) continue;
        lines.push_back("warning: " + std::to_string(count - Diagnostics::kShownPerKind) +
                        " more of [-W" + kind + "]");
    }
    return lines;
}

SceneRenderer::SceneRenderer(const Options& options)
    : options_(options),
      threads_(options.threads > 0 ? options.threads : availableThreads()),
      kernel_(chooseKernel(options.isa.value_or(""))),
      assets_(threads_) {}

ScriptResult SceneRenderer::runScript(const std::string& path, std::int64_t frame,
                                      Diagnostics& diagnostics, ScriptFiles* files) {
    assets_.forgetTables();
    return rt::runScript(path, scriptSettings(options_, frame), diagnostics, files);
}

PreparedScene SceneRenderer::prepare(const SceneDesc& desc, std::size_t index,
                                     Diagnostics& diagnostics) {
    const RenderDesc& render = desc.renders[index];
    PreparedScene prepared;
    prepared.options = options_.render.over(render.options);
    const auto began = std::chrono::steady_clock::now();
    prepared.scene = compiled(desc, index, prepared.options, diagnostics);
    prepared.buildSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    const bool clips = options_.crop &&
                       clipped(*options_.crop, prepared.scene.width, prepared.scene.height).second;
    if (clips) {
        diagnostics.warn("crop", render.where, "--crop reaches beyond the image and is clipped");
    }
    if (options_.shard && options_.shard->count > 1 &&
        samplingGoal(prepared.options).errorTarget > 0.0) {
        diagnostics.warn(
            "shard", render.where,
            "towards an error target every shard renders the whole picture, for all of "
            "it decides where samples go; --spp divides the work");
    }
    return prepared;
}

Picture SceneRenderer::render(const SceneDesc& desc, std::size_t index,
                              const PreparedScene& prepared, const RenderListener& listener,
                              Diagnostics& diagnostics) const {
    const RenderOutcome outcome =
        rt::render(prepared.scene, jobFor(prepared.scene, prepared.options, listener));
    warnOfNonFinite(outcome.counts, desc.renders[index], diagnostics);
    Picture picture;
    picture.settings = imageSettings(prepared.options);
    picture.stats = statsOf(prepared.scene, prepared.options, outcome);
    picture.stats.scene = desc.name;
    warnOfCaustics(outcome, picture.stats, desc.renders[index], diagnostics);
    const Tile area = areaOf(prepared.scene);
    if (options_.shard) {
        picture.part = partOf(outcome, prepared, picture.stats);
    } else {
        picture.image = imageOf(outcome.film, area);
        if (!outcome.cancelled) picture.image.planes = planesBeside(outcome, prepared, area);
    }
    picture.stats.buildSeconds = prepared.buildSeconds;
    picture.cancelled = outcome.cancelled;
    picture.nonFinite = outcome.counts.nonFinite;
    warnIfNotConverged(picture.stats, desc.renders[index], diagnostics);
    return picture;
}

PixelTrace SceneRenderer::renderPixel(const PreparedScene& prepared,
                                      const RenderListener& listener) const {
    const RenderScene& scene = prepared.scene;
    const PixelPlace place = *options_.pixel;
    if (place.x >= scene.width || place.y >= scene.height) {
        throw UsageError("--pixel " + std::to_string(place.x) + "," + std::to_string(place.y) +
                         ": the image has " + std::to_string(scene.width) + "x" +
                         std::to_string(scene.height) + " pixels, counted from 0");
    }
    if (prepared.options.time) {
        throw UsageError("--pixel needs --spp or --error: --time gives other pixels in every run");
    }
    const RenderJob job = jobFor(scene, prepared.options, listener);
    const RenderOutcome outcome = rt::render(scene, job);
    TraceSettings settings = traceSettingsOf(job);
    settings.photons = outcome.photons.get();
    return {place, outcome.film.at(place.x, place.y), settings, outcome.photons, outcome.cancelled};
}

std::vector<ImagePlane> SceneRenderer::planesBeside(const RenderOutcome& outcome,
                                                    const PreparedScene& prepared,
                                                    const Tile& area) const {
    std::vector<FirstHit> hits;
    if (std::any_of(options_.aovs.begin(), options_.aovs.end(), isFirstHit)) {
        hits = firstHits(prepared.scene, samplingGoal(prepared.options).trace, area, threads_,
                         kernel_);
    }
    return planesOf(options_.aovs, {outcome.film, outcome.pixelErrors, hits}, area);
}

PartTile SceneRenderer::partTileOf(const RenderOutcome& outcome, const PreparedScene& prepared,
                                   const Tile& place) const {
    PartTile tile;
    tile.tile = place;
    for (int y = place.y0; y < place.y1; ++y) {
        for (int x = place.x0; x < place.x1; ++x) tile.pixels.push_back(outcome.film.at(x, y));
    }
    for (ImagePlane& plane : planesBeside(outcome, prepared, place)) {
        tile.planes.push_back(std::move(plane.values));
    }
    return tile;
}

PicturePart SceneRenderer::partOf(const RenderOutcome& outcome, const PreparedScene& prepared,
                                  const RenderStats& stats) const {
    PicturePart part;
    part.seed = stats.seed;
    part.width = prepared.scene.width;
    part.height = prepared.scene.height;
    part.area = areaOf(prepared.scene);
    part.shard = *options_.shard;
    part.settings = imageSettings(prepared.options);
    part.planned = stats.errorTarget.has_value();
    if (part.planned) {
        part.samplesPerPixel = stats.sppMean;
        part.error = stats.errorEstimate;
    }
    if (outcome.caustics) part.causticError = outcome.caustics->squaredError();
    part.scene = stats.scene;
    part.planes = planesBeside(outcome, prepared, {});
    const std::vector<Tile> tiles = tilesOf(part.area);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (!part.shard.owns(i)) continue;
        part.tiles.push_back(partTileOf(outcome, prepared, tiles[i]));
        if (part.planned) continue;
        part.tiles.back().cutBound = outcome.tileCounts[i].cutBound;
        part.tiles.back().cameraRays = outcome.tileCounts[i].rays.camera;
    }
    return part;
}

ImageMetadata metadataOf(const RenderStats& stats) {
    ImageMetadata metadata;
    metadata.scene = stats.scene;
    metadata.seed = stats.seed;
    metadata.samplesPerPixel = stats.sppMean;
    metadata.error = stats.errorEstimate;
    return metadata;
}

void SceneRenderer::checkOutput(const std::string& output, const RenderDesc& render) const {
    refuseTooManyPixels(render);
    if (options_.shard) {
        checkShard(render);
        return checkWritable(partName(output, *options_.shard));
    }
    ImageSize size = options_.size.value_or(ImageSize{render.width, render.height});
    if (options_.crop) {
        const Crop crop = clipped(*options_.crop, size.width, size.height).first;
        size = {crop.x1 - crop.x0, crop.y1 - crop.y0};
    }
    checkImageOutput(output, size.width, size.height,
                     imageSettings(options_.render.over(render.options)), namesOf(options_.aovs));
}

/// Where time decides, shards would not fit together.
void SceneRenderer::checkShard(const RenderDesc& render) const {
    if (!options_.render.over(render.options).time) return;
    throw UsageError("--shard needs --spp or --error: --time gives other pixels in every run");
}

RenderScene SceneRenderer::compiled(const SceneDesc& desc, std::size_t index,
                                    const RenderOptions& options, Diagnostics& diagnostics) {
    CompileSettings settings;
    if (options_.size) {
        settings.width = options_.size->width;
        settings.height = options_.size->height;
    }
    settings.threads = threads_;
    settings.smoothAngleDegrees = options.smoothAngle.value_or(settings.smoothAngleDegrees);
    settings.flipV = options.flipV.value_or(false);
    settings.caustics = options.caustics.value_or(false);
    settings.srgb = options.transfer.value_or("raw") == "srgb";
    settings.maxInstances = static_cast<std::uint64_t>(options_.maxInstances);
    settings.maxPixels = static_cast<std::uint64_t>(options_.maxPixels);
    refuseTooManyPixels(desc.renders[index]);
    return compileScene(desc, index, settings, assets_, diagnostics);
}

void SceneRenderer::refuseTooManyPixels(const RenderDesc& render) const {
    const std::int64_t width = options_.size ? options_.size->width : render.width;
    const std::int64_t height = options_.size ? options_.size->height : render.height;
    if (width * height <= options_.maxPixels) return;
    throw LimitError("gr.render: " + std::to_string(width) + "x" + std::to_string(height) +
                         " pixels need " +
                         std::to_string((width * height * std::int64_t{sizeof(PixelState)}) >> 20) +
                         " MB, more than the limit of " + std::to_string(options_.maxPixels) +
                         " pixels (see --max-pixels)",
                     render.where);
}

RenderJob SceneRenderer::jobFor(const RenderScene& scene, const RenderOptions& options,
                                const RenderListener& listener) const {
    const SamplingGoal goal = samplingGoal(options);
    RenderJob job;
    job.settings = goal.trace;
    job.errorTarget = goal.errorTarget;
    job.causticTarget = goal.causticTarget;
    job.adaptive = goal.adaptive;
    // Towards an error target a pixel's samples depend on the whole image's error.
    job.area = goal.errorTarget > 0.0 ? wholeOf(scene) : areaOf(scene);
    if (!options_.pixel) job.shard = options_.shard.value_or(Shard{});
    job.wantsPixelErrors =
        std::find(options_.aovs.begin(), options_.aovs.end(), Aov::kError) != options_.aovs.end();
    job.threads = threads_;
    job.timeLimit = goal.timeLimit;
    job.kernel = &kernel_;
    job.cancel = &Interrupts::requested();
    job.onProgress = listener.onProgress;
    job.onEstimate = listener.onEstimate;
    job.onSnapshot = listener.onSnapshot;
    job.wantsSnapshot = listener.wantsSnapshot;
    job.log = listener.log;
    job.onCheckpoint = listener.onCheckpoint;
    job.checkpointEvery = listener.checkpointEvery;
    return job;
}

Tile SceneRenderer::areaOf(const RenderScene& scene) const {
    if (options_.pixel) {
        const PixelPlace& at = *options_.pixel;
        return {at.x, at.y, at.x + 1, at.y + 1};
    }
    if (!options_.crop) return wholeOf(scene);
    const Crop crop = clipped(*options_.crop, scene.width, scene.height).first;
    return {crop.x0, crop.y0, crop.x1, crop.y1};
}

RenderStats SceneRenderer::statsOf(const RenderScene& scene, const RenderOptions& options,
                                   const RenderOutcome& outcome) const {
    RenderStats stats;
    stats.width = areaOf(scene).width();
    stats.height = areaOf(scene).height();
    stats.threads = threads_;
    stats.seed = static_cast<std::uint64_t>(options.seed.value_or(0.0));
    countSamples(outcome.film, options_.shard.has_value(), stats);
    stats.converged = outcome.converged;
    stats.errorEstimate = outcome.errorEstimate;
    stats.caustics = outcome.caustics;
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
    stats.passes = outcome.passes;
    stats.cutPaths = outcome.counts.cutPaths;
    stats.cutErrorBound =
        outcome.counts.cutBound / std::max(1.0, static_cast<double>(outcome.counts.rays.camera));
    stats.features = featuresOf(scene);
    stats.skipped = skippedBy(scene);
    return stats;
}

}  // namespace rt
