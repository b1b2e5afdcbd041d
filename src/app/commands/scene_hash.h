// Everything that decides the bytes of a picture, and a number for it.
#pragma once

#include "rt/app/options.h"
#include "rt/script/scene_script.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// FNV-1a of 64 bits (Fowler, Noll, Vo, draft-eastlake-fnv), each field after its length. Against
/// accidents, not against malice.
class Fingerprint {
  public:
    Fingerprint& add(std::span<const std::uint8_t> bytes);
    Fingerprint& add(std::string_view text);
    Fingerprint& add(std::uint64_t number);
    std::uint64_t value() const { return value_; }

  private:
    void mix(std::uint8_t byte);

    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// One thing that decides the bytes of a picture, by its name for people.
struct Trait {
    std::string name;
    std::string value;
};

/// The program's version; the contents of all files that the run reads, in any order and under
/// any names; the script's arguments and parameters; the frame and the range it is of; the size;
/// every option of quality; and the number of the render. Where the picture goes, how it is cut up,
/// threads, instruction sets and limits change no pixel, and are not among them.
///
/// `merged` are the options of the command line over the script's. Throws SceneError for a scene
/// from standard input, whose text is gone, and where a file has gone.
std::vector<Trait> traitsOf(const Options& options, const RenderOptions& merged,
                            const ScriptResult& script, std::size_t render, std::int64_t frame);

/// How the picture is cut up: --crop and --shard.
std::vector<Trait> partTraitsOf(const Options& options);

/// Of traits of the same run.
std::uint64_t sceneHash(const std::vector<Trait>& traits);

}  // namespace rt
