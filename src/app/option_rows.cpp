#include "option_rows.h"

#include "option_values.h"
#include "rt/app/documents.h"
#include "rt/core/error.h"
#include "rt/core/text.h"

#include <limits>

namespace rt {
namespace {

constexpr const char* kOutput = "Output";
constexpr const char* kQuality = "Quality (a script can say these too, with gr.options)";
constexpr const char* kScript = "Script";
constexpr const char* kRun = "Run";
constexpr const char* kMessages = "Messages";

using Rows = std::vector<CommandRow>;

CommandRow flag(const char* section, const char* flags, const char* text, bool Options::*member) {
    const std::string name = flags;
    return {section, flags, "", text, [member, name](Options& o, const std::string& value) {
                o.*member = wordFrom(name, value, {"true", "false"}) == 0;
            }};
}

/// ": depth, normal" after a text, for --help.
std::string listed(const std::vector<std::string>& words) {
    return words.empty() ? "" : ": " + joined(words);
}

void addOutputRows(Rows& rows) {
    rows.push_back({kOutput, "-o", "FILE",
                    "where the image goes, instead of where the script says; - is stdout; a # "
                    "becomes the number of the frame or image",
                    [](Options& o, const std::string& v) {
                        if (v.empty()) throw UsageError("-o: the name of the file is empty");
                        o.output = v;
                    }});
    rows.push_back({kOutput, "--size", "WxH", "size of the image in pixels",
                    [](Options& o, const std::string& v) { o.size = sizeFrom("--size", v); }});
    rows.push_back({kOutput, "--crop", "x0,y0,x1,y1",
                    "render and write these pixels only: x0 <= x < x1, y0 <= y < y1",
                    [](Options& o, const std::string& v) { o.crop = cropFrom("--crop", v); }});
    rows.push_back({kOutput, "--pixel", "x,y",
                    "print the rays behind one pixel, and what each brings, instead of an image",
                    [](Options& o, const std::string& v) { o.pixel = pixelFrom("--pixel", v); }});
    rows.push_back(
        {kOutput, "--frames", "A-B", "render an animation's frames A to B",
         [](Options& o, const std::string& v) { o.frames = framesFrom("--frames", v); }});
    rows.push_back(
        {kOutput, "--subset", "C-D",
         "render only frames C to D of those of --frames; gr.time is as for all of them",
         [](Options& o, const std::string& v) { o.subset = framesFrom("--subset", v); }});
    rows.push_back({kOutput, "--shard", "i/n",
                    "render the i-th of n parts, for ./Project merge to join",
                    [](Options& o, const std::string& v) { o.shard = shardFrom("--shard", v); }});
    rows.push_back(
        {kOutput, "--resume", "",
         "go on from the image's checkpoint, if there is one; with =require, a damaged "
         "one is an error",
         [](Options& o, const std::string& v) {
             constexpr Resume kMeanings[] = {Resume::kIfSound, Resume::kNo, Resume::kRequired};
             o.resume = kMeanings[wordFrom("--resume", v, {"true", "false", "require"})];
         }});
    rows.push_back({kOutput, "--checkpoint", "S",
                    "save a checkpoint every S seconds; default 60 with --resume, else 0, which is "
                    "only where a signal ends the render",
                    [](Options& o, const std::string& v) {
                        o.checkpointEvery = numberFrom("--checkpoint", v, 0.0);
                    }});
    rows.push_back({kOutput, "--aov", "NAMES", "more images beside the output" + listed(aovNames()),
                    [](Options& o, const std::string& v) { o.aovs = aovsFrom("--aov", v); },
                    aovNames()});
    rows.push_back({kOutput, "--stats", "FILE", "write statistics as JSON",
                    [](Options& o, const std::string& v) {
                        if (v.empty()) throw UsageError("--stats: the name of the file is empty");
                        o.stats = v;
                    }});
    rows.push_back({kOutput, "--deps", "FILE",
                    "write what the images depend on, as rules for make and ninja",
                    [](Options& o, const std::string& v) {
                        if (v.empty()) throw UsageError("--deps: the name of the file is empty");
                        o.deps = v;
                    }});
}

void addSharedRows(Rows& rows) {
    for (const OptionRow& row : optionTable()) {
        rows.push_back({kQuality, "--" + std::string(row.name), row.valueName,
                        row.help + listed(row.choices),
                        [&row](Options& o, const std::string& v) { storeShared(row, v, o.render); },
                        row.choices});
    }
}

void addScriptRows(Rows& rows) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    rows.push_back({kScript, "-D", "name=value", "set a parameter of the script (gr.param)",
                    [](Options& o, const std::string& v) {
                        const auto [name, value] = parameterFrom("-D", v);
                        o.parameters[name] = value;
                    }});
    rows.push_back({kScript, "--param-file", "FILE",
                    "set parameters by lines \"name = value\"; -D counts more",
                    [](Options& o, const std::string& v) {
                        if (v.empty()) throw UsageError("--param-file: the name is empty");
                        o.parameterFiles.push_back(v);
                    }});
    rows.push_back(flag(kScript, "--list-params",
                        "list the script's parameters, as a file for --param-file",
                        &Options::listParams));
    rows.push_back(
        flag(kScript, "--trust", "let the script read and write files anywhere", &Options::trust));
    rows.push_back({kScript, "--script-memory", "BYTES",
                    "most memory of a script, with K, M or G; default 2G",
                    [](Options& o, const std::string& v) {
                        o.scriptMemory = bytesFrom("--script-memory", v);
                    }});
    rows.push_back({kScript, "--script-time", "S", "most seconds of a script; default 0, no limit",
                    [](Options& o, const std::string& v) {
                        o.scriptTime = numberFrom("--script-time", v, 0.0);
                    }});
    rows.push_back({kScript, "--max-pixels", "N", "most pixels of an image; default 134217728",
                    [](Options& o, const std::string& v) {
                        o.maxPixels = wholeIn("--max-pixels", v, 1, kMost);
                    }});
    rows.push_back({kScript, "--max-instances", "N",
                    "most objects after instancing; default 10000000",
                    [](Options& o, const std::string& v) {
                        o.maxInstances = wholeIn("--max-instances", v, 1, kMost);
                    }});
    rows.push_back(flag(kScript, "--legacy-transforms",
                        "multiply transforms from the right, as scenes of before 2015 expect",
                        &Options::legacyTransforms));
}

void addRunRows(Rows& rows) {
    static const std::vector<std::string> kIsas{"baseline", "avx2", "avx512"};
    rows.push_back({kRun, "-j,--threads", "N",
                    "number of threads; default 0, the cores that this process may use",
                    [](Options& o, const std::string& v) {
                        o.threads = static_cast<int>(wholeIn("--threads", v, 0, kMostThreads));
                    }});
    rows.push_back({kRun, "--isa", "NAME",
                    "instruction set, which changes no image" + listed(kIsas),
                    [](Options& o, const std::string& v) {
                        wordFrom("--isa", v, kIsas);
                        o.isa = v;
                    },
                    kIsas});
    rows.push_back(
        flag(kRun, "--check", "run the script, load everything, render nothing", &Options::check));
    rows.push_back(flag(kRun, "--explain",
                        "say which features the scene uses, and which its render leaves out",
                        &Options::explain));
    rows.push_back(flag(kRun, "--watch", "render again when a file that the scene uses changes",
                        &Options::watch));
    rows.push_back(flag(kRun, "--preview",
                        "show the image in a browser of this machine while it renders",
                        &Options::preview));
    rows.push_back(
        {kRun, "--preview-port", "N", "port of --preview; default 8318; 0 is any that is free",
         [](Options& o, const std::string& v) {
             constexpr int kMostPort = 65535;
             o.previewPort = static_cast<int>(wholeIn("--preview-port", v, 0, kMostPort));
         }});
    rows.push_back(flag(kRun, "--fail-fast", "stop at the first of several scenes that fails",
                        &Options::failFast));
}

void addMessageRows(Rows& rows) {
    static const std::vector<std::string> kWhen{"auto", "always", "never"};
    rows.push_back(flag(kMessages, "--werror", "a warning is an error", &Options::werror));
    rows.push_back(
        flag(kMessages, "-q,--quiet", "no progress, and nothing at the end", &Options::quiet));
    rows.push_back(flag(kMessages, "-v,--verbose", "more about errors and what is going on",
                        &Options::verbose));
    rows.push_back({kMessages, "--color", "WHEN", "colours in messages" + listed(kWhen),
                    [](Options& o, const std::string& v) {
                        o.color = static_cast<ColorMode>(wordFrom("--color", v, kWhen));
                    },
                    kWhen});
    rows.push_back({kMessages, "--print", "WHAT",
                    "print a text about the program" + listed(documentNames()),
                    [](Options& o, const std::string& v) {
                        wordFrom("--print", v, documentNames());
                        o.document = v;
                        if (o.command != Command::kHelp) o.command = Command::kPrint;
                    },
                    documentNames()});
    rows.push_back({kMessages, "-h,--help", "", "show this",
                    [](Options& o, const std::string&) { o.command = Command::kHelp; }});
    rows.push_back(
        {kMessages, "--version", "", "show the version", [](Options& o, const std::string&) {
             if (o.command == Command::kRender) o.command = Command::kVersion;
         }});
}

}  // namespace

const std::vector<CommandRow>& commandRows() {
    static const Rows table = [] {
        Rows rows;
        addOutputRows(rows);
        addSharedRows(rows);
        addScriptRows(rows);
        addRunRows(rows);
        addMessageRows(rows);
        return rows;
    }();
    return table;
}

}  // namespace rt
