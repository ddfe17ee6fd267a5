#pragma once

#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "case/centre_bins.hpp"
#include "case/layout.hpp"
#include "grid/lattice.hpp"

namespace tt {

/// Hard particles that grow: copies of outlines start small at random places and angles, move by
/// Monte Carlo and grow about their centres by a common factor, never nearer to each other and to
/// the walls than a gap.
class Growth {
public:
    /// Starts with all cells small.
    Growth(const Crowd& crowd, const Room& room, double gap, std::uint64_t seed);

    /// One trial move and turn of every cell; the step adapts so that about half are accepted.
    void sweep();

    /// Grows all cells by `factor` (at most to full size) if none then touches another.
    bool grow(double factor);

    /// Size of the cells, 1: full.
    double scale() const { return scale_; }
    const std::vector<Placement>& cells() const { return cells_; }

private:
    int count() const { return static_cast<int>(cells_.size()); }
    double reach() const { return scale_ * reach_; }  ///< of the largest
    double reach(int cell) const { return scale_ * reaches_[shape_of_[cell]]; }
    Placement random_placement(int cell);
    std::vector<Vec2> outline_of(int cell, const Placement& place) const;
    bool fits(int self, const Placement& cell, const std::vector<Vec2>& outline) const;
    bool clear_of(int self, int other, const Placement& cell,
                  const std::vector<Vec2>& outline) const;
    bool any_inside(const std::vector<Vec2>& outline, int other, const std::vector<Vec2>& others,
                    Vec2 centre, Vec2 shift) const;

    std::vector<std::vector<Vec2>> shapes_;  ///< of a few points
    std::vector<double> reaches_;            ///< of these, at full size
    std::vector<int> shape_of_;
    Lattice box_;
    const Walls* walls_;
    double gap_;
    Random random_;
    double scale_ = 0.2;
    double reach_ = 0.0;
    double step_ = 1.0;
    CentreBins bins_;
    std::vector<Placement> cells_;
    std::vector<std::vector<Vec2>> outlines_;
};

}  // namespace tt
