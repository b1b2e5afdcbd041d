#include "rt/core/plugin.h"

#include <filesystem>
#include <system_error>

namespace rt {

std::optional<std::string> findPlugin(const std::string& name) {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path folder = program.parent_path();
    for (const auto& path : {folder / name, folder / ".." / "lib" / "project" / name,
                             folder / "build" / "release" / name}) {
        if (std::filesystem::exists(path, error)) return path.string();
    }
    return std::nullopt;
}

}  // namespace rt
