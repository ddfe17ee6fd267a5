#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// Triangles (as numbers of corners) that fill a simple polygon given counter-clockwise, convex or
/// not: n − 2 of them, by cutting ears. One that crosses itself gets n − 2 triangles too, which
/// then overlap. O(n²), more for spirals.
std::vector<std::array<int, 3>> triangulate(std::span<const Vec2> polygon);

}  // namespace tt
