#pragma once

#include "verify/experiment.hpp"

namespace tt {

/// Largest error of the velocity / largest velocity, of a channel `height` sites wide that started
/// at rest, driven by a body force (`by_pressure_ends`: by the pressure ends) to its steady state.
/// Exact with Λ = 3/16 whatever the viscosity (docs/theory/fluid.md).
enum class DrivenBy { body_force, pressure_ends };
double poiseuille_error(int height, double viscosity, DrivenBy drive);

/// The same of two layers of viscosities 0.1 and 0.5 under a moving wall, which meet half-way
/// between rows of sites.
double two_layer_couette_error();

/// What is left of the kinetic energy of Taylor–Green vortices in `size` × `size` sites, Stokes
/// flow, when e^{−2} of it should be; second order in 1/size.
double taylor_green_energy(int size);

}  // namespace tt
