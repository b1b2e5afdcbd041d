// Files that a scene names: only regular files are read, and always through read(2), since a mapped
// file that shrinks under the program would kill it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rt {

/// An asset opened for reading. A folder, a device, a pipe and an unreadable file are SceneErrors
/// that carry the path.
class InputFile {
  public:
    explicit InputFile(std::string path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return path_; }
    /// Bytes, when the file was opened.
    std::uint64_t size() const { return size_; }

    /// Up to `count` bytes into `to`; fewer only at the end of the file. SceneError on an I/O
    /// error.
    std::size_t read(void* to, std::size_t count);
    /// What is left of the file.
    std::vector<std::uint8_t> readAll();

  private:
    std::string path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace rt
