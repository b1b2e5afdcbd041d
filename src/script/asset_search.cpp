#include "asset_search.h"

#include "rt/core/diagnostics.h"

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr const char* kAssets = "Assets";

const std::vector<const char*>& roleFolders(AssetRole role) {
    static const std::vector<const char*> meshes{"Model", "Meshes"};
    static const std::vector<const char*> textures{"Texture"};
    static const std::vector<const char*> bumps{"Bump"};
    static const std::vector<const char*> heights{"Bump", "Texture"};
    switch (role) {
        case AssetRole::kMesh:
            return meshes;
        case AssetRole::kTexture:
            return textures;
        case AssetRole::kBump:
            return bumps;
        default:
            return heights;
    }
}

fs::path resolved(const fs::path& path) {
    std::error_code failed;
    fs::path result = fs::weakly_canonical(path, failed);
    return failed ? path.lexically_normal() : result;
}

bool liesBelow(const fs::path& path, const fs::path& folder) {
    const auto difference = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return difference.first == folder.end();
}

void addOnce(std::vector<fs::path>& paths, const fs::path& path) {
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
}

std::vector<std::string> texts(const std::vector<fs::path>& paths) {
    std::vector<std::string> all;
    for (const fs::path& path : paths) all.push_back(path.string());
    return all;
}

std::string list(const std::vector<fs::path>& paths) {
    std::string text;
    for (const fs::path& path : paths) text += "\n    " + printable(path.string(), 512);
    return text;
}

}  // namespace

AssetSearch::AssetSearch(const fs::path& currentFolder, const fs::path& sceneFolder, bool trust)
    : trust_(trust) {
    const fs::path current = resolved(currentFolder);
    const fs::path scene = resolved(sceneFolder);
    const fs::path parent = scene.parent_path();
    bases_ = {{current, true}, {scene, true}};
    // The file system's top folder is nobody's project: only its asset folders are read.
    if (parent != scene) bases_.push_back({parent, parent != parent.root_path()});
    roots_ = {current, scene};
    for (const Base& base : bases_) {
        for (const AssetRole role : {AssetRole::kMesh, AssetRole::kTexture, AssetRole::kBump}) {
            for (const char* folder : roleFolders(role)) {
                roots_.push_back(resolved(base.folder / folder));
            }
        }
        roots_.push_back(resolved(base.folder / kAssets));
    }
}

std::vector<AssetSearch::Candidate> AssetSearch::candidates(const std::string& name,
                                                            AssetRole role) const {
    std::vector<Candidate> all;
    const auto add = [&](const fs::path& path, const Base* open = nullptr) {
        const auto same = [&](const Candidate& other) { return other.path == path; };
        if (std::none_of(all.begin(), all.end(), same)) all.push_back({path, open});
    };
    for (const Base& base : bases_) {
        if (base.open || trust_) add(base.folder / name, &base);
    }
    for (const Base& base : bases_) {
        const fs::path assets = base.folder / kAssets;
        for (const char* folder : roleFolders(role)) add(base.folder / folder / name);
        for (const char* folder : roleFolders(role)) add(assets / folder / name);
        add(assets / name);
    }
    return all;
}

bool AssetSearch::mayRead(const fs::path& path, const Base* open) const {
    if (trust_ || (open && liesBelow(path, open->folder))) return true;
    return std::any_of(roots_.begin(), roots_.end(),
                       [&](const fs::path& root) { return liesBelow(path, root); });
}

AssetSearch::Found AssetSearch::find(const std::string& name, AssetRole role) const {
    const std::string quoted = "'" + printable(name, 512) + "'";
    if (name.empty()) return {"", "the file name is empty", {}};
    if (name.find('\0') != std::string::npos) return {"", quoted + " holds a NUL byte", {}};
    if (fs::path(name).is_absolute() && !trust_) {
        return {"", quoted + " is denied: absolute paths need --trust", {}};
    }
    std::vector<fs::path> missing, denied, strange;
    for (const Candidate& candidate : candidates(name, role)) {
        const fs::path path = resolved(candidate.path);
        std::error_code failed;
        if (!mayRead(path, candidate.open)) {
            addOnce(denied, candidate.path.lexically_normal());
        } else if (fs::is_regular_file(path, failed)) {
            return {path.string(), "", texts(missing)};
        } else {
            addOnce(fs::exists(path, failed) ? strange : missing,
                    candidate.path.lexically_normal());
        }
    }
    std::string message = "cannot find " + quoted;
    if (!strange.empty()) message += "; not a regular file:" + list(strange);
    if (!denied.empty()) {
        message +=
            "; denied, outside the folders that a scene may read (see --trust):" + list(denied);
    }
    if (!missing.empty()) message += "; looked for:" + list(missing);
    return {"", message, texts(missing)};
}

}  // namespace rt
