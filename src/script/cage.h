// Which files may be read: those that lie below a folder after links are resolved.
#pragma once

#include <cstddef>
#include <string>

namespace rt {

/// Where a path leads. `path` is resolved, absolute, and given for kFound only.
struct Resolved {
    enum class Kind { kFound, kMissing, kOutside };
    Kind kind = Kind::kMissing;
    std::string path;
};

/// Follows `relative` from `folder` through every link. Absolute paths and all that leaves the
/// folder are kOutside, whether it exists or not: nothing about the outside can be learnt.
Resolved resolveBelow(const std::string& folder, const std::string& relative);

/// The folder that a script's reads are held in.
class Cage {
  public:
    Cage() = default;
    /// With `trust` every path is allowed and relative ones start at the current folder, too.
    Cage(const std::string& folder, bool trust);

    const std::string& folder() const { return folder_; }
    bool trust() const { return trust_; }

    /// Looks below the scene's folder; then from the current folder, for paths as given on the
    /// command line, which must lead into the scene's folder all the same.
    Resolved find(const std::string& path) const;

  private:
    std::string folder_;
    bool trust_ = false;
};

/// Opens a regular file (no device, pipe, folder, nor anything of /proc or /sys) for reading and
/// gives its descriptor; throws SceneError, in which the file is called `name`.
int openRegularFile(const std::string& path, const std::string& name);

/// What is left to read from a descriptor; SceneError also for more than `most` bytes.
std::string readAll(int descriptor, const std::string& name, std::size_t most);

/// The whole of a regular file.
std::string readRegularFile(const std::string& path, const std::string& name, std::size_t most);

}  // namespace rt
