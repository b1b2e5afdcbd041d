#include "rt/image/oiio_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>
#include <vector>

namespace rt {
namespace {

constexpr const char* kName = "librt_oiio.so";

template <typename Function>
bool find(void* library, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(::dlsym(library, name));
    return function != nullptr;
}

std::vector<std::filesystem::path> candidates() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path folder = program.parent_path();
    return {folder / kName, folder / ".." / "lib" / "project" / kName,
            folder / "build" / "release" / kName};
}

OiioLibrary openFirst() {
    for (const std::filesystem::path& path : candidates()) {
        std::error_code error;
        if (std::filesystem::exists(path, error)) return openOiioLibrary(path.string());
    }
    return {nullptr, nullptr, nullptr,
            std::string("built without OpenImageIO: install libopenimageio-dev and build again (") +
                kName + " is missing beside the program)"};
}

}  // namespace

OiioLibrary openOiioLibrary(const std::string& path) {
    OiioLibrary library;
    void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
        library.problem = std::string("OpenImageIO cannot be loaded: install libopenimageio2.4 (") +
                          ::dlerror() + ")";
    } else if (!find(handle, "rtOiioRead", library.read) ||
               !find(handle, "rtOiioWrite", library.write) ||
               !find(handle, "rtOiioFree", library.free)) {
        library.problem = path + " is not this program's plugin: build it again";
    }
    return library;
}

const OiioLibrary& oiioLibrary() {
    static const OiioLibrary library = openFirst();
    return library;
}

}  // namespace rt
