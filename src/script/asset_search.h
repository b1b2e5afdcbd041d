// Where a scene's files are looked for, and which of them a script may read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

enum class AssetRole { kMesh, kTexture, kBump, kHeights };

/// Looks for assets as given from the current folder, the scene's folder and its parent; then, in
/// each of the three, in the folders of the role (also below Assets/), then in Assets/.
///
/// Without trust a file must be named by a relative path and lie, after links are resolved, below
/// the current folder, the scene's folder or one of the asset folders; or below the parent, if it
/// is named from there. Only regular files count.
class AssetSearch {
  public:
    AssetSearch(const std::filesystem::path& currentFolder,
                const std::filesystem::path& sceneFolder, bool trust);

    struct Found {
        std::string path;   ///< resolved, absolute; empty if there is none
        std::string error;  ///< what was wrong and where it was looked for, if there is none
        std::vector<std::string> absent;  ///< places that come first, where no file is
    };
    Found find(const std::string& name, AssetRole role) const;

  private:
    struct Base {
        std::filesystem::path folder;
        bool open;  ///< files of any folder below it may be named
    };
    struct Candidate {
        std::filesystem::path path;
        const Base* open;  ///< the folder whose files it may name, beside the roots
    };

    std::vector<Candidate> candidates(const std::string& name, AssetRole role) const;
    bool mayRead(const std::filesystem::path& resolved, const Base* open) const;

    std::vector<Base> bases_;
    std::vector<std::filesystem::path> roots_;  ///< resolved; what lies below them may be read
    bool trust_;
};

}  // namespace rt
