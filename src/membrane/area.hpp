#pragma once

#include "membrane/suspension.hpp"

namespace tt {

/// Keeps the area of a cell. The interpolated node velocities are not quite divergence-free, and
/// the lattice fluid is slightly compressible, so that a cell leaks: by some 10⁻⁸ of its area a
/// step, 2·10⁻³ in 10⁵ steps. Changes its node velocities by the least (Σ |δu|²) with which the
/// coming move x → x + u leaves the cell with the area A it has, less 1/1000 of A − A_ref: by δu =
/// −c ∂A/∂x, an outward normal velocity, the same on evenly spaced nodes, of about 10⁻⁷ sites a
/// step. Area pressure (Eq. 14) stays; it carries what the constraint would otherwise ask of the
/// fluid at once. Precondition: `area` is that of the positions.
void hold_area(Suspension& cells, int cell);

}  // namespace tt
