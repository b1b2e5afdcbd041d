#include "rt/core/motion.h"

namespace rt {

Affine MotionStep::at(double s) const {
    return degrees == 0.0 ? Affine::translate(s * by) : Affine::rotate(axis, s * degrees);
}

Affine MotionPath::at(double s) const {
    Affine map;
    for (const MotionStep& step : steps) map = compose(step.at(s), compose(step.before, map));
    return compose(last, map);
}

MotionPath compose(const MotionPath& outer, const Affine& frame, const MotionPath& inner,
                   const Affine& place) {
    MotionPath path = inner;
    if (!outer.moves()) {
        if (path.moves()) path.last = compose(frame, path.last);
        return path;
    }
    const std::size_t first = path.steps.size();
    path.steps.insert(path.steps.end(), outer.steps.begin(), outer.steps.end());
    MotionStep& joint = path.steps[first];
    joint.before = compose(joint.before, inner.moves() ? inner.last : place);
    path.last = outer.last;
    return path;
}

}  // namespace rt
