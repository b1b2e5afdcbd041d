// Where something that moves may be while the shutter is open.
#pragma once

#include "rt/core/bounds.h"
#include "rt/core/motion.h"

namespace rt {

/// Contains the images of `box` at all times in 0 .. 1, roundings included: the union over pieces
/// of the time of what interval arithmetic says of each (Moore, Interval Analysis, 1966). Wider
/// than need be by about the square of the angle that a piece turns by, at most kTurnOfPiece while
/// the whole turn is below kMostPieces of them.
Bounds sweptBounds(const MotionPath& path, const Bounds& box);

}  // namespace rt
