// Whether files are still what they were.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace rt {

/// Watches files, also ones that do not exist yet. What counts is how a file looks now beside how
/// it looked: its number, size and times. The kernel's notices (inotify) on the folders, which see
/// editors that rename a new file over the old one, only say when to look; where there are none,
/// and on file systems that give none, files are looked at now and then.
/// All members may be called from any thread.
class FileWatch {
  public:
    enum class Notices { kInotify, kNever };
    /// How long files must be quiet before they count as changed.
    static constexpr double kQuietSeconds = 0.1;

    explicit FileWatch(Notices notices = Notices::kInotify, double quietSeconds = kQuietSeconds);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// A round in which files are read begins: what becomes known of `add` from here on has changed
    /// if it did so after this moment.
    void begin();
    /// These files matter to the round. One that was known is held against its older looks.
    void add(const std::vector<std::string>& paths);
    /// A file that does not matter, whoever adds it, before or after.
    void ignore(const std::string& path);
    /// Forgets the files that the round did not add.
    void end();

    /// Waits for up to `seconds`. The files that changed, once they have been quiet for a moment:
    /// many editors empty a file before they write it. From then on their new looks count.
    std::vector<std::string> wait(double seconds);

    std::size_t size() const;

  private:
    /// How a file looks; a missing one is all zeros.
    struct Looks {
        std::uint64_t device = 0;
        std::uint64_t number = 0;
        std::int64_t size = 0;
        std::int64_t modified = 0;  ///< nanoseconds
        std::int64_t changed = 0;   ///< nanoseconds; of its name, owner or mode, too
        bool operator==(const Looks&) const = default;
    };
    struct File {
        Looks looks;
        bool inRound = false;
    };

    static Looks looksOf(const std::string& path);
    void listen(const std::string& path);
    bool sleep(double seconds) const;
    bool anyChanged() const;
    void listenAgain();
    std::map<std::string, Looks> looksNow() const;
    void waitUntilQuiet() const;
    std::vector<std::string> accept();

    mutable std::mutex mutex_;
    double quietSeconds_;
    int inotify_ = -1;
    bool complete_ = true;  ///< every folder has notices
    std::map<std::string, File> files_;
    std::set<std::string> ignored_;
    std::int64_t began_ = 0;
};

}  // namespace rt
