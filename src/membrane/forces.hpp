#pragma once

#include "membrane/bending/bending.hpp"
#include "membrane/hardening.hpp"
#include "membrane/in_plane/in_plane.hpp"
#include "membrane/suspension.hpp"
#include "membrane/viscosity.hpp"

namespace tt {

/// The constitutive choice of a cell's membrane. Lattice units.
struct Membrane {
    InPlane in_plane;
    Bending bending;
    Hardening hardening;
    double area_stiffness = 0.0;  ///< k_p
    bool hold_area = false;       ///< membrane/area.hpp
    MembraneViscosity viscosity;
    double mobility = 0.0;  ///< m of membrane/implicit_tension.hpp; 0: tension is explicit
    bool rigid = false;     ///< membrane/rigid.hpp: none of the above acts
};

/// Sets fx, fy of a cell to the membrane forces of Eqs. 10–15, and the stiffness of each of its
/// segments, its area, perimeter and alpha.
void set_membrane_forces(const Membrane& membrane, Suspension& cells, int cell);

}  // namespace tt
