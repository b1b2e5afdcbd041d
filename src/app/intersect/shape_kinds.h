// What a question of the program `intersect` may be asked of, and how it is read.
#pragma once

#include "rt/trace/shape.h"
#include "words.h"

#include <span>
#include <string>

namespace rt {

struct ShapeKind {
    const char* name;
    /// Throws std::invalid_argument or rt::Error for what is no such shape.
    Shape (*read)(Words& in);
    bool hasMinimum;  ///< the question ends in tmin
};

std::span<const ShapeKind> shapeKinds();
/// nullptr where there is none of that name.
const ShapeKind* shapeKindNamed(const std::string& name);

}  // namespace rt
