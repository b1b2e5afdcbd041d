// Runs a scene script. The only way into Lua: the state lives and dies inside runScript.
#pragma once

#include "rt/core/diagnostics.h"
#include "rt/scene/scene_desc.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rt {

/// What the caller allows and passes to a script.
struct ScriptSettings {
    std::vector<std::string> arguments;             ///< the script's `arg`
    std::map<std::string, std::string> parameters;  ///< -D name=value
    std::vector<std::string> parameterFiles;        ///< the last that names one counts, but for -D
    int frame = 1;                                  ///< gr.frame
    double time = 0.0;                              ///< gr.time
    int largestSide = 0;  ///< of the images, in pixels, where the command line sets it
    bool trust = false;
    bool legacyTransforms = false;
    std::size_t memoryLimit = std::size_t{2} << 30;  ///< bytes
    double timeLimit = 0.0;                          ///< seconds; 0 = none
    bool printToStderr = false;                      ///< `print`, when stdout carries the image
};

/// One gr.param that the script asked for, for --list-params.
struct ScriptParameter {
    std::string name;
    std::string value;
    std::string doc;
    SourceLocation where;
};

struct ScriptResult {
    SceneDesc scene;
    std::vector<ScriptParameter> parameters;
    std::vector<std::string> filesRead;  ///< script, modules, assets; resolved
};

/// The files that a run of a script depends on.
struct ScriptFiles {
    std::vector<std::string> read;    ///< script, modules, assets; resolved
    std::vector<std::string> absent;  ///< looked for first, or in vain: would be read if they were
};

/// Runs `path` ("-" is stdin) from top to bottom and closes Lua. Throws SceneError with the script
/// line, or LimitError. Warnings go to `diagnostics`; `files`, if not null, is filled whatever
/// happens.
ScriptResult runScript(const std::string& path, const ScriptSettings& settings,
                       Diagnostics& diagnostics, ScriptFiles* files = nullptr);

}  // namespace rt
