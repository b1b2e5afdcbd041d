#include "rt/output/atomic_file.h"

#include "rt/core/error.h"
#include "temporary_file.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <optional>

namespace rt {
namespace {

constexpr const char* kStdout = "-";

// As many links as the kernel follows itself.
constexpr int kMostLinks = 40;

/// Where the bytes of a path really go.
struct Destination {
    enum class Kind { kReplace, kStream, kDescriptor };
    Kind kind = Kind::kReplace;
    std::string path;                 ///< links resolved
    int descriptor = -1;              ///< of a kDescriptor
    std::optional<struct stat> file;  ///< the regular file that is there
};

/// The N of /proc/self/fd/N and its other names.
std::optional<int> openDescriptor(const std::string& path) {
    if (path == kStdout || path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string folder : {"/proc/self/fd/", "/dev/fd/"}) {
        if (path.compare(0, folder.size(), folder) != 0) continue;
        const std::string number = path.substr(folder.size());
        const bool digits = number.find_first_not_of("0123456789") == std::string::npos;
        if (digits && !number.empty() && number.size() < 8) return std::stoi(number);
    }
    return std::nullopt;
}

/// One step along a symbolic link; nothing if `path` is none.
std::optional<std::string> linkTarget(const std::string& path) {
    std::array<char, PATH_MAX> text{};
    const ssize_t length = ::readlink(path.c_str(), text.data(), text.size());
    if (length <= 0) return std::nullopt;
    const std::string target(text.data(), static_cast<std::size_t>(length));
    if (target.front() == '/') return target;
    return splitPath(path).folder + "/" + target;
}

Destination findDestination(const std::string& path) {
    if (path.empty()) throw OutputError("the name of the output file is empty");
    if (path.find('\0') != std::string::npos) {
        throw OutputError("the name of the output file holds a zero byte");
    }
    Destination destination;
    destination.path = path;
    for (int links = 0; links < kMostLinks; ++links) {
        if (const auto number = openDescriptor(destination.path)) {
            return {Destination::Kind::kDescriptor, path, *number, std::nullopt};
        }
        const auto target = linkTarget(destination.path);
        if (!target) break;
        destination.path = *target;
    }
    struct stat status {};
    if (::stat(destination.path.c_str(), &status) != 0) {
        if (errno != ENOENT) failToWrite(path, errno);
        if (destination.path.back() == '/') failToWrite(path, EISDIR);
        return destination;
    }
    if (S_ISDIR(status.st_mode)) failToWrite(path, EISDIR);
    if (S_ISREG(status.st_mode)) {
        destination.file = status;
    } else {
        destination.kind = Destination::Kind::kStream;
    }
    return destination;
}

void makeFolder(const std::string& folder, const std::string& path) {
    if (folder.empty() || ::access(folder.c_str(), F_OK) == 0) return;
    if (errno != ENOENT) failToWrite(path, errno);
    makeFolder(splitPath(folder).folder, path);
    if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST) failToWrite(path, errno);
}

void refuseTerminal(int descriptor, const std::string& path) {
    if (::isatty(descriptor) == 0) return;
    throw UsageError("-o " + path +
                     ": an image is not written to a terminal; redirect it into a file or a pipe");
}

/// Devices and pipes cannot be synced, and must neither be truncated nor replaced.
void writeStream(const Destination& to, std::span<const std::uint8_t> bytes) {
    const bool opened = to.kind == Destination::Kind::kStream;
    Descriptor file(opened ? ::open(to.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC)
                           : ::fcntl(to.descriptor, F_DUPFD_CLOEXEC, 0));
    if (!file) failToWrite(to.path, errno);
    refuseTerminal(file.number(), to.path);
    if (!writeAll(file.number(), bytes) || !file.close()) failToWrite(to.path, errno);
}

/// For a file that cannot be renamed over, such as one that is a mount point of its own.
std::string overwrite(const std::string& path, std::span<const std::uint8_t> bytes, int why) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file || !writeAll(file.number(), bytes) ||
        ::ftruncate(file.number(), static_cast<off_t>(bytes.size())) != 0 || !sync(file.number()) ||
        !file.close()) {
        failToWrite(path, errno);
    }
    return path + ": was overwritten in place, for it cannot be replaced: " + std::strerror(why);
}

/// Owner first, for a change of owner clears bits of the mode. Only root can keep a foreign owner.
void keepOwnerAndMode(int descriptor, const struct stat& old) {
    if (::fchown(descriptor, old.st_uid, old.st_gid) == 0 || errno == EPERM) {
        // A file system without modes has none to keep.
        static_cast<void>(::fchmod(descriptor, old.st_mode & 07777));
    }
}

/// True for the errors of rename(2) that say "not this way" rather than "not here".
bool cannotRename(int error) {
    return error == EBUSY || error == EXDEV || error == ENOSYS || error == EOPNOTSUPP;
}

/// A write-protected or immutable file could be replaced all the same; its owner's wish counts.
void respectProtection(const Destination& to) {
    if (::access(to.path.c_str(), W_OK) != 0) failToWrite(to.path, errno);
    const Descriptor file(::open(to.path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    int flags = 0;
    if (file && ::ioctl(file.number(), FS_IOC_GETFLAGS, &flags) == 0 &&
        (flags & (FS_IMMUTABLE_FL | FS_APPEND_FL)) != 0) {
        failToWrite(to.path, EPERM);
    }
}

/// Makes the entry in the folder lasting. The file is there already: no reason to fail.
void syncFolder(const std::string& folder) {
    const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (file) static_cast<void>(sync(file.number()));
}

}  // namespace

std::string writeFile(const std::string& path, std::span<const std::uint8_t> bytes) {
    // Past RLIMIT_FSIZE a write then fails with EFBIG instead of ending the process.
    static const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    static_cast<void>(ignored);
    const Destination to = findDestination(path);
    if (to.kind != Destination::Kind::kReplace) {
        writeStream(to, bytes);
        return "";
    }
    const std::string folder = splitPath(to.path).folder;
    makeFolder(folder, path);
    if (to.file) respectProtection(to);
    TemporaryFile temporary(to.path);
    if (to.file) keepOwnerAndMode(temporary.descriptor(), *to.file);
    if (!writeAll(temporary.descriptor(), bytes) || !sync(temporary.descriptor())) {
        failToWrite(path, errno);
    }
    if (!temporary.becomeTarget()) {
        if (!to.file || !cannotRename(errno)) failToWrite(path, errno);
        return overwrite(to.path, bytes, errno);
    }
    syncFolder(folder);
    return "";
}

void checkWritable(const std::string& path) {
    const Destination to = findDestination(path);
    if (to.kind == Destination::Kind::kDescriptor) {
        refuseTerminal(to.descriptor, path);
        const int mode = ::fcntl(to.descriptor, F_GETFL);
        if (mode < 0) failToWrite(path, errno);
        if ((mode & O_ACCMODE) == O_RDONLY) failToWrite(path, EBADF);
        return;
    }
    if (to.kind == Destination::Kind::kStream) {
        // Opening a FIFO would wait for its reader, and end what that reader sees.
        if (::access(to.path.c_str(), W_OK) != 0) failToWrite(path, errno);
        return;
    }
    const auto [folder, name] = splitPath(to.path);
    if (name.size() > NAME_MAX) failToWrite(path, ENAMETOOLONG);
    makeFolder(folder, path);
    if (to.file) respectProtection(to);
    const TemporaryFile probe(to.path);
}

bool isStream(const std::string& path) {
    if (openDescriptor(path)) return true;
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
           !S_ISDIR(status.st_mode);
}

void refuseOverwriting(const std::string& output, const std::vector<std::string>& inputs) {
    struct stat written {};
    if (openDescriptor(output) || ::stat(output.c_str(), &written) != 0) return;
    if (!S_ISREG(written.st_mode)) return;
    for (const std::string& input : inputs) {
        struct stat read {};
        if (::stat(input.c_str(), &read) != 0) continue;
        if (read.st_dev == written.st_dev && read.st_ino == written.st_ino) {
            throw UsageError(output + ": the output would overwrite " + input +
                             ", which this run reads; choose another -o");
        }
    }
}

}  // namespace rt
