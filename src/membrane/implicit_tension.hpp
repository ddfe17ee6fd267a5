#pragma once

#include "membrane/suspension.hpp"

namespace tt {

/// m for fluids of this mean viscosity. c must be at least of the order of what a node answers its
/// own load with at once, c_f of the jump correction and 1/(4 π); the larger it is, the more is
/// stable, and results do not depend on it.
constexpr double tension_mobility(double viscosity) {
    constexpr double c = 1.0;
    return c / viscosity;
}

/// Answers the coming move x → x + u at once with the tension that it makes, which the force on the
/// fluid, made of the positions before, would only do in the next step: u' = u + m J u', J u the
/// change of a step of the nodes' tension forces when they move with u, and m the `mobility`, the
/// velocity that the force of a node gives it (docs/theory/implicit-tension.md). Forces stay as
/// they are; the velocities change by differences along the outline, so that neither their sum nor
/// their moment changes, and by nothing where the cell moves as a rigid body. Precondition:
/// `stiffness` is that of the positions.
void answer_with_tension(double mobility, Suspension& cells, int cell);

}  // namespace tt
