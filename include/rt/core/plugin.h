// Where the program keeps what it loads only when it is needed.
#pragma once

#include <optional>
#include <string>

namespace rt {

/// The path of a shared object: beside the program, in ../lib/project, or in build/release; nothing
/// where it is in none of them.
std::optional<std::string> findPlugin(const std::string& name);

}  // namespace rt
