#include "app/commands/file_watch.h"

#include "compile/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace rt;
using rt::test::ScratchFolder;

namespace {

constexpr double kSoon = 5.0;    ///< more than a change takes to be seen
constexpr double kMoment = 0.3;  ///< more than that, where nothing should be seen

using Paths = std::vector<std::string>;

void write(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
}

/// A round that reads these files, written well before it.
void round(FileWatch& watch, const Paths& paths) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    watch.begin();
    watch.add(paths);
    watch.end();
}

}  // namespace

TEST_CASE("file watch: what was written, replaced, removed and made is seen, once") {
    for (const auto notices : {FileWatch::Notices::kInotify, FileWatch::Notices::kNever}) {
        const ScratchFolder folder;
        const std::string a = folder.path("a");
        const std::string b = folder.path("b");
        write(a, "1");
        FileWatch watch(notices);
        round(watch, {a, b});
        CHECK(watch.size() == 2);
        CHECK(watch.wait(kMoment).empty());
        write(a, "22");
        CHECK(watch.wait(kSoon) == Paths{a});
        CHECK(watch.wait(kMoment).empty());
        write(folder.path("new"), "33");
        std::filesystem::rename(folder.path("new"), a);
        CHECK(watch.wait(kSoon) == Paths{a});
        write(b, "");
        CHECK(watch.wait(kSoon) == Paths{b});
        std::filesystem::remove(a);
        CHECK(watch.wait(kSoon) == Paths{a});
    }
}

TEST_CASE("file watch: other files of the folder do not count, nor files of earlier rounds") {
    const ScratchFolder folder;
    const std::string a = folder.path("a");
    const std::string b = folder.path("b");
    write(a, "1");
    write(b, "1");
    FileWatch watch;
    round(watch, {a, b});
    round(watch, {a});
    write(b, "22");
    write(folder.path("c"), "1");
    CHECK(watch.wait(kMoment).empty());
}

TEST_CASE("file watch: what the run writes itself does not count, whenever it was added") {
    const ScratchFolder folder;
    const std::string a = folder.path("a");
    const std::string b = folder.path("b");
    FileWatch watch;
    watch.ignore(a);
    round(watch, {a, b});
    watch.ignore(b);
    write(a, "1");
    write(b, "1");
    CHECK(watch.wait(kMoment).empty());
    CHECK(watch.size() == 0);
}

TEST_CASE("file watch: a file in a folder that comes later") {
    for (const auto notices : {FileWatch::Notices::kInotify, FileWatch::Notices::kNever}) {
        const ScratchFolder folder;
        const std::string deep = folder.path("x/y/file");
        FileWatch watch(notices);
        round(watch, {deep});
        std::filesystem::create_directories(folder.path("x/y"));
        CHECK(watch.wait(kMoment).empty());
        write(deep, "1");
        CHECK(watch.wait(kSoon) == Paths{deep});
        std::filesystem::rename(folder.path("x"), folder.path("z"));
        CHECK(watch.wait(kSoon) == Paths{deep});
        std::filesystem::create_directories(folder.path("x/y"));
        write(deep, "1");
        CHECK(watch.wait(kSoon) == Paths{deep});
    }
}

TEST_CASE("file watch: what changed while it was read is read again, once") {
    const ScratchFolder folder;
    const std::string a = folder.path("a");
    FileWatch watch;
    watch.begin();
    write(a, "1");
    watch.add({a});
    watch.end();
    CHECK(watch.wait(kSoon) == Paths{a});
    watch.begin();
    watch.add({a});
    watch.end();
    CHECK(watch.wait(kMoment).empty());
    watch.begin();
    write(a, "22");
    watch.add({a});
    CHECK(watch.wait(kSoon) == Paths{a});
}

TEST_CASE("file watch: a file is read when it has been quiet for a moment") {
    const ScratchFolder folder;
    const std::string a = folder.path("a");
    write(a, "1");
    // Far longer than the editor's pauses, also where other programs hold the processor.
    FileWatch watch(FileWatch::Notices::kInotify, 0.5);
    round(watch, {a});
    std::thread editor([&] {
        write(a, "");
        for (int i = 0; i < 8; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(40));
            std::ofstream(a, std::ios::app) << "22";
        }
    });
    CHECK(watch.wait(kSoon) == Paths{a});
    editor.join();
    CHECK(std::filesystem::file_size(a) == 16);
    CHECK(watch.wait(kMoment).empty());
}
