// The choices that a render makes once: where its samples lie, and how a pixel weighs them.
#pragma once

#include <cstdint>

namespace rt {

enum class SamplerKind : std::uint8_t { kJoint, kJitter, kGrid, kRandom };
enum class FilterKind : std::uint8_t { kBox, kGaussian, kMitchell, kBlackmanHarris };

}  // namespace rt
