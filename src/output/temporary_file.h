// The temporary file behind writeFile: a sibling of the file that it will become.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rt {

/// An open file descriptor, closed when it leaves its scope.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }
    /// Closes; false with errno if the system reports a late write error.
    [[nodiscard]] bool close();

  private:
    int number_;
};

/// Writes all bytes, however often the call is interrupted or cut short; false with errno.
[[nodiscard]] bool writeAll(int descriptor, std::span<const std::uint8_t> bytes);

/// fsync, where the file system knows it; false with errno when data may be lost.
[[nodiscard]] bool sync(int descriptor);

/// "path: cannot be written: No space left on device", from errno.
[[noreturn]] void failToWrite(const std::string& path, int error);

/// The folder of a path ("." if it names none) and the name in it.
struct SplitPath {
    std::string folder;
    std::string name;
};
SplitPath splitPath(const std::string& path);

/// A file NAME.tmp-PID-N beside the target, NAME cut short where the whole would exceed what a
/// folder takes. It is locked while its process lives, so that the temporaries of dead processes
/// can be told apart and removed; it is removed itself unless it has become the target.
class TemporaryFile {
  public:
    /// Creates it, with mode 0666 less the umask, after removing stale ones of the same target.
    /// Throws OutputError.
    explicit TemporaryFile(const std::string& target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int descriptor() const { return descriptor_.number(); }

    /// Renames it to the target; false with errno.
    [[nodiscard]] bool becomeTarget();

  private:
    int create();

    std::string target_;
    std::string path_;
    Descriptor descriptor_;
    bool renamed_ = false;
};

}  // namespace rt
