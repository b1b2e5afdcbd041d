// What the fuzzers call, and what replays their corpora without a fuzzer. Each takes any bytes. An
// rt::Error is an answer; anything else that is thrown, and a broken law, ends the process.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rt::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// The bytes as an OBJ file: every index of the mesh is in range, every number finite, every normal
/// a unit vector; its tree is built, too.
void obj(Bytes bytes);
/// The bytes as a PNG, with 4 Mpixel allowed: as many samples as the size says.
void image(Bytes bytes);
/// The bytes as choices of a grammar of scenes (scene_writer.h): what it renders has the same bits
/// with the baseline code and the fastest.
void scene(Bytes bytes);
/// The bytes as the text of a script, which is rendered, too.
void script(Bytes bytes);
/// The bytes as arguments, split at NUL: they are parsed, and parsed again to the same.
void options(Bytes bytes);

struct Target {
    const char* name;
    void (*run)(Bytes);
};
const std::vector<Target>& targets();

}  // namespace rt::fuzz
