// What --print prints holds what the tables hold.
#include "rt/app/documents.h"

#include "rt/app/options.h"
#include "rt/core/error.h"

#include <doctest/doctest.h>

#include <sstream>
#include <string>

using namespace rt;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string withEscapedHyphens(const std::string& text) {
    std::string escaped;
    for (const char c : text) escaped += c == '-' ? "\\-" : std::string(1, c);
    return escaped;
}

/// The line that begins so, or "".
std::string lineOf(const std::string& text, const std::string& begin) {
    const std::size_t at = text.find("\n" + begin);
    if (at == std::string::npos) return "";
    return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

}  // namespace

TEST_CASE("The manual page has an entry for every option, with its words") {
    const std::string page = documentText("man");
    for (const OptionHelp& row : optionHelp()) {
        std::string entry = ".TP\n\\fB" + withEscapedHyphens(row.flags) + "\\fR";
        if (!row.valueName.empty()) entry += " \\fI" + withEscapedHyphens(row.valueName) + "\\fR";
        entry += "\n" + withEscapedHyphens(row.text) + "\n";
        CAPTURE(entry);
        CHECK(holds(page, entry));
    }
}

TEST_CASE("Completions know every spelling of every option, and the values that can be listed") {
    const std::string bash = documentText("bash-completion");
    const std::string zsh = documentText("zsh-completion");
    for (const OptionHelp& row : optionHelp()) {
        std::string last;
        std::istringstream words(row.flags);
        for (std::string flag; words >> flag;) {
            last = flag.back() == ',' ? flag.substr(0, flag.size() - 1) : flag;
            CAPTURE(last);
            CHECK((holds(bash, last + " ") || holds(bash, last + "'")));
            CHECK(holds(zsh, "'*" + last));
        }
        for (const std::string& choice : row.choices) {
            CAPTURE(choice);
            CHECK(holds(lineOf(bash, "        " + last + ")"), choice));
        }
    }
}

TEST_CASE("Completion of golden leaves out what golden refuses") {
    const std::string golden = lineOf(documentText("bash-completion"), "        golden)");
    CHECK(holds(golden, "--tier "));
    CHECK(holds(golden, "--spp "));
    CHECK_FALSE(holds(golden, "--watch"));
    CHECK_FALSE(holds(golden, "--crop"));
}

TEST_CASE("A document that there is not is refused") {
    CHECK_THROWS_AS(documentText("poem"), UsageError);
}
