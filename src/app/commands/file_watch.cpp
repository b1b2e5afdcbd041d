#include "file_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

namespace rt {
namespace {

/// A file that never rests is read all the same, after so many times the quiet moment.
constexpr double kMostQuietMoments = 20.0;
/// How often files are looked at where the kernel gives notices, for those that it misses, and
/// where it gives none.
constexpr double kRareSeconds = 1.0;
constexpr double kOftenSeconds = 0.2;

constexpr std::uint32_t kEvents = IN_CREATE | IN_DELETE | IN_MODIFY | IN_CLOSE_WRITE |
                                  IN_MOVED_FROM | IN_MOVED_TO | IN_ATTRIB | IN_DELETE_SELF |
                                  IN_MOVE_SELF | IN_ONLYDIR;

using Clock = std::chrono::steady_clock;

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// The clock that stamps files.
std::int64_t fileClock() {
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
    return nanoseconds(now);
}

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

FileWatch::FileWatch(Notices notices, double quietSeconds) : quietSeconds_(quietSeconds) {
    if (notices == Notices::kInotify) inotify_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
}

FileWatch::~FileWatch() {
    if (inotify_ >= 0) ::close(inotify_);
}

FileWatch::Looks FileWatch::looksOf(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {status.st_dev, status.st_ino, status.st_size, nanoseconds(status.st_mtim),
            nanoseconds(status.st_ctim)};
}

/// Of the nearest folder that exists: those below it may come.
void FileWatch::listen(const std::string& path) {
    if (inotify_ < 0) return;
    std::string folder = folderOf(path);
    while (::inotify_add_watch(inotify_, folder.c_str(), kEvents) < 0) {
        if ((errno != ENOENT && errno != ENOTDIR) || folder == "/" || folder == ".") {
            complete_ = false;
            return;
        }
        folder = folderOf(folder);
    }
}

void FileWatch::begin() {
    const std::lock_guard lock(mutex_);
    began_ = fileClock();
    for (auto& [path, file] : files_) file.inRound = false;
}

void FileWatch::add(const std::vector<std::string>& paths) {
    const std::lock_guard lock(mutex_);
    for (const std::string& path : paths) {
        if (ignored_.count(path) > 0) continue;
        listen(path);
        const auto [entry, isNew] = files_.try_emplace(path);
        entry->second.inRound = true;
        if (!isNew) continue;
        const Looks looks = looksOf(path);
        // Looks that no file has: what was written since the round began is to be read again.
        if (looks.changed < began_) {
            entry->second.looks = looks;
        } else {
            entry->second.looks.size = -1;
        }
    }
}

void FileWatch::ignore(const std::string& path) {
    const std::lock_guard lock(mutex_);
    ignored_.insert(path);
    files_.erase(path);
}

void FileWatch::end() {
    const std::lock_guard lock(mutex_);
    std::erase_if(files_, [](const auto& entry) { return !entry.second.inRound; });
}

std::size_t FileWatch::size() const {
    const std::lock_guard lock(mutex_);
    return files_.size();
}

bool FileWatch::anyChanged() const {
    const std::lock_guard lock(mutex_);
    return std::any_of(files_.begin(), files_.end(), [](const auto& entry) {
        return looksOf(entry.first) != entry.second.looks;
    });
}

/// True if there was a notice.
bool FileWatch::sleep(double seconds) const {
    pollfd waiting{inotify_, POLLIN, 0};  // of a negative descriptor nothing is told
    const int count = ::poll(&waiting, 1, static_cast<int>(std::ceil(seconds * 1000.0)));
    if (count <= 0) return false;
    alignas(inotify_event) std::array<char, 1 << 14> notices{};
    while (::read(inotify_, notices.data(), notices.size()) > 0) {
    }
    return true;
}

/// A folder may have come, or another one in its place.
void FileWatch::listenAgain() {
    const std::lock_guard lock(mutex_);
    for (const auto& [path, file] : files_) listen(path);
}

std::map<std::string, FileWatch::Looks> FileWatch::looksNow() const {
    const std::lock_guard lock(mutex_);
    std::map<std::string, Looks> all;
    for (const auto& [path, file] : files_) all[path] = looksOf(path);
    return all;
}

void FileWatch::waitUntilQuiet() const {
    const Clock::time_point start = Clock::now();
    std::map<std::string, Looks> before;
    std::map<std::string, Looks> now = looksNow();
    do {
        before = std::move(now);
        std::this_thread::sleep_for(std::chrono::duration<double>(quietSeconds_));
        now = looksNow();
    } while (before != now && secondsSince(start) < kMostQuietMoments * quietSeconds_);
}

/// The changed files, whose new looks count from here on.
std::vector<std::string> FileWatch::accept() {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> changed;
    for (auto& [path, file] : files_) {
        const Looks looks = looksOf(path);
        if (looks == file.looks) continue;
        file.looks = looks;
        changed.push_back(path);
    }
    return changed;
}

std::vector<std::string> FileWatch::wait(double seconds) {
    const Clock::time_point start = Clock::now();
    while (!anyChanged()) {
        const double left = seconds - secondsSince(start);
        if (left <= 0.0) return {};
        const bool hasNotices = inotify_ >= 0 && complete_;
        if (sleep(std::min(left, hasNotices ? kRareSeconds : kOftenSeconds))) listenAgain();
    }
    waitUntilQuiet();
    return accept();
}

}  // namespace rt
