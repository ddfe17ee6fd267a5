#pragma once

#include <span>

#include "grid/lattice.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Width of the layer without cells at the bottom and at the top wall [sites]. NaN where it is not
/// defined: no cells, no walls.
struct CellFreeLayer {
    double bottom = 0.0;
    double top = 0.0;
    double mean() const { return 0.5 * (bottom + top); }
};

/// The definitions in use differ by a factor of two and more on one and the same flow
/// (docs/theory/analysis.md says who uses which), so each has its name and none is "the" layer.

/// Smallest distance of any membrane to the wall.
CellFreeLayer cfl_gap(const Lattice& lattice, const Suspension& cells);

/// Mean over the columns of sites of the distance from the wall to the first membrane met,
/// whichever cell it belongs to; where the polygon crosses the column's line, exactly. Columns that
/// no cell crosses are left out of the mean: they tell the spacing of cells, not their distance to
/// the wall.
CellFreeLayer cfl_envelope(const Lattice& lattice, const Suspension& cells);

/// Distance from the wall to where the hematocrit first reaches half of its maximum, linear between
/// the rows; H = 0 on the wall itself. Works for the profile of one time or of an average.
CellFreeLayer cfl_profile(std::span<const double> hematocrit);

/// What is left beside a core of uniform hematocrit max H that holds the same cells, each half of
/// the channel by itself: W/2 − ∫ H dy / max H.
CellFreeLayer cfl_core(std::span<const double> hematocrit);

}  // namespace tt
