// A number for everything that decides the bytes of a picture.
#pragma once

#include "rt/app/options.h"
#include "rt/script/scene_script.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

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

/// Of the program's version; the contents of all files that the run reads, in any order and under
/// any names; the script's arguments and parameters; the frame and the range it is of; the size;
/// every option of quality; and the number of the render. Where the picture goes, how it is cut up,
/// threads, instruction sets and limits change no pixel, and are not in it.
///
/// `merged` are the options of the command line over the script's. Throws SceneError for a scene
/// from standard input, whose text is gone, and where a file has gone.
std::uint64_t sceneHash(const Options& options, const RenderOptions& merged,
                        const ScriptResult& script, std::size_t render, std::int64_t frame);

}  // namespace rt
