// The options that a script (`gr.options`) and the command line share, as one table:
// it gives the parser, the checks, --help, the documentation test and the did-you-mean lists.
#pragma once

#include "rt/core/vec.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rt {

/// What was asked for; an empty field was not mentioned.
struct RenderOptions {
    std::optional<int> spp;               ///< samples in every pixel
    std::optional<double> error;          ///< stop at this estimated RMSE of the image
    std::optional<double> time;           ///< stop after so many seconds of rendering
    std::optional<int> maxSpp;            ///< most samples a pixel for `error`
    std::optional<bool> reference;        ///< the slow, plain truth
    std::optional<bool> caustics;         ///< light through glass and off mirrors, by photons
    std::optional<std::string> sampler;   ///< joint, jitter, grid, random
    std::optional<std::string> filter;    ///< box, gaussian, mitchell, blackman-harris
    std::optional<double> seed;           ///< whole number, 0 .. 2^53
    std::optional<int> maxDepth;          ///< a path's last depth; the camera's hit has depth 0
    std::optional<double> cutoff;         ///< largest bound on what a cut path could have brought
    std::optional<double> smoothAngle;    ///< degrees; see gr.mesh
    std::optional<int> bits;              ///< of a PNG's channel: 8, 16
    std::optional<std::string> transfer;  ///< raw, srgb
    std::optional<bool> flipV;            ///< v = 0 at the top of images

    /// `this` where it says something, else `weaker`; any of spp, error, time here
    /// discards all three of `weaker`.
    RenderOptions over(const RenderOptions& weaker) const;
};

using OptionValue = std::variant<bool, double, std::string>;

/// One option. `name` is the command line's spelling; a script writes '_' for '-'.
struct OptionRow {
    enum class Kind { kFlag, kInteger, kNumber, kChoice };

    const char* name;
    Kind kind;
    const char* valueName;  ///< in --help, "" for a flag
    const char* help;
    double min;  ///< inclusive range of a number
    double max;
    bool minExcluded;
    std::vector<std::string> choices;  ///< of a kChoice
    /// Stores a value that passed `check`.
    void (*store)(RenderOptions&, const OptionValue&);
    /// The value now in the options, if any; for tests and for printing.
    std::optional<OptionValue> (*load)(const RenderOptions&);
};

const std::vector<OptionRow>& optionTable();
/// Its name in a script, whose names have no hyphens: "max_spp".
std::string scriptSpelling(const OptionRow& row);

/// "" if the value fits the row, else what would be right: "must be a whole number in 1 ..
/// 1048576".
std::string checkOption(const OptionRow& row, const OptionValue& value);

/// The nearest of `known` to `word` within a third of its length in edits, or "".
std::string nearestName(const std::string& word, const std::vector<std::string>& known);

}  // namespace rt
