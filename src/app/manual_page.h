// The manual page of the program.
#pragma once

#include <string>

namespace rt {

/// In the macros of man(7), from the option tables.
std::string manualPage();

}  // namespace rt
