// An interrupted render as a file: what it has traced, and what picture that is of.
//
// Numbers are little endian (rt/core/packed_bytes.h).
//
//   "RTCHECK1\n"
//   u4        traits; of each a text for its name, a text for its value
//   log       as rt/render/render_log.h has it; samples of pixels are f8 x 6 sum and half of the
//             sum, u8 their number; of corners and looks f4 x 6 sum and first half, u4 samples, u4
//             marks, u8 x 3 surfaces, lit, dark, f4 x 6 position and normal
//   u8        FNV-1a of all bytes before
#pragma once

#include "rt/render/render_log.h"
#include "scene_hash.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rt {

std::vector<std::uint8_t> encodeCheckpoint(const std::vector<Trait>& traits, const RenderLog& log);

/// Whether they begin as a checkpoint of any version does.
bool isCheckpoint(std::span<const std::uint8_t> bytes);

/// What became of reading a checkpoint.
struct CheckpointVerdict {
    enum class Kind { kFits, kUseless, kOther } kind = Kind::kFits;
    std::string why;  ///< the sentence, where it does not fit
};

/// Fills `log` where the bytes are whole, of this version, and of the picture that `traits` tell;
/// else leaves it alone. kUseless: damaged, or of another version; kOther: of another picture.
CheckpointVerdict decodeCheckpoint(std::span<const std::uint8_t> bytes,
                                   const std::vector<Trait>& traits, RenderLog& log);

/// "x.checkpoint" for "x.png" and "x.2-of-4.checkpoint" for "x.2-of-4.part".
std::string checkpointName(const std::string& output);

}  // namespace rt
