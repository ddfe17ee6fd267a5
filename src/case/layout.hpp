#pragma once

#include <cstdint>
#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// Where a cell stands and how it is turned [rad].
struct Placement {
    Vec2 centre;
    double angle = 0.0;
};

/// The paper's start: `count` cells (even) in two rows at a quarter and three quarters of the
/// width, evenly along the length, each shifted by up to ± perturbation in x and y to break the
/// symmetry.
std::vector<Placement> two_rows(int count, double length, double width, double perturbation,
                                std::uint64_t seed);

/// Random without overlap: copies of `shape` (a closed outline about the origin) start small at
/// random places and angles, move by hard-particle Monte Carlo and grow to full size, keeping `gap`
/// to each other and to the walls; x is periodic. Returns fewer than `count` never; throws
/// CaseError naming the hematocrit reached if growth stalls.
std::vector<Placement> random_placements(const std::vector<Vec2>& shape, int count, double length,
                                         double width, double gap, std::uint64_t seed);

}  // namespace tt
