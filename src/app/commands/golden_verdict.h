// Whether a picture is the one that it should be.
#pragma once

#include "image_difference.h"
#include "rt/app/options.h"

#include <string>
#include <vector>

namespace rt {

/// What holds between a picture and its reference: the strictest tier, or why there is none.
struct Verdict {
    GoldenTier tier = GoldenTier::kExact;
    std::string problem;  ///< "" if the pictures agree well enough
};

/// "exact", "portable", "statistical".
const char* nameOf(GoldenTier tier);

/// Why the two cannot be compared: size, channels, kind of values, values that are not finite
/// numbers; or "".
std::string incomparable(const ComparedImage& picture, const ComparedImage& reference);

/// Decides up to `weakest`, which is exact or portable. The portable tier is for pictures that
/// differ by roundings alone, such as those of another compiler: no channel is more than 1/255
/// apart, and at most 0.1 % of the pixels have one that is more than half of that apart. Of floats
/// above 1 the difference is relative. The pictures can be compared.
Verdict verdictOf(const ComparedImage& picture, const ComparedImage& reference, GoldenTier weakest);

/// Decides whether `reference` could be one more render of the scene that the `pictures`, two or
/// more with a seed each, are independent renders of. All can be compared. Of square blocks with
/// sides of 8, 16, 32, ... pixels the mean difference D from the pictures' mean must lie within ten
/// of its standard deviations by noise,
///     sqrt(c k V / n),
/// n: pixels; V: variance of one picture's pixels in the block, from neighbour to neighbour; k:
/// what the difference has of it, by the median of the blocks, since the reference's noise is its
/// own affair; c: by how much the noise of neighbours goes together, from the pictures' means of
/// blocks.
Verdict statisticalVerdict(const std::vector<ComparedImage>& pictures,
                           const ComparedImage& reference);

}  // namespace rt
