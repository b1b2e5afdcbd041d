#include "rt/core/diagnostics.h"

#include <doctest/doctest.h>

#include <random>

using namespace rt;

namespace {

TEST_CASE("Warnings are counted by kind, and the first of each kind are kept in order") {
    Diagnostics diagnostics;
    for (int i = 1; i <= 8; ++i) {
        diagnostics.warn("first", {"a.lua", i}, "number " + std::to_string(i));
        if (i % 4 == 0) diagnostics.warn("second", {}, "other");
    }
    CHECK(diagnostics.total() == 10);
    CHECK(diagnostics.countByKind().at("first") == 8);
    CHECK(diagnostics.countByKind().at("second") == 2);
    REQUIRE(diagnostics.shown().size() == Diagnostics::kShownPerKind + 2);
    CHECK(diagnostics.shown()[3].message == "number 4");
    CHECK(diagnostics.shown()[3].where.line == 4);
    CHECK(diagnostics.shown()[4].kind == "second");
    CHECK(diagnostics.shown()[5].message == "number 5");
    CHECK(diagnostics.shown()[6].kind == "second");
}

TEST_CASE("A warning cannot drive the terminal") {
    Diagnostics diagnostics;
    diagnostics.warn("x", {}, "\x1b[31mred");
    CHECK(diagnostics.shown()[0].message == "\\x1b[31mred");
}

TEST_CASE("printable shows controls and broken UTF-8, and leaves all other text alone") {
    const struct {
        std::string text, shown;
    } rows[] = {
        {"plain text", "plain text"},
        {"two\nlines\tand a tab", "two\nlines\tand a tab"},
        {std::string("a\0b", 3), "a\\x00b"},
        {"\r\x07\x7f", "\\x0d\\x07\\x7f"},
        {"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8e\xa8", "\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8e\xa8"},
        {"\xc2\x9b"
         "31m",
         "\\xc2\\x9b31m"},
        {"\xc2\xa0", "\xc2\xa0"},
        {"\xff\xc3", "\\xff\\xc3"},
        {"\xc0\xaf", "\\xc0\\xaf"},
        {"\xe0\x80\x80", "\\xe0\\x80\\x80"},
        {"\xed\xa0\x80", "\\xed\\xa0\\x80"},
        {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},
        {"\xf0\x9f\x8e"
         "a",
         "\\xf0\\x9f\\x8e"
         "a"},
        {"", ""},
    };
    for (const auto& row : rows) CHECK(printable(row.text) == row.shown);
}

TEST_CASE("printable cuts between characters and says so") {
    CHECK(printable("0123456789", 10) == "0123456789");
    CHECK(printable("0123456789x", 10) == "0123456...");
    CHECK(printable("01234\xe2\x82\xac\xe2\x82\xac", 10) == "01234...");
    CHECK(printable("\x01\x02\x03", 10) == "\\x01...");
    CHECK(printable(std::string(std::size_t{1} << 24, 'x')).size() == 4096);
    CHECK(printable("abcd", 3) == "...");
    CHECK(printable("abcd", 2) == "..");
    CHECK(printable("abcd", 0).empty());
}

TEST_CASE("What printable has shown is printable, and never longer than asked for") {
    std::mt19937 random(7);
    for (int round = 0; round < 2000; ++round) {
        std::string text(random() % 40, '\0');
        for (char& c : text) c = static_cast<char>(random());
        const std::size_t most = random() % 60;
        CAPTURE(round);
        const std::string shown = printable(text, most);
        CHECK(shown.size() <= most);
        CHECK(printable(shown, most) == shown);
    }
}

}  // namespace
