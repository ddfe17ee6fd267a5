#pragma once

#include "membrane/suspension.hpp"

namespace tt {

/// A body that keeps its shape: free to move and to turn, filled with a fluid of the plasma's
/// density and viscosity. In the place of a membrane's forces a traction λ along its outline makes
/// the fluid there move as the body does (docs/theory/rigid-bodies.md). It is state, and each step
/// it changes by
///
///     dλ = (U + Ω × r − u)/p,   p = (τ + ½)/μ,
///
/// u the velocity of the nodes as sampled, U and Ω those of the rigid motion nearest to it, p the
/// mobility by which a load per length moves a node. A uniform pressure is left out, which a closed
/// outline does not feel. Forces and torques of λ sum to zero, so that the inertia is that of the
/// fluid within; and as the body turns λ turns with it, so that they stay zero. No limit of the
/// time step comes of it.

/// Sets the node forces of one cell to λ ds.
void set_rigid_forces(Suspension& cells, int cell);

/// Takes the sampled velocities of one cell's nodes to those of the nearest rigid motion, least
/// squares weighted by arc length, and λ along; `mobility` is p. Then moves the nodes by it,
/// exactly turned.
void move_rigidly(double mobility, Suspension& cells, int cell);

}  // namespace tt
