// The command line: what was asked for, and the one table that says what can be asked for.
#pragma once

#include "rt/app/aov.h"
#include "rt/scene/render_options.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rt {

enum class Command { kRender, kCompare, kGolden, kMerge, kPrint, kHelp, kVersion };

enum class ColorMode { kAuto, kAlways, kNever };

/// In pixels; both at least 1.
struct ImageSize {
    int width = 0;
    int height = 0;
};

/// The pixels with x0 <= x < x1 and y0 <= y < y1; x0 < x1 and y0 < y1.
struct Crop {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
};

/// Frame numbers, both included, first <= last.
struct FrameRange {
    std::int64_t first = 1;
    std::int64_t last = 1;
};

/// Whether a render goes on from its checkpoint; kRequired: or fails where that is damaged.
enum class Resume { kNo, kIfSound, kRequired };

/// `compare A B`.
struct CompareOptions {
    std::string first;
    std::string second;
    std::optional<double> tolerance;  ///< largest RMSE that passes
};

/// `merge OUT PART...`.
struct MergeOptions {
    std::string output;
    std::vector<std::string> parts;
};

/// How much a picture agrees with its reference, from all to least.
enum class GoldenTier { kExact, kPortable, kStatistical };

/// `golden DIR`.
struct GoldenOptions {
    std::string folder;
    bool update = false;
    GoldenTier tier = GoldenTier::kPortable;  ///< the weakest that passes
    std::string report = "golden_report";     ///< folder
};

inline constexpr int kPreviewPort = 8318;

struct Options {
    Command command = Command::kRender;
    CompareOptions compare;
    GoldenOptions golden;
    MergeOptions merge;
    std::string document;  ///< of kPrint; one of documentNames()

    std::vector<std::string> scenes;           ///< "-" is stdin; never empty for kRender
    bool defaultScene = false;                 ///< none was named: scenes is {kDefaultScene}
    std::vector<std::string> scriptArguments;  ///< what follows "--"
    RenderOptions render;                      ///< what the script may say too

    std::optional<std::string> output;  ///< "-" is stdout
    std::optional<ImageSize> size;
    std::optional<Crop> crop;
    std::optional<PixelPlace> pixel;  ///< whose rays are shown, instead of an image
    std::optional<FrameRange> frames;
    std::optional<FrameRange> subset;  ///< of the frames, that are rendered; none: all
    std::optional<Shard> shard;
    std::vector<Aov> aovs;             ///< in the order of the table, each once
    std::optional<std::string> stats;  ///< file
    std::optional<std::string> deps;   ///< file
    Resume resume = Resume::kNo;
    std::optional<double> checkpointEvery;  ///< seconds; 0: only where a signal ends the render

    int threads = 0;                 ///< 0: as many as this process may use
    std::optional<std::string> isa;  ///< baseline, avx2, avx512; none: the best that runs here

    std::map<std::string, std::string> parameters;  ///< -D name=value
    std::vector<std::string> parameterFiles;        ///< --param-file
    bool trust = false;
    std::size_t scriptMemory = std::size_t{2} << 30;  ///< bytes
    double scriptTime = 0.0;                          ///< seconds; 0 = no limit
    std::int64_t maxPixels = std::int64_t{1} << 27;   ///< of one image
    std::int64_t maxInstances = 10'000'000;           ///< of geometry, after expansion
    bool legacyTransforms = false;

    bool explain = false;
    bool check = false;
    bool listParams = false;
    bool failFast = false;
    bool watch = false;
    bool preview = false;
    int previewPort = kPreviewPort;  ///< of the loopback address; 0: any that is free
    bool werror = false;
    bool quiet = false;
    bool verbose = false;
    ColorMode color = ColorMode::kAuto;
};

/// What is asked for by the arguments after the program's name. Throws UsageError, and LimitError
/// for more frames than kMostFrames. Nothing is read from the environment or from files.
Options parseOptions(const std::vector<std::string>& arguments);

inline constexpr std::int64_t kMostFrames = 1'000'000;
inline constexpr int kMostThreads = 1024;
inline constexpr const char* kDefaultScene = "project.lua";

/// One option as --help shows it.
struct OptionHelp {
    std::string section;
    std::string flags;      ///< "-j, --threads"
    std::string valueName;  ///< "" for a flag
    std::string text;
    std::vector<std::string> choices;    ///< all values there are, if they can be listed
    std::vector<std::string> spellings;  ///< "-j" and "--threads"
};

/// The options of a command, in the order of --help.
std::vector<OptionHelp> optionHelp(Command command);

/// Every option there is, the shared ones of optionTable() included, in the order of --help.
std::vector<OptionHelp> optionHelp();

std::string helpText();
std::string versionText();

/// "Usage: ./Project [scene.lua ...] [options] [-- script arguments]".
std::string usageLine();

/// The part of `crop` that lies in an image, and whether that is less than was asked for.
/// Throws UsageError if nothing is left.
std::pair<Crop, bool> clipped(const Crop& crop, int width, int height);

/// Throws SceneError with a hint at the usage if no scene was named and there is no project.lua.
void requireDefaultScene(const Options& options);

}  // namespace rt
