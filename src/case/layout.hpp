#pragma once

#include <cstdint>
#include <vector>

#include "base/vec2.hpp"
#include "fluid/walls.hpp"
#include "grid/lattice.hpp"

namespace tt {

/// Where cells may be: a box, and the walls of any shape in it.
struct Room {
    Lattice box;
    const Walls* walls = nullptr;

    Room(const Lattice& b, const Walls* w = nullptr) : box(b), walls(w) {}
    /// Of what is open [sites].
    double area() const {
        return walls ? static_cast<double>(walls->open_sites())
                     : static_cast<double>(box.nx) * box.ny;
    }
};

/// Where a cell stands, how it is turned [rad], and how it is bent there.
struct Placement {
    Vec2 centre;
    double angle = 0.0;
    /// Displacements of points evenly along its outline, in its own frame; empty: as at rest.
    std::vector<Vec2> bend = {};
};

/// The outline `shape` (about the origin, nodes at equal arc length) at its place. One that is bent
/// keeps its area.
std::vector<Vec2> placed(const std::vector<Vec2>& shape, const Placement& place);

/// The paper's start: `count` cells (even) in two rows at a quarter and three quarters of the
/// width, evenly along the length, each shifted by up to ± perturbation in x and y to break the
/// symmetry.
std::vector<Placement> two_rows(int count, double length, double width, double perturbation,
                                std::uint64_t seed);

}  // namespace tt
