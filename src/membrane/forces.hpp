#pragma once

#include "membrane/bending/bending.hpp"
#include "membrane/hardening.hpp"
#include "membrane/in_plane/in_plane.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// The constitutive choice of a cell's membrane. Lattice units.
struct Membrane {
    InPlane in_plane;
    Bending bending;
    Hardening hardening;
    double area_stiffness = 0.0;  ///< k_p
    bool hold_area = false;       ///< membrane/area.hpp
};

/// Sets fx, fy to the membrane forces of Eqs. 10–15, and area, perimeter and alpha of each cell.
/// Team function, by cells.
void set_membrane_forces(const Membrane& membrane, Suspension& cells);

}  // namespace tt
