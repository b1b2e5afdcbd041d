#include "rt/app/progress.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

using namespace rt;

namespace {

/// A place for progress that keeps what it is given, with a clock that the test turns.
struct Screen {
    std::vector<std::string> writes;
    double clock = 100.0;
    int columns = 80;

    ProgressOutput output(bool terminal, bool colors = false) {
        return {[this](const std::string& text) { writes.push_back(text); },
                [this] { return clock; }, [this] { return columns; }, terminal, colors};
    }
    std::string all() const {
        std::string text;
        for (const std::string& write : writes) text += write;
        return text;
    }
};

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Text without escape sequences and carriage returns.
std::string visible(const std::string& text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\x1b') {
            while (i < text.size() && !std::isalpha(static_cast<unsigned char>(text[i]))) ++i;
        } else if (text[i] != '\r') {
            shown += text[i];
        }
    }
    return shown;
}

/// Sets a variable of the environment for one scope.
class Environment {
  public:
    Environment(const char* name, const char* value) : name_(name) {
        const char* old = std::getenv(name);
        had_ = old != nullptr;
        if (had_) old_ = old;
        if (value) {
            ::setenv(name, value, 1);
        } else {
            ::unsetenv(name);
        }
    }
    ~Environment() {
        if (had_) {
            ::setenv(name_, old_.c_str(), 1);
        } else {
            ::unsetenv(name_);
        }
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
    bool had_ = false;
    std::string old_;
};

}  // namespace

TEST_CASE("Off a terminal there is a line for each percent, in order, once") {
    Screen screen;
    Progress progress(screen.output(false), false);
    progress.begin(3);
    progress.startImage();
    for (int i = 0; i <= 1000; ++i) progress.update(i / 1000.0);
    screen.clock += 2.314;
    progress.finish({"a.png", 2.314, 0.002971});
    std::string expected = "Threads: 3\n";
    for (int i = 0; i <= 100; ++i) expected += std::to_string(i) + " %\n";
    expected += "Render Complete! a.png in 2.31 s, estimated error 0.00297\n";
    CHECK(screen.all() == expected);
}

TEST_CASE("Percents never go back, and 100 is shown at the end whatever was reached") {
    Screen screen;
    Progress progress(screen.output(false), false);
    progress.startImage();
    for (const double f : {0.5, 0.2, std::nan(""), -3.0, 0.509, 0.9999, 7.0}) progress.update(f);
    CHECK(screen.all() == "50 %\n99 %\n100 %\n");
    screen.writes.clear();
    progress.startImage();
    progress.update(0.25);
    progress.finish({"b.png", 1.0, std::nullopt});
    CHECK(screen.all() == "25 %\n100 %\nRender Complete! b.png in 1.00 s\n");
}

TEST_CASE("The end names standard output in words, and no name can command the terminal") {
    Screen screen;
    Progress progress(screen.output(false), false);
    progress.finish({"-", 1.0, std::nullopt});
    progress.finish({"a\x1b[2J.png", 1.0, std::nullopt});
    CHECK(holds(screen.all(), "Render Complete! standard output in 1.00 s\n"));
    CHECK_FALSE(holds(screen.all(), "\x1b"));
    CHECK(holds(screen.all(), "a\\x1b[2J.png"));
}

TEST_CASE("Quiet progress says nothing but messages") {
    Screen screen;
    Progress progress(screen.output(true), true);
    progress.begin(3);
    progress.startImage();
    progress.update(0.5);
    progress.finish({"a.png", 1.0, std::nullopt});
    progress.abandon();
    CHECK(screen.writes.empty());
    progress.message("warning: dark");
    CHECK(screen.all() == "warning: dark\n");
}

TEST_CASE("On a terminal a bar is redrawn in place with the time left") {
    Screen screen;
    Progress progress(screen.output(true), false);
    progress.startImage();
    screen.clock += 10.0;
    progress.update(0.25);
    REQUIRE(screen.writes.size() == 1);
    CHECK(screen.writes[0].compare(0, 4, "\r\x1b[K") == 0);
    CHECK(holds(screen.writes[0], " 25 %"));
    CHECK(holds(screen.writes[0], "0:30 left"));
    CHECK_FALSE(holds(screen.all(), "\n"));
    CHECK_FALSE(holds(screen.all(), "\x1b[32m"));
    const auto filled = std::count(screen.writes[0].begin(), screen.writes[0].end(), '=');
    const std::string shown = visible(screen.writes[0]);
    const auto length = static_cast<long>(shown.find(']') - shown.find('[')) - 1;
    CHECK(filled == length / 4);
    progress.finish({"a.png", 40.0, std::nullopt});
    CHECK(holds(screen.all(), "100 %"));
    CHECK(holds(screen.all(), "left\nRender Complete!"));
}

TEST_CASE("The bar is redrawn when a percent or some time has passed, and not for each update") {
    Screen screen;
    Progress progress(screen.output(true), false);
    progress.startImage();
    for (int i = 0; i < 1000; ++i) progress.update(0.1 + i * 1e-6);
    CHECK(screen.writes.size() == 1);
    screen.clock += 1.0;
    progress.update(0.102);
    CHECK(screen.writes.size() == 2);
}

TEST_CASE("No bar is as wide as its terminal") {
    for (int columns = 1; columns <= 200; ++columns) {
        CAPTURE(columns);
        Screen screen;
        screen.columns = columns;
        Progress progress(screen.output(true, true), false);
        progress.startImage();
        screen.clock += 12345.0;
        progress.update(0.5);
        const std::string shown = visible(screen.all());
        CHECK(holds(shown, "50 %"));
        if (columns > 6) CHECK(static_cast<int>(shown.size()) < columns);
        if (columns > 40) CHECK(holds(shown, "3:25:45 left"));
    }
}

TEST_CASE("The bar shows the error so far where there is room, until the next image") {
    Screen screen;
    Progress progress(screen.output(true), false);
    progress.startImage();
    screen.clock += 10.0;
    progress.estimate(0.012345);
    CHECK(screen.writes.empty());
    progress.update(0.5);
    CHECK(holds(screen.writes.back(), " 50 %  error 0.0123  0:10 left"));
    screen.columns = 30;
    progress.update(0.6);
    CHECK(holds(screen.writes.back(), " 60 %  0:07 left"));
    CHECK_FALSE(holds(screen.writes.back(), "error"));
    CHECK(holds(screen.writes.back(), "["));
    screen.columns = 80;
    progress.startImage();
    progress.update(0.1);
    CHECK_FALSE(holds(screen.writes.back(), "error"));
}

TEST_CASE("A message appears above the bar, which is drawn again") {
    Screen screen;
    Progress progress(screen.output(true), false);
    progress.startImage();
    progress.update(0.5);
    progress.message("scene.lua:3: warning: dark");
    REQUIRE(screen.writes.size() == 3);
    CHECK(screen.writes[1] == "\r\x1b[Kscene.lua:3: warning: dark\n");
    CHECK(holds(screen.writes[2], "50 %"));
    progress.abandon();
    CHECK(screen.writes.back() == "\n");
}

TEST_CASE("Colours are escape sequences around the same text") {
    Screen plain;
    Screen coloured;
    for (Screen* screen : {&plain, &coloured}) {
        Progress progress(screen->output(true, screen == &coloured), false);
        progress.startImage();
        screen->clock += 1.0;
        progress.update(0.5);
        progress.finish({"a.png", 1.0, 0.1});
    }
    CHECK(holds(coloured.all(), "\x1b[1;32mRender Complete!\x1b[0m"));
    CHECK_FALSE(holds(plain.all(), "\x1b[1;32m"));
    CHECK(visible(coloured.all()) == visible(plain.all()));
}

TEST_CASE("Colours: always and never decide; auto wants a terminal and no NO_COLOR") {
    int master = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0) {
        MESSAGE("no pseudo-terminals on this machine");
        return;
    }
    ::grantpt(master);
    ::unlockpt(master);
    const int terminal = ::open(::ptsname(master), O_RDWR | O_NOCTTY);
    REQUIRE(terminal >= 0);
    const int file = ::open("/dev/null", O_WRONLY);
    struct Case {
        ColorMode mode;
        int descriptor;
        const char* noColor;
        const char* term;
        bool expected;
    };
    const std::vector<Case> cases = {
        {ColorMode::kAuto, terminal, nullptr, "xterm", true},
        {ColorMode::kAuto, terminal, "", "xterm", true},
        {ColorMode::kAuto, terminal, "1", "xterm", false},
        {ColorMode::kAuto, terminal, nullptr, "dumb", false},
        {ColorMode::kAuto, terminal, nullptr, nullptr, false},
        {ColorMode::kAuto, file, nullptr, "xterm", false},
        {ColorMode::kAlways, file, "1", "dumb", true},
        {ColorMode::kNever, terminal, nullptr, "xterm", false},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        CAPTURE(i);
        const Environment noColor("NO_COLOR", cases[i].noColor);
        const Environment term("TERM", cases[i].term);
        CHECK(wantsColors(cases[i].mode, cases[i].descriptor) == cases[i].expected);
    }
    for (const int descriptor : {file, terminal, master}) ::close(descriptor);
}

TEST_CASE("Durations are told in the units that matter") {
    CHECK(durationText(0.0) == "0.00 s");
    CHECK(durationText(2.314) == "2.31 s");
    CHECK(durationText(59.99) == "59.99 s");
    CHECK(durationText(59.999) == "1 min 0 s");
    CHECK(durationText(247.4) == "4 min 7 s");
    CHECK(durationText(3599.6) == "1 h 0 min");
    CHECK(durationText(7500.0) == "2 h 5 min");
}

TEST_CASE("Updates from several threads give each percent at most once") {
    Screen screen;
    Progress progress(screen.output(false), false);
    progress.startImage();
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&] {
            for (int i = 0; i <= 10000; ++i) progress.update(i / 10000.0);
        });
    }
    for (std::thread& thread : threads) thread.join();
    CHECK(screen.writes.size() <= 101);
    for (std::size_t i = 1; i < screen.writes.size(); ++i) {
        CHECK(std::stoi(screen.writes[i - 1]) < std::stoi(screen.writes[i]));
    }
    CHECK(screen.writes.back() == "100 %\n");
}
