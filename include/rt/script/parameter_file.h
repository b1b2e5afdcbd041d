// Values of gr.param in a file: a line "name = value" for each, as --list-params prints them.
#pragma once

#include "rt/script/scene_script.h"

#include <cstddef>
#include <string>
#include <vector>

namespace rt {

/// What somebody set a parameter to, and where.
struct GivenParameter {
    std::string name;
    std::string value;
    SourceLocation where;  ///< a line of a file; no file for -D

    /// "-D n=3", "n = 3 (file:2)", for messages.
    std::string text() const;
};

/// The lines of a file of at most `most` bytes. Empty lines and those that begin with # are left
/// out. A name or value in double quotes is a string of Lua's escapes \" \\ \n \r \t \xHH; without
/// quotes it is what stands there, less the blanks around. Throws SceneError with file and line for
/// a line of any other form and for a name that is there twice, LimitError for a larger file.
std::vector<GivenParameter> readParameterFile(const std::string& path, std::size_t most);

/// The parameters as lines that readParameterFile reads, with their sentences as comments.
std::string parameterFileText(const std::vector<ScriptParameter>& parameters);

}  // namespace rt
