// The vector types of the project: GLM's, in double precision.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace rt {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

/// Linear image values by channel; 0 is black, 1 is full, more is allowed.
using Color = glm::dvec3;

/// Position of something in one of the flat arrays that descriptions and scenes are made of.
using Index = std::uint32_t;
inline constexpr Index kNone = 0xffffffffu;

}  // namespace rt
