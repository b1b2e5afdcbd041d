#include "app/commands/dependency_file.h"

#include "rt/core/error.h"

#include <doctest/doctest.h>

using namespace rt;

TEST_CASE("dependencies: a rule for each run of a script, then an empty one for each file") {
    CHECK(dependencyText({{{"a.png", "b.png"}, {"/home/me/s.lua", "/lib/m.obj"}},
                          {{"c.png"}, {"/home/me/s.lua"}}},
                         "/home/me") ==
          "a.png b.png: \\\n  s.lua \\\n  /lib/m.obj\n"
          "c.png: \\\n  s.lua\n"
          "/lib/m.obj:\ns.lua:\n");
}

TEST_CASE("dependencies: a run without images has no rule") {
    CHECK(dependencyText({{{}, {"/s.lua"}}}, "/") == "");
}

TEST_CASE("dependencies: only what lies below the folder loses its path") {
    CHECK(dependencyText({{{"o"}, {"/home/me2/s.lua"}}}, "/home/me") ==
          "o: \\\n  /home/me2/s.lua\n/home/me2/s.lua:\n");
    CHECK(dependencyText({{{"o"}, {"/s.lua"}}}, "/") == "o: \\\n  s.lua\ns.lua:\n");
}

TEST_CASE("dependencies: names are escaped") {
    const auto shown = [](const std::string& name) {
        const std::string text = dependencyText({{{name}, {}}}, "/");
        return text.substr(0, text.size() - 2);
    };
    CHECK(shown("a b") == "a\\ b");
    CHECK(shown("a#b:c") == "a\\#b\\:c");
    CHECK(shown("$a$$") == "$$a$$$$");
    CHECK(shown("a\\b") == "a\\b");
    CHECK(shown("a\\ b") == "a\\\\\\ b");
    CHECK_THROWS_AS(shown("a\nb"), OutputError);
}
