// What the shells need to complete command lines of the program.
#pragma once

#include <string>

namespace rt {

/// Scripts from the option tables: names of options, the values of those that have a list, files
/// and folders, and scenes.
std::string bashCompletion();
std::string zshCompletion();

}  // namespace rt
