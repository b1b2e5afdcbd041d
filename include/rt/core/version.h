// The program's name and version, as --version, the statistics and image metadata show them.
#pragma once

namespace rt {

inline constexpr const char* kProgramName = "Project";
inline constexpr const char* kProgramVersion = "1.0.0";

}  // namespace rt
