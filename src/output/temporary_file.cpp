#include "temporary_file.h"

#include "rt/core/error.h"
#include "rt/output/atomic_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <memory>
#include <utility>

namespace rt {
namespace {

constexpr const char* kMark = ".tmp-";

// Room for the mark, a process number and a counter of up to 10 digits each.
constexpr std::size_t kSuffixRoom = 26;

/// Name of the temporary file that is there, or null; files are written one after another.
std::atomic<const char*> present{nullptr};

/// Of a name, the part that its temporaries begin with: whole characters of UTF-8 only.
std::string stemOf(const std::string& name) {
    std::size_t length = std::min(name.size(), NAME_MAX - kSuffixRoom);
    const auto continues = [&](std::size_t at) {
        return at < name.size() && (static_cast<unsigned char>(name[at]) & 0xc0) == 0x80;
    };
    while (length > 0 && length < name.size() && continues(length)) --length;
    return name.substr(0, length) + kMark;
}

bool isDigits(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// True for STEM + PID-N.
bool isTemporaryOf(const std::string& name, const std::string& stem) {
    if (name.compare(0, stem.size(), stem) != 0) return false;
    const std::size_t dash = name.find('-', stem.size());
    return dash != std::string::npos && isDigits(name.substr(stem.size(), dash - stem.size())) &&
           isDigits(name.substr(dash + 1));
}

/// Removes a temporary whose process has ended, which is when nobody holds its lock.
void removeIfStale(const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!file || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) return;
    if (::flock(file.number(), LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
}

void removeStale(const std::string& folder, const std::string& stem) {
    const std::unique_ptr<DIR, int (*)(DIR*)> stream(::opendir(folder.c_str()), ::closedir);
    if (!stream) return;
    while (const dirent* entry = ::readdir(stream.get())) {
        if (isTemporaryOf(entry->d_name, stem)) removeIfStale(folder + "/" + entry->d_name);
    }
}

}  // namespace

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

bool Descriptor::close() {
    return ::close(std::exchange(number_, -1)) == 0;
}

bool writeAll(int descriptor, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool sync(int descriptor) {
    while (::fsync(descriptor) != 0) {
        if (errno == EINTR) continue;
        return errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP;
    }
    return true;
}

void failToWrite(const std::string& path, int error) {
    throw OutputError(path + ": cannot be written: " + std::strerror(error));
}

SplitPath splitPath(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return {".", path};
    return {slash == 0 ? "/" : path.substr(0, slash), path.substr(slash + 1)};
}

TemporaryFile::TemporaryFile(const std::string& target) : target_(target), descriptor_(create()) {}

TemporaryFile::~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
    present.store(nullptr);
}

void abandonWrite() noexcept {
    if (const char* const path = present.load()) ::unlink(path);
}

int TemporaryFile::create() {
    static std::atomic<unsigned> counter{0};
    const auto [folder, name] = splitPath(target_);
    const std::string stem = stemOf(name);
    removeStale(folder, stem);
    for (;;) {
        path_ = folder + "/" + stem + std::to_string(::getpid()) + "-" + std::to_string(counter++);
        const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file < 0 && (errno == EEXIST || errno == EINTR)) continue;
        if (file < 0) failToWrite(target_, errno);
        // Another process may have taken the file for stale before it was locked: then it has
        // no name left.
        struct stat status {};
        if (::flock(file, LOCK_EX) != 0 || ::fstat(file, &status) != 0 || status.st_nlink > 0) {
            present.store(path_.c_str());
            return file;
        }
        ::close(file);
    }
}

bool TemporaryFile::becomeTarget() {
    renamed_ = ::rename(path_.c_str(), target_.c_str()) == 0;
    return renamed_;
}

}  // namespace rt
