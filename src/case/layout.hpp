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

/// What is to be laid: outlines at rest (closed, about the origin, nodes at equal arc length), and
/// which of them each cell has.
struct Crowd {
    std::vector<std::vector<Vec2>> shapes;
    std::vector<int> shape_of;  ///< per cell

    Crowd() = default;
    /// All alike.
    Crowd(const std::vector<Vec2>& shape, int count)
        : shapes{shape}, shape_of(static_cast<std::size_t>(count), 0) {}
    int count() const { return static_cast<int>(shape_of.size()); }
    const std::vector<Vec2>& shape(int cell) const { return shapes[shape_of[cell]]; }
    /// The first so many of them.
    Crowd first(int count) const {
        Crowd fewer = *this;
        fewer.shape_of.resize(static_cast<std::size_t>(count));
        return fewer;
    }
    /// Of all cells together, at rest [sites].
    double area() const;
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
