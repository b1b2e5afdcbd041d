#include "rt/app/options.h"

#include "rt/core/diagnostics.h"
#include "rt/core/error.h"
#include "rt/core/text.h"
#include "rt/core/version.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <set>
#include <sstream>
#include <utility>

#include "option_rows.h"
#include "option_values.h"

namespace rt {
namespace {

/// What the words of a command line mean, before any value is looked at.
struct Words {
    std::vector<std::pair<const CommandRow*, std::string>> options;  ///< as they came
    std::vector<std::string> others;                                 ///< scenes or files
};

std::vector<std::string> spellings(const CommandRow& row) {
    const std::size_t comma = row.flags.find(',');
    if (comma == std::string::npos) return {row.flags};
    return {row.flags.substr(0, comma), row.flags.substr(comma + 1)};
}

std::vector<std::string> allSpellings(const std::vector<CommandRow>& rows) {
    std::vector<std::string> all;
    for (const CommandRow& row : rows) {
        for (std::string& spelling : spellings(row)) all.push_back(std::move(spelling));
    }
    return all;
}

[[noreturn]] void refuseUnknown(const std::string& word, const std::vector<CommandRow>& rows) {
    const std::string name = word.substr(0, word.find('='));
    const std::string nearest = nearestName(name, allSpellings(rows));
    const std::string hint =
        nearest.empty() ? "; --help lists all options" : "; did you mean " + nearest + "?";
    throw UsageError("unknown option " + printable(name, 200) + hint);
}

/// Refuses "-o --spp 4", where a value was forgotten.
void refuseFlagAsValue(const CommandRow& row, const std::string& value,
                       const std::vector<std::string>& known) {
    const bool isFlag = std::find(known.begin(), known.end(), value) != known.end();
    if (!isFlag || row.valueName.empty()) return;
    throw UsageError(spellings(row).back() + " needs a value, " + row.valueName + ", before " +
                     value);
}

CLI::Option* addRow(CLI::App& app, const CommandRow& row) {
    // Values are taken from the option afterwards, so nothing needs to be bound to it.
    const auto accept = [](const CLI::results_t&) { return true; };
    CLI::Option* option =
        row.valueName.empty() ? app.add_flag(row.flags) : app.add_option(row.flags, accept);
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (row.valueName.empty()) return option;
    return option->type_name(row.valueName)
        ->expected(1, CLI::detail::expected_max_vector_size)
        ->allow_extra_args(false);
}

Words readWords(std::vector<std::string> arguments, const std::vector<CommandRow>& rows) {
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    std::vector<std::pair<CLI::Option*, const CommandRow*>> added;
    for (const CommandRow& row : rows) added.emplace_back(addRow(app, row), &row);
    std::reverse(arguments.begin(), arguments.end());
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::Error& error) {
        throw UsageError(error.what());
    }
    Words words;
    const std::vector<std::string> known = allSpellings(rows);
    for (const auto& [option, row] : added) {
        for (const std::string& value : option->results()) {
            refuseFlagAsValue(*row, value, known);
            words.options.emplace_back(row, value);
        }
    }
    words.others = app.remaining();
    for (const std::string& word : words.others) {
        if (word.size() > 1 && word[0] == '-') refuseUnknown(word, rows);
    }
    return words;
}

void apply(const Words& words, Options& options) {
    for (const auto& [row, value] : words.options) row->apply(options, value);
}

const std::vector<CommandRow>& compareRows() {
    static const std::vector<CommandRow> table = {
        {"Compare", "--tolerance", "E", "exit with 10 if the RMSE is above E",
         [](Options& o, const std::string& v) {
             o.compare.tolerance = numberFrom("--tolerance", v, 0.0);
         }},
        {"Compare", "-h,--help", "", "show this",
         [](Options& o, const std::string&) { o.command = Command::kHelp; }},
    };
    return table;
}

Options parseCompare(const std::vector<std::string>& arguments) {
    Options options;
    options.command = Command::kCompare;
    const Words words = readWords(arguments, compareRows());
    apply(words, options);
    if (options.command == Command::kHelp) return options;
    if (words.others.size() != 2) {
        throw UsageError("compare needs two images: ./Project compare A B [--tolerance E]");
    }
    options.compare.first = words.others[0];
    options.compare.second = words.others[1];
    return options;
}

const std::vector<CommandRow>& mergeRows() {
    static const std::vector<CommandRow> table = {
        {"Merge", "-h,--help", "", "show this",
         [](Options& o, const std::string&) { o.command = Command::kHelp; }},
    };
    return table;
}

Options parseMerge(const std::vector<std::string>& arguments) {
    Options options;
    options.command = Command::kMerge;
    const Words words = readWords(arguments, mergeRows());
    apply(words, options);
    if (options.command == Command::kHelp) return options;
    if (words.others.size() < 2) {
        throw UsageError("merge needs an image and parts of it: ./Project merge OUT PART...");
    }
    options.merge.output = words.others[0];
    options.merge.parts.assign(words.others.begin() + 1, words.others.end());
    return options;
}

const std::vector<CommandRow>& goldenRows() {
    static const std::vector<std::string> kTiers{"exact", "portable", "statistical"};
    static const std::vector<CommandRow> table = {
        {"Golden", "--update", "", "write the references of what changed or has none",
         [](Options& o, const std::string& v) {
             o.golden.update = wordFrom("--update", v, {"true", "false"}) == 0;
         }},
        {"Golden", "--tier", "NAME",
         "how far a picture may be from its reference: exact, portable (default), statistical",
         [](Options& o, const std::string& v) {
             o.golden.tier = static_cast<GoldenTier>(wordFrom("--tier", v, kTiers));
         },
         kTiers},
        {"Golden", "--report", "DIR", "folder of the report; default golden_report",
         [](Options& o, const std::string& v) {
             if (v.empty()) throw UsageError("--report: the name of the folder is empty");
             o.golden.report = v;
         }},
    };
    return table;
}

/// The options of a render that have a meaning where pictures go nowhere.
bool isForGolden(const CommandRow& row) {
    static const std::set<std::string> without = {
        "-o",        "--crop",         "--pixel",     "--frames",  "--subset",
        "--stats",   "--aov",          "--shard",     "--deps",    "--list-params",
        "--check",   "--explain",      "--fail-fast", "--version", "--watch",
        "--preview", "--preview-port", "--print",     "--resume",  "--checkpoint"};
    return without.count(row.flags) == 0;
}

void refuseContradictions(const RenderOptions& render) {
    if (!render.spp) return;
    if (render.error || render.time) {
        throw UsageError(std::string("--spp gives every pixel the same number of samples, which ") +
                         (render.error ? "--error" : "--time") + " would choose: say one of them");
    }
}

void refuseUnwatchable(const Options& options) {
    if (!options.watch) return;
    const auto& scenes = options.scenes;
    if (std::find(scenes.begin(), scenes.end(), "-") != scenes.end()) {
        throw UsageError("--watch: a scene from standard input does not change; name its file");
    }
    if (options.output == "-") {
        throw UsageError("--watch: standard output takes one image; name a file with -o");
    }
}

void refuseStrangeSubset(const Options& options) {
    if (!options.subset) return;
    if (!options.frames) {
        throw UsageError("--subset: of which frames? Say them with --frames A-B");
    }
    const FrameRange& all = *options.frames;
    if (options.subset->first >= all.first && options.subset->last <= all.last) return;
    throw UsageError("--subset " + std::to_string(options.subset->first) + "-" +
                     std::to_string(options.subset->last) + " reaches beyond --frames " +
                     std::to_string(all.first) + "-" + std::to_string(all.last));
}

/// Known before the first of many images is rendered.
void refuseOneNameForMany(const Options& options) {
    if (!options.output || options.output->find('#') != std::string::npos) return;
    const FrameRange frames = options.subset.value_or(options.frames.value_or(FrameRange{}));
    if (frames.first == frames.last) return;
    throw UsageError("-o " + printable(*options.output, 300) +
                     ": more than one frame would be written to it; put # into the name, which "
                     "becomes the frame's number");
}

void refuseUnseenPixel(const Options& options) {
    if (!options.pixel) return;
    if (options.preview) {
        throw UsageError("--pixel and --preview: the page shows pixels itself; say one of them");
    }
    if (options.render.time) {
        throw UsageError("--pixel needs --spp or --error: --time gives other pixels in every run");
    }
}

void refuseUnresumable(const Options& options) {
    const bool resumes = options.resume != Resume::kNo;
    if (!resumes && options.checkpointEvery.value_or(0.0) == 0.0) return;
    const std::string flag = resumes ? "--resume" : "--checkpoint";
    if (options.watch || options.preview) {
        throw UsageError(flag + (options.watch ? " and --watch" : " and --preview") +
                         ": a render that is looked at keeps no checkpoint; say one of them");
    }
    if (options.output == "-") {
        throw UsageError(flag +
                         ": standard output has no name for a checkpoint; name a file with "
                         "-o");
    }
    if (options.render.time) {
        throw UsageError(flag + " needs --spp or --error: --time gives other pixels in every run");
    }
}

Options parseGolden(const std::vector<std::string>& arguments) {
    std::vector<CommandRow> rows = goldenRows();
    std::copy_if(commandRows().begin(), commandRows().end(), std::back_inserter(rows), isForGolden);
    Options options;
    options.command = Command::kGolden;
    const Words words = readWords(arguments, rows);
    apply(words, options);
    refuseContradictions(options.render);
    if (options.command == Command::kHelp) return options;
    if (words.others.size() != 1) {
        throw UsageError("golden needs one folder: ./Project golden DIR [--update] [options]");
    }
    options.golden.folder = words.others[0];
    return options;
}

/// Flags and value name in the left column, the text beside them, broken between words.
void appendRow(std::string& text, const OptionHelp& row) {
    constexpr std::size_t kColumn = 27;
    constexpr std::size_t kWidth = 100;
    std::string line = (row.flags.compare(0, 2, "--") == 0 ? "      " : "  ") + row.flags;
    if (!row.valueName.empty()) line += " " + row.valueName;
    bool fits = line.size() < kColumn;
    std::istringstream words(row.text);
    for (std::string word; words >> word;) {
        if (!fits || line.size() + 1 + word.size() > kWidth) {
            text += line + "\n";
            line.clear();
        }
        fits = true;
        line.resize(std::max(line.size() + 1, kColumn), ' ');
        line += word;
    }
    text += line + "\n";
}

OptionHelp helpOf(const CommandRow& row) {
    const std::vector<std::string> both = spellings(row);
    return {row.section, joined(both), row.valueName, row.text, row.choices, both};
}

const std::vector<CommandRow>& rowsOf(Command command) {
    if (command == Command::kCompare) return compareRows();
    if (command == Command::kMerge) return mergeRows();
    if (command == Command::kGolden) return goldenRows();
    return commandRows();
}

}  // namespace

Options parseOptions(const std::vector<std::string>& arguments) {
    const auto end = std::find(arguments.begin(), arguments.end(), "--");
    std::vector<std::string> own(arguments.begin(), end);
    if (!own.empty() && (own[0] == "compare" || own[0] == "merge")) {
        const bool compares = own[0] == "compare";
        own.insert(own.end(), end == arguments.end() ? end : end + 1, arguments.end());
        own.erase(own.begin());
        return compares ? parseCompare(own) : parseMerge(own);
    }
    if (!own.empty() && own[0] == "golden") {
        own.erase(own.begin());
        Options golden = parseGolden(own);
        if (end != arguments.end()) golden.scriptArguments.assign(end + 1, arguments.end());
        return golden;
    }
    Options options;
    const Words words = readWords(std::move(own), commandRows());
    apply(words, options);
    refuseContradictions(options.render);
    options.scenes = words.others;
    refuseUnwatchable(options);
    refuseUnresumable(options);
    refuseUnseenPixel(options);
    refuseStrangeSubset(options);
    refuseOneNameForMany(options);
    options.defaultScene = options.scenes.empty();
    if (options.defaultScene) options.scenes = {kDefaultScene};
    if (end != arguments.end()) options.scriptArguments.assign(end + 1, arguments.end());
    return options;
}

std::vector<OptionHelp> optionHelp(Command command) {
    std::vector<OptionHelp> all;
    for (const CommandRow& row : rowsOf(command)) all.push_back(helpOf(row));
    if (command != Command::kGolden) return all;
    for (const CommandRow& row : commandRows()) {
        if (isForGolden(row)) all.push_back(helpOf(row));
    }
    return all;
}

std::vector<OptionHelp> optionHelp() {
    std::vector<OptionHelp> all;
    for (const CommandRow& row : commandRows()) all.push_back(helpOf(row));
    for (const CommandRow& row : compareRows()) all.push_back(helpOf(row));
    for (const CommandRow& row : goldenRows()) all.push_back(helpOf(row));
    return all;
}

std::string usageLine() {
    return "Usage: ./Project [scene.lua ...] [options] [-- script arguments]";
}

std::string helpText() {
    std::string text = usageLine() + "\n       ./Project compare A B [--tolerance E]\n" +
                       "       ./Project merge OUT PART...\n" +
                       "       ./Project golden DIR [--update] [--tier NAME] [options]\n\n" +
                       "Renders scene scripts; without one, " + kDefaultScene + ".\n";
    std::string section;
    for (const OptionHelp& row : optionHelp()) {
        if (row.section != section) text += "\n" + row.section + ":\n";
        section = row.section;
        appendRow(text, row);
    }
    return text +
           "\nExit codes: 0 done, 1 scene, 2 usage, 3 output, 4 limit, 5 internal error,\n"
           "10 comparison failed, 128+n ended by signal n.\n";
}

std::string versionText() {
    return std::string(kProgramName) + " " + kProgramVersion + "\n";
}

std::pair<Crop, bool> clipped(const Crop& crop, int width, int height) {
    const Crop inside{std::max(crop.x0, 0), std::max(crop.y0, 0), std::min(crop.x1, width),
                      std::min(crop.y1, height)};
    if (inside.x0 >= inside.x1 || inside.y0 >= inside.y1) {
        throw UsageError("--crop: no pixel of it lies in the image of " + std::to_string(width) +
                         "x" + std::to_string(height));
    }
    const bool less = inside.x0 != crop.x0 || inside.y0 != crop.y0 || inside.x1 != crop.x1 ||
                      inside.y1 != crop.y1;
    return {inside, less};
}

void requireDefaultScene(const Options& options) {
    if (!options.defaultScene || ::access(kDefaultScene, F_OK) == 0) return;
    const std::string reason = std::strerror(errno);
    throw SceneError(std::string(kDefaultScene) + ": " + reason + " (no scene was named)\n" +
                     usageLine() + "; --help lists all options");
}

}  // namespace rt
