#include "rt/image/oiio_library.h"

#include "rt/core/plugin.h"

#include <dlfcn.h>

namespace rt {
namespace {

constexpr const char* kName = "librt_oiio.so";

template <typename Function>
bool find(void* library, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(::dlsym(library, name));
    return function != nullptr;
}

OiioLibrary openFirst() {
    if (const auto path = findPlugin(kName)) return openOiioLibrary(*path);
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
