// A script beside image and mesh files that a test makes, compiled.
#pragma once

#include "rt/compile/compile.h"
#include "rt/image/image.h"
#include "support/render_script.h"

#include <lodepng.h>

#include <string>
#include <vector>

namespace rt::test {

/// Writes an image of 8-bit codes as a PNG.
inline void writePng(const TemporaryFolder& folder, const std::string& name, int width, int height,
                     int channels, const std::vector<std::uint8_t>& codes) {
    std::vector<unsigned char> file;
    lodepng::encode(file, codes, static_cast<unsigned>(width), static_cast<unsigned>(height),
                    channels == 1 ? LCT_GREY : LCT_RGB, 8);
    folder.write(name, std::string(file.begin(), file.end()));
}

/// `squares` x `squares` squares of `texels` texels, black at the top left; as wide as the image.
inline void writeChecker(const TemporaryFolder& folder, const std::string& name, int squares,
                         int texels) {
    const int size = squares * texels;
    std::vector<std::uint8_t> codes;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) codes.push_back((x / texels + y / texels) % 2 ? 255 : 0);
    }
    writePng(folder, name, size, size, 1, codes);
}

inline RenderScene compiled(const TemporaryFolder& folder, const std::string& script) {
    Diagnostics diagnostics;
    const SceneDesc scene = runScript(folder.write("scene.lua", script), {}, diagnostics).scene;
    AssetCache assets(1);
    return compileScene(scene, 0, {}, assets, diagnostics);
}

}  // namespace rt::test
