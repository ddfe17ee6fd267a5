#pragma once

#include <memory>
#include <vector>

#include "fluid/populations.hpp"
#include "fluid/ports.hpp"
#include "fluid/walls.hpp"

namespace tt {

/// What happens at the edges of the box. Lattice units. Where the lattice has no walls the wall
/// speeds are unused.
struct Boundaries {
    double bottom_speed = 0.0;                ///< x velocity of the wall at y = 0
    double top_speed = 0.0;                   ///< x velocity of the wall at y = ny
    double pressure_drop = 0.0;               ///< p(inlet) − p(outlet) between the periodic ends
    std::shared_ptr<const Walls> walls = {};  ///< of any other shape; none: a straight channel
    std::vector<PortCondition> ports = {};    ///< of the openings of the walls
};

/// What the edges of the box add to the populations that just departed from row j, before the phase
/// flips. Local to the row, so the thread that passed the row does it.
///
/// - A population bounced back half-way by a wall that moves with u_w gains 2 w_i ρ₀ c_i·u_w / c_s²
///   (Ladd 1994), c_i being the direction it returns along, ρ₀ = 1. It conserves mass.
/// - A population that leaves through the outlet x = nx enters at the inlet with w_i Δρ more, Δρ =
///   Δp / c_s², and one that leaves through the inlet with as much less. What hits a wall at an end
///   belongs to the wall. Exact for the linear and the incompressible equilibrium. For the full one
///   it makes the momentum ρu periodic, not u: the velocity differs by the factor 1 + Δρ between
///   the ends, as it must if mass is conserved; against a body force the momentum then agrees to
///   Δρ², the velocity to Δρ/2 (tests/physics/pressure_ends.cpp).
template <class Real>
void finish_departures(const Boundaries& boundaries, Populations<Real>& populations, int j);

}  // namespace tt
