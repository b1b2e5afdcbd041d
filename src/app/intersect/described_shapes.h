// Shapes that the compiler makes from what a script describes: meshes, height fields, and solids
// that combine others.
#pragma once

#include "rt/trace/shape.h"
#include "words.h"

namespace rt {

/// V, F, V corners, and F times three numbers of corners, from 0.
Shape readMesh(Words& in);
/// Columns, rows, heights row by row; then 0, or 1 and the base.
Shape readHeightField(Words& in);
/// `union N SOLID...`, `intersection N SOLID...` or `difference N SOLID...`. A SOLID is one of
/// these, a kind with its parameters, or `at M SOLID`: placed by a map of 12 numbers.
Shape readCombined(Words& in);

}  // namespace rt
