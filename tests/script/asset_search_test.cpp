// Where assets are looked for, in which order, and what is out of reach.
#include "../../src/script/asset_search.h"

#include "gr_script.h"

#include <doctest/doctest.h>

#include <sys/stat.h>

using namespace rt;
using rt::test::SceneFolder;

namespace fs = std::filesystem;

namespace {

/// A project with the scene's folder p/scenes, and a current folder beside it.
struct Project {
    SceneFolder top;
    fs::path current = top.path() / "here";
    fs::path parent = top.path() / "p";
    fs::path scenes = parent / "scenes";

    Project() {
        fs::create_directories(current);
        fs::create_directories(scenes);
    }
    AssetSearch search(bool trust = false) const { return {current, scenes, trust}; }
    AssetSearch::Found find(const std::string& name, AssetRole role = AssetRole::kMesh,
                            bool trust = false) const {
        return search(trust).find(name, role);
    }
    bool denies(const std::string& name) const {
        const AssetSearch::Found found = find(name);
        return found.path.empty() && found.error.find("denied") != std::string::npos;
    }
};

}  // namespace

TEST_CASE("a mesh is looked for in the order of the language's reference") {
    const Project project;
    std::vector<std::string> order;
    for (const char* base : {"here", "p/scenes", "p"}) order.push_back(base);
    for (const char* base : {"here", "p/scenes", "p"}) {
        for (const char* folder : {"Model", "Meshes", "Assets/Model", "Assets/Meshes", "Assets"}) {
            order.push_back(std::string(base) + "/" + folder);
        }
    }
    // The last place first: each file that is added must win over those of the places after it.
    for (auto place = order.rbegin(); place != order.rend(); ++place) {
        CAPTURE(*place);
        CHECK(project.find("cow.obj").path != (project.top.path() / *place / "cow.obj").string());
        const std::string file = project.top.write(*place + "/cow.obj");
        CHECK(project.find("cow.obj").path == file);
    }
}

TEST_CASE("textures and bump maps have folders of their own, and shared ones") {
    const Project project;
    const std::string texture = project.top.write("p/Texture/a.png");
    const std::string bump = project.top.write("p/Assets/Bump/a.png");
    CHECK(project.find("a.png", AssetRole::kTexture).path == texture);
    CHECK(project.find("a.png", AssetRole::kBump).path == bump);
    CHECK(project.find("a.png", AssetRole::kMesh).path == "");
    const std::string shared = project.top.write("p/Assets/b.png");
    for (AssetRole role : {AssetRole::kMesh, AssetRole::kTexture, AssetRole::kBump}) {
        CHECK(project.find("b.png", role).path == shared);
    }
}

TEST_CASE("a name may hold folders, also upwards into an asset folder") {
    const Project project;
    const std::string deep = project.top.write("p/scenes/sub/deep/x.obj");
    CHECK(project.find("sub/deep/x.obj").path == deep);
    CHECK(project.find("./sub/../sub/deep/x.obj").path == deep);
    const std::string model = project.top.write("p/Model/y.obj");
    CHECK(project.find("../Model/y.obj").path == model);
    const std::string beside = project.top.write("p/other/z.obj");
    CHECK(project.find("other/z.obj").path == beside);
}

TEST_CASE("what lies outside is denied, whether it is there or not") {
    const Project project;
    project.top.write("secret.obj");
    project.top.write("p/other/secret.obj");
    CHECK(project.denies("../../secret.obj"));
    CHECK(project.denies("../../nothing.obj"));
    CHECK(project.denies("../other/secret.obj"));
    CHECK(project.denies("Model/../../../secret.obj"));
    const std::string nothing = "nothing";
    std::string hidden = project.find("../../secret.obj").error;
    for (std::size_t at; (at = hidden.find("secret")) != std::string::npos;) {
        hidden.replace(at, 6, nothing);
    }
    CHECK(hidden == project.find("../../nothing.obj").error);
    CHECK(project.find("/etc/passwd").error ==
          "'/etc/passwd' is denied: absolute paths need --trust");
}

TEST_CASE("links are followed before the folder is judged") {
    const Project project;
    const std::string secret = project.top.write("secret.obj");
    const std::string other = project.top.write("p/other/secret.obj");
    fs::create_symlink(secret, project.scenes / "link.obj");
    fs::create_symlink(other, project.scenes / "sideways.obj");
    fs::create_directory_symlink(project.top.path(), project.scenes / "out");
    CHECK(project.denies("link.obj"));
    CHECK(project.denies("sideways.obj"));
    CHECK(project.denies("out/secret.obj"));
    const std::string inside = project.top.write("p/scenes/real.obj");
    fs::create_symlink("real.obj", project.scenes / "fine.obj");
    CHECK(project.find("fine.obj").path == inside);
    // An asset folder may itself be a link: whoever made it meant it.
    const std::string shared = project.top.write("library/s.obj");
    fs::create_directory_symlink(project.top.path() / "library", project.parent / "Model");
    CHECK(project.find("s.obj").path == shared);
}

TEST_CASE("trust opens absolute and outside paths") {
    const Project project;
    const std::string secret = project.top.write("secret.obj");
    CHECK(project.find(secret, AssetRole::kMesh, true).path == secret);
    CHECK(project.find("../../secret.obj", AssetRole::kMesh, true).path == secret);
}

TEST_CASE("folders, pipes and devices are no assets") {
    const Project project;
    fs::create_directories(project.scenes / "dir.obj");
    REQUIRE(mkfifo((project.scenes / "pipe.obj").c_str(), 0600) == 0);
    for (const char* name : {"dir.obj", "pipe.obj"}) {
        CAPTURE(name);
        const AssetSearch::Found found = project.find(name);
        CHECK(found.path == "");
        CHECK(found.error.find("not a regular file") != std::string::npos);
    }
    const std::string file = project.top.write("p/Model/dir.obj");
    CHECK(project.find("dir.obj").path == file);
}

TEST_CASE("names that cannot be files are refused in words") {
    const Project project;
    CHECK(project.find("").error == "the file name is empty");
    CHECK(project.find(std::string("a\0b", 3)).error == "'a\\x00b' holds a NUL byte");
    CHECK(project.find(std::string(5000, 'a')).error.find("cannot find 'aaa") == 0);
    CHECK(project.find("\x1b[2J.obj").error.find('\x1b') == std::string::npos);
}

TEST_CASE("a scene right below the top folder does not open the whole file system") {
    const Project project;
    const AssetSearch search(project.current, "/tmp", false);
    CHECK(search.find("etc/passwd", AssetRole::kMesh).path == "");
    CHECK(AssetSearch(project.current, "/", false).find("etc/nothing.obj", AssetRole::kMesh).path ==
          "");
}

TEST_CASE("each place is listed once where the current folder is the scene's") {
    const SceneFolder folder;
    const AssetSearch search(folder.path(), folder.path(), false);
    const std::string error = search.find("q.obj", AssetRole::kMesh).error;
    const std::string place = (folder.path() / "q.obj").string();
    CHECK(error.find(place) != std::string::npos);
    CHECK(error.find(place) == error.rfind(place));
}
