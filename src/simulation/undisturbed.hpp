#pragma once

#include "fluid/walls.hpp"
#include "grid/field.hpp"

namespace tt {

/// The steady flow of plasma alone, without inertia, between walls of any shape, driven along x. In
/// units in which its mean velocity along x, over all of the box, is 1 and so is a site.
struct UndisturbedFlow {
    VectorField<> velocity;
    Field<> density;           ///< deviation times viscosity, p = ρ/3: what varies about the mean drop
    double conductance = 0.0;  ///< Q ν/g of flow rate and force; ny³/12 of a straight channel
    double fastest = 0.0;      ///< largest speed
    double steepest = 0.0;     ///< largest shear rate at the walls
};

/// Computes it on as many threads, from rest until the flow rate changes no more (to 10⁻⁵).
/// Fields are means of two steps, of which the lattice's staggered momentum is taken off.
UndisturbedFlow undisturbed_flow(const Walls& walls, int threads);

}  // namespace tt
