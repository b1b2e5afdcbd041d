#include "rt/core/input_file.h"

#include "rt/core/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace rt {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) {
    throw SceneError(why, {path, 0});
}

std::string systemWords(int error) {
    return std::strerror(error);
}

}  // namespace

InputFile::InputFile(std::string path) : path_(std::move(path)) {
    // Without O_NONBLOCK, opening a pipe would wait for its writer.
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0) fail(path_, "cannot be opened: " + systemWords(errno));
    struct stat status {};
    std::string refusal;
    if (::fstat(descriptor_, &status) != 0) {
        refusal = "cannot be read: " + systemWords(errno);
    } else if (S_ISDIR(status.st_mode)) {
        refusal = "is a folder, not a file";
    } else if (!S_ISREG(status.st_mode)) {
        refusal = "is a device or a pipe; only regular files are read";
    }
    if (!refusal.empty()) {
        ::close(descriptor_);
        fail(path_, refusal);
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() {
    ::close(descriptor_);
}

std::size_t InputFile::read(void* to, std::size_t count) {
    char* next = static_cast<char*>(to);
    std::size_t left = count;
    while (left > 0) {
        const ::ssize_t got = ::read(descriptor_, next, left);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(path_, "cannot be read: " + systemWords(errno));
        if (got == 0) break;
        next += got;
        left -= static_cast<std::size_t>(got);
    }
    return count - left;
}

std::vector<std::uint8_t> InputFile::readAll() {
    std::vector<std::uint8_t> bytes(size_);
    bytes.resize(read(bytes.data(), bytes.size()));
    return bytes;
}

}  // namespace rt
