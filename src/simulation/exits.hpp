#pragma once

#include <cstdint>
#include <vector>

#include "base/vec2.hpp"
#include "grid/lattice.hpp"

namespace tt {

struct Model;
struct State;
struct Suspension;

/// A port as cells meet it. Lattice units.
struct Exit {
    Vec2 from, to;      ///< its ends
    Vec2 out;           ///< direction out of the channels
    double fade = 0.0;  ///< way over which a cell loses its forces; 0: fluid comes in here
};

/// A cell that has left.
struct Departed {
    std::int64_t id = 0, exit = 0, kind = 0;
    double time = 0.0;      ///< [steps]; no whole number once the time step has changed
    double place = 0.0;     ///< of its middle along the port
    double lambda_C = 1.0;  ///< as it left, forces faded
    double speed = 0.0;     ///< through the port
    double area = 0.0;
    std::vector<double> rest_length;  ///< of its segments
};

/// Of a delta kernel, in sites: nearer to a port a node feels what is beyond it.
inline constexpr double kernel_reach = Lattice::halo;

/// How far along a port a point is: from its lower or left end, whichever way round it was drawn.
double place_along(const Exit& exit, Vec2 point);

/// How far the foremost node of a cell is from an exit that it is before; infinite where it is not.
double way_to(const Exit& exit, const Model& model, const Suspension& cells, int cell);

/// A cell that nears a port where fluid leaves loses its forces over the last stretch, linearly
/// with the way of its foremost node: it goes on as fluid does, and the flow does not feel it go.
/// The uniform pressure at a port would squeeze a cell that has its forces. Team function, by
/// cells.
void fade_forces(const Model& model, Suspension& cells);

/// Takes out the cells that have come within the reach of a kernel of a port, and notes each, but
/// not those that are led. Between steps, one thread; true if any left.
bool release_cells(const Model& model, State& state);

}  // namespace tt
