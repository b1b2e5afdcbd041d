#include "rt/render/render_log.h"

#include "rt/core/error.h"
#include "support/render_script.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

/// Smooth pixels, sampled ones, lights that have to be sampled, paths that are cut.
const char* const kScene = R"(
    local root = gr.node('root')
    local grey = gr.material({0.6, 0.6, 0.6}, {0.2, 0.2, 0.2}, 40)
    root:add_child(gr.nh_box('floor', {-9, -2, -9}, {18, 1, 18}), grey)
    local mirror = gr.nh_sphere('mirror', {-1.2, 0, 0}, 1)
    mirror:set_reflection(0.3)
    root:add_child(mirror, grey)
    local glass = gr.nh_sphere('glass', {1.2, 0, 0.5}, 1)
    glass:set_refraction(1.5, 0.1)
    root:add_child(glass, grey)
    gr.render(root, 'x.png', 60, 40, {0, 1, 7}, {0, -0.15, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.2},
              {gr.light({4, 7, 4}, {0.8, 0.8, 0.8}, {1, 0, 0}, 1.5)}))";

std::vector<std::uint8_t> bytesOf(const RenderLog& log) {
    PackedWriter writer;
    log.write(writer);
    return std::move(writer.bytes());
}

/// As a file would bring it.
void restore(RenderLog& log, const std::vector<std::uint8_t>& bytes) {
    PackedReader reader(bytes);
    log.read(reader);
    CHECK(reader.left() == 0);
}

struct Attempt {
    Picture picture;
    std::vector<std::uint8_t> saved;  ///< where it was cancelled
    int reports = 0;
};

/// From `saved` on, if there is anything, until so many reports of progress.
Attempt attempt(PictureSettings settings, const std::vector<std::uint8_t>& saved, int reports) {
    Attempt result;
    RenderLog log;
    if (!saved.empty()) restore(log, saved);
    std::atomic<bool> cancel{false};
    settings.adjust = [&](RenderJob& job) {
        job.cancel = &cancel;
        job.log = &log;
        job.onCheckpoint = [&] { result.saved = bytesOf(log); };
        job.onProgress = [&](double) { cancel = ++result.reports >= reports; };
    };
    result.picture = renderScript(kScene, settings);
    return result;
}

void checkEqual(const Picture& resumed, const Picture& whole) {
    CHECK(resumed.pixels == whole.pixels);
    CHECK(resumed.errorEstimate == whole.errorEstimate);
    CHECK(resumed.converged == whole.converged);
    CHECK(resumed.counts.rays.camera == whole.counts.rays.camera);
    CHECK(resumed.counts.rays.shadow == whole.counts.rays.shadow);
    CHECK(resumed.counts.cutBound == whole.counts.cutBound);
}

/// Stopped at every `step`-th report, each time going on from what the time before saved.
void checkResumes(const PictureSettings& settings, int step) {
    const Picture whole = renderScript(kScene, settings);
    std::vector<std::uint8_t> saved;
    for (int reports = step;; reports += step) {
        const Attempt next = attempt(settings, saved, reports);
        if (next.saved.empty()) {
            CHECK(reports > 2 * step);
            return checkEqual(next.picture, whole);
        }
        CHECK(next.saved.size() >= saved.size());
        saved = next.saved;
    }
}

}  // namespace

TEST_CASE("a render towards an error that is stopped again and again ends with the same picture") {
    PictureSettings settings;
    settings.options.error = 0.01;
    for (const int threads : {1, 3}) {
        settings.threads = threads;
        for (const int step : {5, 17}) {
            CAPTURE(threads);
            CAPTURE(step);
            checkResumes(settings, step);
        }
    }
}

TEST_CASE("and so does one where every pixel has its own samples") {
    PictureSettings settings;
    settings.options.error = 0.01;
    settings.options.filter = "gaussian";
    checkResumes(settings, 9);
}

TEST_CASE("and one of a number of samples") {
    PictureSettings settings;
    settings.options.spp = 3;
    for (const int threads : {1, 3}) {
        settings.threads = threads;
        checkResumes(settings, 4);
    }
}

TEST_CASE("what a log holds is not traced again") {
    PictureSettings settings;
    settings.options.spp = 2;
    RenderLog log;
    settings.adjust = [&](RenderJob& job) { job.log = &log; };
    // A log of other pixels: they come back as they are in it.
    std::vector<std::uint8_t> saved = attempt(settings, {}, 5).saved;
    PackedWriter one;
    one.word(1);
    one.word(1);
    constexpr std::size_t kCounts = 8 * 7 + 4 * 2;
    constexpr std::size_t kTile = 16 * 16 * 56;
    one.raw(std::span(saved).subspan(8, 4 + kCounts + 4));
    for (std::size_t i = 0; i < kTile / 56; ++i) {
        for (int c = 0; c < 6; ++c) one.real(5.0 + c % 3);
        one.number(std::uint64_t{2});
    }
    restore(log, one.bytes());
    const Picture picture = renderScript(kScene, settings);
    settings.adjust = {};
    CHECK(picture.at(0, 0) == Color(2.5, 3.0, 3.5));
    CHECK(picture.at(15, 15) == Color(2.5, 3.0, 3.5));
    CHECK(picture.at(16, 0) == renderScript(kScene, settings).at(16, 0));
}

TEST_CASE("what was gathered outlives its render, as a file would have it") {
    for (const bool gathers : {true, false}) {
        PictureSettings settings;
        settings.options.spp = 3;
        RenderLog log;
        std::atomic<bool> cancel{false};
        std::vector<std::uint8_t> saved;
        settings.adjust = [&](RenderJob& job) {
            job.cancel = &cancel;
            job.log = &log;
            job.onProgress = [&](double share) { cancel = share > 0.5; };
            job.onCheckpoint = [&] {
                saved = bytesOf(log);
                if (gathers) log.gather();
            };
        };
        renderScript(kScene, settings);
        CHECK((bytesOf(log) == saved) == gathers);
    }
}

TEST_CASE("a log that is cut short, at any byte, is damaged") {
    PictureSettings settings;
    settings.options.spp = 1;
    const std::vector<std::uint8_t> saved = attempt(settings, {}, 2).saved;
    for (std::size_t size = 0; size < saved.size(); size += size < 200 ? 1 : 97) {
        RenderLog log;
        const std::vector<std::uint8_t> cut(saved.begin(),
                                            saved.begin() + static_cast<std::ptrdiff_t>(size));
        PackedReader reader(cut);
        CHECK_THROWS_AS(log.read(reader), DamagedBytes);
    }
}

TEST_CASE("a log of another job is refused, and reads nothing beyond its end") {
    PictureSettings settings;
    settings.options.error = 0.01;
    RenderLog log;
    restore(log, attempt(settings, {}, 40).saved);
    settings.options.spp = 2;
    settings.options.error.reset();
    settings.adjust = [&](RenderJob& job) { job.log = &log; };
    CHECK_THROWS_AS(renderScript(kScene, settings), SceneError);
}
