#include "rt/output/atomic_file.h"

#include "output/temporary_file.h"
#include "rt/core/error.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

using namespace rt;
namespace fs = std::filesystem;

namespace {

/// A folder of its own for each test, removed with everything in it.
class Folder {
  public:
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "atomic-XXXXXX").string();
        REQUIRE(::mkdtemp(pattern.data()) != nullptr);
        path_ = pattern;
    }
    ~Folder() { fs::remove_all(path_); }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
    }

  private:
    fs::path path_;
};

std::vector<std::uint8_t> bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void create(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
}

mode_t modeOf(const std::string& path) {
    struct stat status {};
    REQUIRE(::stat(path.c_str(), &status) == 0);
    return status.st_mode & 07777;
}

/// A memory device that the test may lose: root gets one of its own, for a fault of the code under
/// test would replace that of the machine; others can do it no harm.
std::optional<std::string> device(const Folder& folder, const std::string& name, unsigned minor) {
    if (::getuid() != 0) return "/dev/" + name;
    const std::string path = folder / name;
    if (::mknod(path.c_str(), S_IFCHR | 0666, makedev(1, minor)) != 0) return std::nullopt;
    const int file = ::open(path.c_str(), O_WRONLY);
    if (file < 0) return std::nullopt;
    ::close(file);
    return path;
}

/// What `act` leaves with: 0, or the exit code of the Error that it threw.
int outcome(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return static_cast<int>(error.code());
    }
    return 0;
}

/// Runs `act` in a child process; its exit code, or 128 + the signal that ended it.
int inChild(const std::function<int()>& act) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) ::_exit(act());
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE(
    "A write that is abandoned leaves nothing, and abandoning when none goes on does nothing") {
    const Folder folder;
    {
        const TemporaryFile file(folder / "x.png");
        CHECK(folder.entries() == 1);
        abandonWrite();
        CHECK(folder.entries() == 0);
    }
    abandonWrite();
}

TEST_CASE("A file is written, and replaced, with the bytes given and nothing beside it") {
    const Folder folder;
    const std::string path = folder / "a.png";
    CHECK(writeFile(path, bytesOf("first")).empty());
    CHECK(contents(path) == "first");
    CHECK(writeFile(path, bytesOf("2")).empty());
    CHECK(contents(path) == "2");
    CHECK(writeFile(path, {}).empty());
    CHECK(contents(path).empty());
    CHECK(folder.entries() == 1);
}

TEST_CASE("A missing folder is made before rendering, and by the write itself") {
    const Folder folder;
    checkWritable(folder / "x/y/z.png");
    CHECK(fs::is_directory(folder / "x/y"));
    CHECK_FALSE(fs::exists(folder / "x/y/z.png"));
    CHECK(fs::is_empty(folder / "x/y"));
    writeFile(folder / "p//q/r.png", bytesOf("r"));
    CHECK(contents(folder / "p/q/r.png") == "r");
}

TEST_CASE("The check before rendering leaves an older file as it is") {
    const Folder folder;
    create(folder / "a.png", "old");
    checkWritable(folder / "a.png");
    CHECK(contents(folder / "a.png") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("Names that cannot be written are refused before rendering and by the write") {
    const Folder folder;
    fs::create_directory(folder / "folder");
    create(folder / "file", "kept");
    fs::create_symlink("loop", folder / "loop");
    struct Case {
        std::string path;
        std::string reason;
    };
    const std::vector<Case> cases = {
        {"", "empty"},
        {std::string("a\0b.png", 7), "zero byte"},
        {folder / "folder", "Is a directory"},
        {(folder / "folder") + "/", "Is a directory"},
        {(folder / "missing") + "/", "Is a directory"},
        {folder / "file/a.png", "Not a directory"},
        {folder / std::string(300, 'n'), "File name too long"},
        {folder / "loop", "Too many levels of symbolic links"},
        {"/proc/a.png", "No such file"},
        {"/proc/new/a.png", "No such file"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.path);
        CHECK(outcome([&] { checkWritable(c.path); }) == 3);
        CHECK(outcome([&] { writeFile(c.path, bytesOf("x")); }) == 3);
        try {
            checkWritable(c.path);
        } catch (const OutputError& error) {
            CHECK(std::string(error.what()).find(c.reason) != std::string::npos);
        }
    }
    CHECK(contents(folder / "file") == "kept");
}

TEST_CASE("A write-protected file or folder is refused to those whom it is protected from") {
    const Folder folder;
    create(folder / "a.png", "old");
    fs::create_directory(folder / "shut");
    ::chmod((folder / "a.png").c_str(), 0444);
    ::chmod((folder / "shut").c_str(), 0555);
    ::chmod((folder / "").c_str(), 0777);
    constexpr uid_t kNobody = 65534;
    const int code = inChild([&] {
        if (::getuid() == 0 && ::setuid(kNobody) != 0) return 99;
        const std::vector<std::string> paths = {folder / "a.png", folder / "shut/b.png",
                                                folder / "shut/new/b.png"};
        int refused = 0;
        for (const std::string& path : paths) {
            refused += outcome([&] { checkWritable(path); }) == 3;
            refused += outcome([&] { writeFile(path, bytesOf("x")); }) == 3;
        }
        return refused;
    });
    CHECK(code == 6);
    CHECK(contents(folder / "a.png") == "old");
    ::chmod((folder / "shut").c_str(), 0755);
}

TEST_CASE("The old file's mode is kept, and a new one gets 0666 less the umask") {
    const Folder folder;
    create(folder / "old.png", "old");
    for (const mode_t mode : {0600u, 0640u, 0755u}) {
        ::chmod((folder / "old.png").c_str(), mode);
        writeFile(folder / "old.png", bytesOf("x"));
        CHECK(modeOf(folder / "old.png") == mode);
    }
    const mode_t before = ::umask(027);
    writeFile(folder / "new.png", bytesOf("x"));
    ::umask(before);
    CHECK(modeOf(folder / "new.png") == 0640);
}

TEST_CASE("Of a symbolic link the target is replaced, and the link stays") {
    const Folder folder;
    fs::create_directory(folder / "deep");
    create(folder / "deep/real.png", "old");
    fs::create_symlink("deep/real.png", folder / "one.png");
    fs::create_symlink(folder / "one.png", folder / "two.png");
    fs::create_symlink("deep/later.png", folder / "dangling.png");
    writeFile(folder / "two.png", bytesOf("fresh"));
    writeFile(folder / "dangling.png", bytesOf("made"));
    CHECK(fs::is_symlink(folder / "one.png"));
    CHECK(fs::is_symlink(folder / "two.png"));
    CHECK(fs::is_symlink(folder / "dangling.png"));
    CHECK(contents(folder / "deep/real.png") == "fresh");
    CHECK(contents(folder / "deep/later.png") == "made");
}

TEST_CASE("A hard link keeps the older image under its other name") {
    const Folder folder;
    create(folder / "a.png", "old");
    fs::create_hard_link(folder / "a.png", folder / "b.png");
    writeFile(folder / "a.png", bytesOf("fresh"));
    CHECK(contents(folder / "a.png") == "fresh");
    CHECK(contents(folder / "b.png") == "old");
}

TEST_CASE("Devices are written directly and stay devices") {
    const Folder folder;
    const auto null = device(folder, "null", 3);
    const auto full = device(folder, "full", 7);
    if (!null || !full) {
        MESSAGE("not allowed to make a device");
        return;
    }
    checkWritable(*null);
    CHECK(writeFile(*null, bytesOf("gone")).empty());
    CHECK(outcome([&] { writeFile(*full, bytesOf("x")); }) == 3);
    CHECK(fs::is_character_file(*null));
    CHECK(fs::is_character_file(*full));
    CHECK(isStream(*null));
    CHECK(isStream("-"));
    CHECK_FALSE(isStream("/dev"));
    CHECK_FALSE(isStream(folder / "missing"));
}

TEST_CASE("A FIFO gets the bytes, stays a FIFO, and is not opened by the check") {
    const Folder folder;
    const std::string path = folder / "pipe";
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    checkWritable(path);
    const std::string sent(300000, 'x');
    std::string received;
    std::thread reader([&] { received = contents(path); });
    writeFile(path, bytesOf(sent));
    reader.join();
    CHECK(received == sent);
    CHECK(fs::is_fifo(path));
}

TEST_CASE("Stdout takes the bytes under each of its names, also where it is a file") {
    const Folder folder;
    for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        CAPTURE(name);
        const std::string path = folder / "out";
        const int code = inChild([&] {
            const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
            ::dup2(file, 1);
            static_cast<void>(!::write(1, "before ", 7));
            return outcome([&] {
                checkWritable(name);
                writeFile(name, bytesOf("image"));
            });
        });
        CHECK(code == 0);
        CHECK(contents(path) == "before image");
    }
}

TEST_CASE("A closed stdout, one only for reading, and a terminal are refused") {
    CHECK(inChild([] {
              ::close(1);
              return outcome([] { checkWritable("-"); }) * 10 +
                     outcome([] { writeFile("-", bytesOf("x")); });
          }) == 33);
    CHECK(inChild([] {
              ::dup2(::open("/dev/null", O_RDONLY), 1);
              return outcome([] { checkWritable("-"); });
          }) == 3);
    const int probe = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (probe < 0) {
        MESSAGE("no pseudo-terminals on this machine");
        return;
    }
    ::close(probe);
    CHECK(inChild([] {
              const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
              ::grantpt(master);
              ::unlockpt(master);
              const std::string terminal = ::ptsname(master);
              ::dup2(::open(terminal.c_str(), O_RDWR | O_NOCTTY), 1);
              return outcome([] { checkWritable("-"); }) * 10 +
                     outcome([&] { writeFile(terminal, bytesOf("x")); });
          }) == 22);
}

TEST_CASE("A reader that has gone is an output error, not an endless loop") {
    CHECK(inChild([] {
              int ends[2];
              if (::pipe(ends) != 0) return 99;
              ::close(ends[0]);
              ::dup2(ends[1], 1);
              std::signal(SIGPIPE, SIG_IGN);
              return outcome([] { writeFile("-", bytesOf("x")); });
          }) == 3);
}

TEST_CASE("A file size limit is an error, not a signal, and leaves the older image whole") {
    const Folder folder;
    const std::string path = folder / "a.png";
    create(path, "old");
    const int code = inChild([&] {
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        return outcome([&] { writeFile(path, std::vector<std::uint8_t>(100000)); });
    });
    CHECK(code == 3);
    CHECK(contents(path) == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("A full disk leaves the older image whole and no stump" *
          doctest::skip(::getuid() != 0)) {
    const Folder folder;
    const std::string disk = folder / "disk";
    fs::create_directory(disk);
    if (::mount("none", disk.c_str(), "tmpfs", 0, "size=16k") != 0) {
        MESSAGE("not allowed to mount a small tmpfs");
        return;
    }
    create(disk + "/a.png", "old");
    CHECK(outcome([&] { writeFile(disk + "/a.png", std::vector<std::uint8_t>(1 << 20)); }) == 3);
    CHECK(outcome([&] { writeFile(disk + "/b.png", std::vector<std::uint8_t>(1 << 20)); }) == 3);
    CHECK(contents(disk + "/a.png") == "old");
    CHECK(std::distance(fs::directory_iterator(disk), fs::directory_iterator()) == 1);
    REQUIRE(::mount("none", disk.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0);
    CHECK(outcome([&] { checkWritable(disk + "/a.png"); }) == 3);
    CHECK(outcome([&] { checkWritable(disk + "/new/c.png"); }) == 3);
    ::umount(disk.c_str());
}

TEST_CASE("A file that is a mount point of its own is overwritten in place, with a warning" *
          doctest::skip(::getuid() != 0)) {
    const Folder folder;
    create(folder / "real.png", "a longer old image");
    create(folder / "seen.png", "");
    if (::mount((folder / "real.png").c_str(), (folder / "seen.png").c_str(), nullptr, MS_BIND,
                nullptr) != 0) {
        MESSAGE("not allowed to bind a file");
        return;
    }
    const std::string warning = writeFile(folder / "seen.png", bytesOf("fresh"));
    ::umount((folder / "seen.png").c_str());
    CHECK(warning.find("in place") != std::string::npos);
    CHECK(contents(folder / "real.png") == "fresh");
    CHECK(folder.entries() == 2);
}

TEST_CASE("Names of 255 bytes work, and cut only between characters of UTF-8") {
    const Folder folder;
    std::string umlauts;
    for (int i = 0; i < 125; ++i) umlauts += "\xc3\xa4";
    for (const std::string& name :
         {std::string(251, 'n') + ".png", "x" + umlauts + ".png", umlauts + "_.png"}) {
        CAPTURE(name);
        REQUIRE(name.size() >= 254);
        checkWritable(folder / name);
        writeFile(folder / name, bytesOf("x"));
        CHECK(contents(folder / name) == "x");
    }
    CHECK(folder.entries() == 3);
    CHECK(outcome([&] { checkWritable(folder / (std::string(252, 'n') + ".png")); }) == 3);
}

TEST_CASE("A stale temporary of the same output is removed, and nobody else's file") {
    const Folder folder;
    create(folder / "a.png.tmp-123-4", "stump");
    const std::vector<std::string> others = {"b.png.tmp-123-4", "a.png.tmp-123", "a.png.tmp-x-4",
                                             "a.png.tmp-123-4.txt", "xa.png.tmp-123-4"};
    for (const std::string& other : others) create(folder / other, "kept");
    checkWritable(folder / "a.png");
    CHECK_FALSE(fs::exists(folder / "a.png.tmp-123-4"));
    for (const std::string& other : others) CHECK(contents(folder / other) == "kept");
}

TEST_CASE("After kill -9 at any moment the file is the old or the new one, never half") {
    const Folder folder;
    const std::string path = folder / "a.png";
    const std::vector<std::uint8_t> one(3 << 20, 'a');
    const std::vector<std::uint8_t> two(2 << 20, 'b');
    writeFile(path, one);
    std::size_t stumps = 0;
    for (int round = 0; round < 40; ++round) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            for (;;) {
                writeFile(path, two);
                writeFile(path, one);
            }
        }
        ::usleep(static_cast<useconds_t>(1000 + 617 * round));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        stumps = std::max(stumps, folder.entries() - 1);
        const std::string seen = contents(path);
        const bool whole = seen == std::string(one.begin(), one.end()) ||
                           seen == std::string(two.begin(), two.end());
        REQUIRE(whole);
    }
    // The kills must have met writes in progress, or this test has shown nothing.
    CHECK(stumps >= 1);
    checkWritable(path);
    CHECK(folder.entries() == 1);
}

TEST_CASE("Several processes with the same output: each time one of them is there whole") {
    const Folder folder;
    const std::string path = folder / "a.png";
    writeFile(path, std::vector<std::uint8_t>(200000, 'z'));
    std::vector<pid_t> children;
    for (char letter = 'a'; letter < 'e'; ++letter) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            const std::vector<std::uint8_t> bytes(200000, static_cast<std::uint8_t>(letter));
            int failures = 0;
            for (int i = 0; i < 50; ++i) failures += outcome([&] { writeFile(path, bytes); }) != 0;
            ::_exit(failures);
        }
        children.push_back(child);
    }
    std::set<char> seen;
    for (std::size_t ended = 0; ended < children.size();) {
        const std::string now = contents(path);
        const bool whole = now.size() == 200000 &&
                           std::all_of(now.begin(), now.end(), [&](char c) { return c == now[0]; });
        REQUIRE(whole);
        seen.insert(now[0]);
        int status = 0;
        if (::waitpid(children[ended], &status, WNOHANG) == 0) continue;
        CHECK(status == 0);
        ++ended;
    }
    CHECK(seen.size() > 1);
    CHECK(folder.entries() == 1);
}

TEST_CASE("An output that is one of the inputs, under any name, is a usage error") {
    const Folder folder;
    create(folder / "scene.lua", "");
    create(folder / "wood.png", "");
    fs::create_symlink("wood.png", folder / "link.png");
    fs::create_hard_link(folder / "wood.png", folder / "hard.png");
    const std::vector<std::string> inputs = {folder / "scene.lua", folder / "wood.png",
                                             folder / "not there"};
    for (const std::string name : {"scene.lua", "wood.png", "link.png", "hard.png"}) {
        CAPTURE(name);
        CHECK(outcome([&] { refuseOverwriting(folder / name, inputs); }) == 2);
    }
    refuseOverwriting(folder / "other.png", inputs);
    refuseOverwriting("-", inputs);
    refuseOverwriting("/dev/null", {"/dev/null"});
}
