// Which image depends on which files, in the syntax of make: for --deps.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// The images of one run of a script, and the files that it read.
struct DependencyRule {
    std::vector<std::string> images;
    std::vector<std::string> files;
};

/// One make rule for each entry that has images; then, for each file, an empty one: so make goes on
/// when a file has been removed. Files below `folder`, an absolute path, are named from there.
/// Names are escaped as make and ninja both understand; a line break in one is an OutputError.
std::string dependencyText(const std::vector<DependencyRule>& rules, const std::string& folder);

/// Writes it for the current folder, whole or not at all; returns a warning or "", see writeFile.
std::string writeDependencies(const std::string& path, const std::vector<DependencyRule>& rules);

}  // namespace rt
