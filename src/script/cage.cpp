#include "cage.h"

#include "rt/core/error.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

namespace rt {
namespace {

std::optional<std::string> realPath(const std::string& path) {
    char* resolved = ::realpath(path.c_str(), nullptr);
    if (resolved == nullptr) return std::nullopt;
    std::string result = resolved;
    std::free(resolved);
    return result;
}

bool liesBelow(const std::string& path, const std::string& folder) {
    if (folder == "/") return true;
    return path == folder || path.starts_with(folder + "/");
}

bool isLink(const std::string& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
}

/// Whether a path that does not exist would lie below the folder: its nearest existing ancestor
/// does, and neither ".." nor a dangling link, which leads nobody knows where, follows.
bool wouldLieBelow(std::string path, const std::string& folder) {
    while (true) {
        const std::size_t slash = path.find_last_of('/');
        if (slash == std::string::npos || slash == 0) return false;
        const std::string name = path.substr(slash + 1);
        path.resize(slash);
        if (name == ".." || isLink(path + "/" + name)) return false;
        if (const auto resolved = realPath(path)) return liesBelow(*resolved, folder);
    }
}

/// Files of these systems claim to be regular and are not.
bool isKernelFile(int descriptor) {
    struct statfs system {};
    if (::fstatfs(descriptor, &system) != 0) return true;
    return system.f_type == PROC_SUPER_MAGIC || system.f_type == SYSFS_MAGIC;
}

std::string systemWords() {
    return std::strerror(errno);
}

/// A descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    int release() { return std::exchange(number_, -1); }

  private:
    int number_;
};

}  // namespace

Resolved resolveBelow(const std::string& folder, const std::string& relative) {
    const auto root = realPath(folder);
    const bool nameable = relative.find('\0') == std::string::npos;
    if (!root || !nameable || relative.starts_with('/')) return {Resolved::Kind::kOutside, ""};
    if (relative.empty()) return {Resolved::Kind::kMissing, ""};
    const std::string whole = *root + "/" + relative;
    if (const auto resolved = realPath(whole)) {
        if (liesBelow(*resolved, *root)) return {Resolved::Kind::kFound, *resolved};
        return {Resolved::Kind::kOutside, ""};
    }
    const bool inside = wouldLieBelow(whole, *root);
    return {inside ? Resolved::Kind::kMissing : Resolved::Kind::kOutside, ""};
}

Cage::Cage(const std::string& folder, bool trust)
    : folder_(realPath(folder).value_or(folder)), trust_(trust) {}

Resolved Cage::find(const std::string& path) const {
    if (trust_) {
        const bool absolute = path.starts_with('/');
        auto resolved = realPath(path);
        if (!resolved && !absolute) resolved = realPath(folder_ + "/" + path);
        if (!resolved) return {Resolved::Kind::kMissing, ""};
        return {Resolved::Kind::kFound, *resolved};
    }
    const Resolved inFolder = resolveBelow(folder_, path);
    if (inFolder.kind == Resolved::Kind::kFound || path.starts_with('/')) return inFolder;
    if (path.find('\0') != std::string::npos) return inFolder;
    const auto fromHere = realPath(path);
    if (fromHere && liesBelow(*fromHere, folder_)) return {Resolved::Kind::kFound, *fromHere};
    return inFolder;
}

int openRegularFile(const std::string& path, const std::string& name) {
    // Without O_NONBLOCK, opening a pipe would wait for its writer.
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file.number() < 0) throw SceneError("cannot be opened: " + systemWords(), {name, 0});
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) {
        throw SceneError("cannot be read: " + systemWords(), {name, 0});
    }
    if (S_ISDIR(status.st_mode)) throw SceneError("is a folder, not a file", {name, 0});
    if (!S_ISREG(status.st_mode) || isKernelFile(file.number())) {
        throw SceneError("is a device or a pipe; only regular files are read", {name, 0});
    }
    return file.release();
}

std::string readAll(int descriptor, const std::string& name, std::size_t most) {
    std::string text;
    std::array<char, 1 << 16> block{};
    while (true) {
        const ::ssize_t got = ::read(descriptor, block.data(), block.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw SceneError("cannot be read: " + systemWords(), {name, 0});
        if (got == 0) return text;
        text.append(block.data(), static_cast<std::size_t>(got));
        if (text.size() > most) {
            throw SceneError("is too large: more than " + std::to_string(most) + " bytes",
                             {name, 0});
        }
    }
}

std::string readRegularFile(const std::string& path, const std::string& name, std::size_t most) {
    const Descriptor file(openRegularFile(path, name));
    return readAll(file.number(), name, most);
}

}  // namespace rt
