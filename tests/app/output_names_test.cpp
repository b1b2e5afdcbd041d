#include "app/commands/output_names.h"

#include "rt/core/error.h"

#include <doctest/doctest.h>

using namespace rt;

namespace {

SceneDesc sceneWriting(const std::vector<std::string>& names) {
    SceneDesc scene;
    for (const std::string& name : names) {
        RenderDesc render;
        render.output = name;
        scene.renders.push_back(render);
    }
    return scene;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("without -o the script names its images") {
    const Options options;
    Diagnostics diagnostics;
    CHECK(OutputNames(options).namesFor(sceneWriting({"a.png", "b/c.exr"}), 1, diagnostics) ==
          Names{"a.png", "b/c.exr"});
    CHECK(diagnostics.total() == 0);
}

TEST_CASE("a name twice is a warning, from -o it is refused") {
    Options options;
    Diagnostics diagnostics;
    OutputNames(options).namesFor(sceneWriting({"a.png", "a.png"}), 1, diagnostics);
    CHECK(diagnostics.countByKind().count("overwritten") == 1);
    options.output = "one.png";
    OutputNames names(options);
    CHECK_THROWS_AS(names.namesFor(sceneWriting({"a.png", "b.png"}), 1, diagnostics), UsageError);
}

TEST_CASE("# is the number of the image, and goes on over the scenes of a run") {
    Options options = parseOptions({});
    options.output = "i-##.png";
    OutputNames names(options);
    Diagnostics diagnostics;
    CHECK(names.namesFor(sceneWriting({"a.png", "b.png"}), 1, diagnostics) ==
          Names{"i-01.png", "i-02.png"});
    CHECK(names.namesFor(sceneWriting({"c.png"}), 1, diagnostics) == Names{"i-03.png"});
}

TEST_CASE("with frames # is the frame, and two frames never share a file") {
    Options options;
    options.frames = FrameRange{7, 9};
    OutputNames names(options);
    Diagnostics diagnostics;
    CHECK(names.namesFor(sceneWriting({"f###.png"}), 7, diagnostics) == Names{"f007.png"});
    CHECK(names.namesFor(sceneWriting({"f###.png"}), 8, diagnostics) == Names{"f008.png"});
    CHECK(names.namesFor(sceneWriting({"same.png"}), 8, diagnostics) == Names{"same.png"});
    CHECK_THROWS_AS(names.namesFor(sceneWriting({"same.png"}), 9, diagnostics), UsageError);
}

TEST_CASE("a script may not write outside of the current folder, -o and trust may") {
    for (const char* name : {"../x.png", "/tmp/x.png", "a/../../x.png", "./../x.png"}) {
        Options options;
        Diagnostics diagnostics;
        CHECK_THROWS_AS(OutputNames(options).namesFor(sceneWriting({name}), 1, diagnostics),
                        SceneError);
        options.trust = true;
        CHECK(OutputNames(options).namesFor(sceneWriting({name}), 1, diagnostics) == Names{name});
        options.trust = false;
        options.output = name;
        CHECK(OutputNames(options).namesFor(sceneWriting({"x.png"}), 1, diagnostics) ==
              Names{name});
    }
    Options options;
    Diagnostics diagnostics;
    CHECK(OutputNames(options).namesFor(sceneWriting({"a/../x.png"}), 1, diagnostics) ==
          Names{"a/../x.png"});
}
