// Renders the scenes of a folder, several times each, and holds them against their images.
#include "golden_report.h"
#include "golden_verdict.h"
#include "output_names.h"
#include "rt/app/commands.h"
#include "rt/core/error.h"
#include "rt/core/text.h"
#include "rt/output/atomic_file.h"
#include "scene_renderer.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace rt {
namespace {

/// Every scene is rendered once with each, and the files must be equal.
constexpr int kThreadCounts[] = {1, 2, 3, 7};
/// How often a scene that is compared by its statistics is rendered, with a seed each.
constexpr int kSeeds = 4;

/// One render of one image.
struct Shot {
    std::string output;
    std::vector<std::uint8_t> bytes;  ///< of its file
    int threads = 0;
    std::uint64_t nonFinite = 0;
    bool timed = false;  ///< compared by its statistics
    std::string file;    ///< where it lies for decoding
};

/// The scripts in a folder, by name.
std::vector<std::string> scenesIn(const std::string& folder) {
    std::vector<std::string> scenes;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".lua" && entry.is_regular_file(error)) {
            scenes.push_back(entry.path().string());
        }
    }
    if (error) throw SceneError("golden: cannot read the folder: " + error.message(), {folder, 0});
    std::sort(scenes.begin(), scenes.end());
    if (scenes.empty()) {
        throw UsageError("golden: the folder '" + printable(folder, 300) +
                         "' holds no scenes, which are files that end in .lua");
    }
    return scenes;
}

class Golden {
  public:
    explicit Golden(const Options& options) : options_(options) {}

    int run() {
        for (const std::string& scene : scenesIn(options_.golden.folder)) attempt(scene);
        if (entries_.empty()) {
            throw UsageError("golden: no script in '" + printable(options_.golden.folder, 300) +
                             "' renders anything");
        }
        writeGoldenReport(options_.golden.report, entries_);
        const auto failed = std::count_if(entries_.begin(), entries_.end(),
                                          [](const GoldenEntry& e) { return !e.passed; });
        std::printf("%zu passed, %zu failed; see %s/index.html\n",
                    entries_.size() - static_cast<std::size_t>(failed),
                    static_cast<std::size_t>(failed), printable(options_.golden.report).c_str());
        return code_;
    }

  private:
    void attempt(const std::string& scene) {
        Diagnostics diagnostics;
        try {
            checkScene(scene, diagnostics);
        } catch (const Error& error) {
            fail(entryFor(scene, scene), error.shown(), error.code());
            if (options_.verbose) std::fprintf(stderr, "%s\n", error.details().c_str());
        }
        for (const std::string& line : warningLines(diagnostics)) {
            std::fprintf(stderr, "%s\n", line.c_str());
        }
        if (options_.werror && diagnostics.total() > 0) {
            fail(entryFor(scene, scene), "has warnings", ExitCode::kScene);
        }
    }

    void checkScene(const std::string& scene, Diagnostics& diagnostics) {
        const std::vector<int> threads = threadCountsFor(scene);
        std::vector<std::vector<Shot>> runs;
        for (std::size_t i = 0; i < threads.size(); ++i) {
            Diagnostics again;
            runs.push_back(shotsOf(scene, threads[i], i, i == 0 ? diagnostics : again));
        }
        for (std::size_t image = 0; image < runs[0].size(); ++image) {
            std::vector<Shot> shots;
            for (std::vector<Shot>& run : runs) {
                if (run.size() > image) shots.push_back(std::move(run[image]));
            }
            checkImage(scene, shots);
        }
    }

    std::vector<int> threadCountsFor(const std::string& scene) const {
        Diagnostics ignored;
        const ScriptResult script = SceneRenderer(options_).runScript(scene, 1, ignored);
        const auto& renders = script.scene.renders;
        const bool timed = std::any_of(renders.begin(), renders.end(), [&](const RenderDesc& r) {
            return isTimed(options_.render.over(r.options));
        });
        if (timed) return std::vector<int>(kSeeds, options_.threads);
        if (options_.threads > 0) return {options_.threads, options_.threads};
        return {std::begin(kThreadCounts), std::end(kThreadCounts)};
    }

    bool isTimed(const RenderOptions& options) const {
        return options.time || options_.golden.tier == GoldenTier::kStatistical;
    }

    /// All images of a script; `run` numbers the seeds of those that need several.
    std::vector<Shot> shotsOf(const std::string& scene, int threads, std::size_t run,
                              Diagnostics& diagnostics) {
        Options options = options_;
        options.threads = threads;
        SceneRenderer renderer(options);
        const ScriptResult script = renderer.runScript(scene, 1, diagnostics);
        std::vector<Shot> shots;
        const std::vector<std::string> names =
            OutputNames(options).namesFor(script.scene, 1, diagnostics);
        for (std::size_t i = 0; i < names.size(); ++i) {
            Shot shot;
            shot.output = names[i];
            shot.threads = renderer.threads();
            shot.file = fileFor(names[i], run);
            renderer.checkOutput(shot.file, script.scene.renders[i]);
            refuseOverwriting(referenceOf(names[i]), script.filesRead);
            PreparedScene prepared = renderer.prepare(script.scene, i, diagnostics);
            shot.timed = isTimed(prepared.options);
            if (shot.timed) {
                prepared.options.seed =
                    prepared.options.seed.value_or(0.0) + static_cast<double>(run);
            }
            const Picture picture = renderer.render(script.scene, i, prepared, {}, diagnostics);
            shot.nonFinite = picture.nonFinite;
            shot.bytes = encodeImage(imageFormatOf(shot.file), picture.image, picture.settings,
                                     metadataOf(picture.stats));
            shots.push_back(std::move(shot));
        }
        return shots;
    }

    void checkImage(const std::string& scene, const std::vector<Shot>& shots) {
        const Shot& shot = shots[0];
        GoldenEntry entry = entryFor(shot.output, scene);
        const std::string reference = referenceOf(shot.output);
        const auto [other, first] = sceneOf_.emplace(reference, scene);
        if (!first) {
            return fail(entry, "its reference is that of another image, of " + other->second);
        }
        std::vector<ComparedImage> pictures;
        for (const Shot& each : shots) {
            if (each.nonFinite > 0) {
                return fail(entry, std::to_string(each.nonFinite) + " samples were not finite");
            }
            if (!shot.timed && each.bytes != shot.bytes) {
                return fail(entry, "the files of " + std::to_string(shot.threads) + " and " +
                                       std::to_string(each.threads) + " threads differ");
            }
            if (!shot.timed && !pictures.empty()) continue;
            writeFile(each.file, each.bytes);
            pictures.push_back(loadForComparison(each.file));
        }
        entry.alone = pictures[0].image;
        options_.golden.update ? update(entry, shots, pictures, reference)
                               : hold(entry, pictures, reference);
    }

    /// What can be said of pictures beside a reference; sets what the report shows.
    Verdict judge(GoldenEntry& entry, const std::vector<ComparedImage>& pictures,
                  const std::string& path) const {
        ComparedImage reference;
        try {
            reference = loadForComparison(path);
        } catch (const Error& error) {
            return {options_.golden.tier, error.what()};
        }
        for (const ComparedImage& picture : pictures) {
            const std::string problem = incomparable(picture, reference);
            if (!problem.empty()) return {options_.golden.tier, problem};
        }
        Verdict verdict = pictures.size() > 1
                              ? statisticalVerdict(pictures, reference)
                              : verdictOf(pictures[0], reference, options_.golden.tier);
        if (verdict.tier == GoldenTier::kExact && verdict.problem.empty()) return verdict;
        entry.alone.reset();
        entry.pair = GoldenPair{pictures[0].image, reference.image};
        return verdict;
    }

    void hold(GoldenEntry& entry, const std::vector<ComparedImage>& pictures,
              const std::string& reference) {
        if (!std::filesystem::exists(reference)) {
            return fail(entry, "has no reference " + reference + " (--update makes one)");
        }
        const Verdict verdict = judge(entry, pictures, reference);
        if (!verdict.problem.empty()) return fail(entry, verdict.problem);
        pass(entry, nameOf(verdict.tier));
    }

    void update(GoldenEntry& entry, const std::vector<Shot>& shots,
                const std::vector<ComparedImage>& pictures, const std::string& reference) {
        if (pictures.size() > 1) {
            const Verdict agreed =
                statisticalVerdict({pictures.begin() + 1, pictures.end()}, pictures[0]);
            if (!agreed.problem.empty()) {
                return fail(entry,
                            "its own renders do not agree, nothing is written: " + agreed.problem);
            }
        }
        const bool there = std::filesystem::exists(reference);
        if (there) {
            const Verdict verdict = judge(entry, pictures, reference);
            const bool same = verdict.problem.empty() && verdict.tier != GoldenTier::kPortable;
            if (same) return pass(entry, "unchanged");
        }
        writeFile(reference, shots[0].bytes);
        pass(entry, there ? "changed, the reference is written" : "the reference is written");
    }

    std::string referenceOf(const std::string& output) const {
        const std::filesystem::path path = std::filesystem::path(options_.golden.folder) / output;
        return path.lexically_normal().string();
    }

    /// A name of its own in the folder of the report.
    std::string fileFor(const std::string& output, std::size_t run) const {
        std::string name = output;
        for (char& c : name) {
            const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                               (c >= 'A' && c <= 'Z') || c == '.' || c == '-';
            if (!plain) c = '_';
        }
        return options_.golden.report + "/run" + std::to_string(run + 1) + "_" + name;
    }

    static GoldenEntry entryFor(const std::string& name, const std::string& scene) {
        GoldenEntry entry;
        entry.name = name;
        entry.scene = scene;
        return entry;
    }

    void pass(GoldenEntry entry, const std::string& verdict) {
        entry.passed = true;
        add(std::move(entry), verdict);
    }

    void fail(GoldenEntry entry, const std::string& problem,
              ExitCode code = ExitCode::kComparison) {
        if (code_ == 0) code_ = static_cast<int>(code);
        add(std::move(entry), problem);
    }

    void add(GoldenEntry entry, const std::string& verdict) {
        entry.verdict = verdict;
        if (!options_.quiet || !entry.passed) {
            std::printf("%s %s: %s\n", entry.passed ? "ok  " : "FAIL",
                        printable(entry.name).c_str(), printable(verdict).c_str());
            std::fflush(stdout);
        }
        entries_.push_back(std::move(entry));
    }

    const Options& options_;
    std::vector<GoldenEntry> entries_;
    std::map<std::string, std::string> sceneOf_;  ///< of each reference
    int code_ = 0;
};

}  // namespace

int goldenCommand(const Options& options) {
    return Golden(options).run();
}

}  // namespace rt
