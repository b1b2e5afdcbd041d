// OpenImageIO, behind a plugin that is opened when it is first needed.
#pragma once

#include "rt/image/oiio_abi.h"

#include <string>

namespace rt {

/// The plugin's functions.
struct OiioLibrary {
    RtOiioRead* read = nullptr;
    RtOiioWrite* write = nullptr;
    RtOiioFree* free = nullptr;
    std::string problem;  ///< why it cannot be used, and what to install; empty if it can

    explicit operator bool() const { return problem.empty(); }
};

/// Opens librt_oiio.so beside the executable, in ../lib/project/ or in build/release/ seen from
/// there; the first call decides, later ones give the same answer. From any thread.
const OiioLibrary& oiioLibrary();

/// The same for a library file, without memory of earlier calls.
OiioLibrary openOiioLibrary(const std::string& path);

}  // namespace rt
