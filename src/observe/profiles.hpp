#pragma once

#include <vector>

#include "observe/measures.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Share of each row's centre line that lies inside a cell, from the outlines themselves, not from
/// the smoothed fraction of cytoplasm: Σ_cells (length of the line inside)/nx. Exact for the
/// polygons; the mean over rows is the tube hematocrit to second order (midpoint rule).
std::vector<double> hematocrit_profile(const Lattice& lattice, const Suspension& cells);

/// Both profiles at this step; row j stands (j + ½) sites above the bottom.
Profiles measure_profiles(const Model& model, const State& state);

}  // namespace tt
