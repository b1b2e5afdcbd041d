// The table behind the command line: one row for each option.
#pragma once

#include "rt/app/options.h"

#include <functional>
#include <string>
#include <vector>

namespace rt {

struct CommandRow {
    const char* section;
    std::string flags;      ///< "-j,--threads"
    std::string valueName;  ///< "" for a flag
    std::string text;
    /// Stores the value, "true" or "false" for a flag; throws UsageError.
    std::function<void(Options&, const std::string&)> apply;
    std::vector<std::string> choices = {};  ///< all values there are, if they can be listed
};

const std::vector<CommandRow>& commandRows();

}  // namespace rt
