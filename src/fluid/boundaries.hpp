#pragma once

namespace tt {

/// What happens at the edges of the box. Lattice units. Where the lattice has no walls the wall speeds are unused.
struct Boundaries {
    double bottom_speed = 0.0;   ///< x velocity of the wall at y = 0
    double top_speed = 0.0;      ///< x velocity of the wall at y = ny
    double pressure_drop = 0.0;  ///< p(inlet) − p(outlet) between the periodic ends
};

}  // namespace tt
