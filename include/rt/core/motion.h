// How something moves while the shutter is open: a way of maps, some of which depend on the time.
#pragma once

#include "rt/core/transform.h"

#include <vector>

namespace rt {

/// At time s, in 0 .. 1: first `before`, then either s times the way `by`, or s times a
/// right-handed turn of `degrees` about an axis (0 = x, 1 = y, 2 = z).
struct MotionStep {
    Affine before;
    Vec3 by{0.0};
    int axis = 0;
    double degrees = 0.0;

    /// Of the step alone, without `before`.
    Affine at(double s) const;
};

/// x -> last(step_n(.. step_1(x))), the steps as of time s. Without steps it stands still, and
/// `last` says nothing: where it stands is kept elsewhere.
struct MotionPath {
    std::vector<MotionStep> steps;
    Affine last;

    bool moves() const { return !steps.empty(); }
    Affine at(double s) const;
};

/// How something at `place` that moves by `inner` does in a frame at `frame` that moves by `outer`.
MotionPath compose(const MotionPath& outer, const Affine& frame, const MotionPath& inner,
                   const Affine& place);

}  // namespace rt
