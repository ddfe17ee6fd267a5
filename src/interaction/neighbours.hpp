#pragma once

#include <cstdint>
#include <vector>

#include "base/vec2.hpp"
#include "grid/lattice.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// The bounding box of an outline. Not `usable`: a position is not finite, or the cell is many
/// boxes long; such a cell has no neighbours, and the guards report it.
struct Bounds {
    Vec2 low, high;
    bool usable = false;
};
Bounds bounds_of(const Outline& outline, const Lattice& lattice);

/// Another cell, or an image of one, that may be near: its nodes plus `shift` lie beside ours.
struct Neighbour {
    int cell = 0;
    Vec2 shift;  ///< whole periods
};

/// Cells sorted by the place of their bounding boxes, to find neighbours at a cost linear in the
/// number of cells.
class CellBins {
public:
    /// Sorts the cells. Allocates only where there are more cells or bins than ever before.
    void sort(const Lattice& lattice, const std::vector<Bounds>& bounds, double reach);

    /// Every image of every cell whose box comes within reach of the box of `cell`, by cell and
    /// shift: an order that does not depend on the bins. A cell's own images count, itself does
    /// not.
    void near(int cell, std::vector<Neighbour>& result) const;

    const Bounds& bounds(int cell) const { return bounds_[cell]; }

private:
    int bin_along(double at, double period, int count) const;
    void add_images(int cell, int other, std::vector<Neighbour>& result) const;

    Lattice lattice_;
    std::vector<Bounds> bounds_;
    double reach_ = 0.0;
    int nx_ = 1, ny_ = 1;
    std::vector<std::int32_t> first_;  ///< of each bin in cells_
    std::vector<std::int32_t> cells_;
    std::vector<std::int32_t> bin_;  ///< of each cell; −1: unusable
};

}  // namespace tt
