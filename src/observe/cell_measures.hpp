#pragma once

#include <span>
#include <vector>

#include "membrane/outline.hpp"
#include "observe/measures.hpp"
#include "observe/plasma_map.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// All measures of all cells at this step, SI (docs/theory/analysis.md), in the order of their
/// numbers. `phase` is left 0: it is the time integral of phase_rate, which the series observer
/// keeps. NaN stands for what is not defined: wall_distance without walls, stress_traction and its
/// G* where no node's outside can be sampled, G* of a rigid body, the
/// inclination of a circle. Precondition: all positions are finite (`health`
/// looks first).
std::vector<CellMeasures> measure_cells(const Model& model, const State& state);

/// The same for one cell; `measure_cells` is cheaper for many, as they share one PlasmaMap.
CellMeasures measure_cell(const Model& model, const State& state, int cell);
CellMeasures measure_cell(const Model& model, const State& state, const PlasmaMap& plasma,
                          int cell);

/// Rate of the tank-treading phase: the mean over nodes of ((r − r_c) × (v − v_c))/|r − r_c|² with
/// the centroid r_c of the area and its velocity v_c; positive counter-clockwise, so negative in u
/// = k y.
///
/// In steady tank-treading its mean over nodes is exactly 2π/T, whatever the shape. The fraction is
/// dθ/dt of a node's polar angle, whose time mean over a period T in which the node goes round once
/// is 2π/T. All nodes run through the same motion, delayed, and nodes evenly spaced in rest length
/// are delayed evenly; so the mean over nodes at one instant is the mean of one node over a period
/// (a trapezoidal sum of a periodic function: the error falls faster than any power of their
/// number). Precondition: the centroid lies inside the outline, which fails only in a strongly
/// folded cell.
double tank_treading_rate(const Outline& outline, std::span<const double> ux,
                          std::span<const double> uy);

}  // namespace tt
