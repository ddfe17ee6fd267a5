#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Gives a state that was made with another time step the units of `model`, whose step is `ratio`
/// times as long and whose relaxation time is the same. What is measured in SI stays: positions,
/// velocities, forces, pressure and stress.
///
/// At one relaxation time the density scale goes with the time step, so that one factor does it.
/// Velocity: u → r u. Force density: S ρ Δx/Δt² is its unit, so F → r F; pressure likewise. Stress:
/// the non-equilibrium part of the populations is τ times the rate of strain, so f − f^eq → r (f −
/// f^eq) about the equilibrium of the new density and velocity. Without advection all of that is
/// one multiplication, and exact.
///
/// The step becomes the whole number of new steps nearest to its time: at most half of one off.
/// Precondition: the halo of the populations is filled; what is derived is not looked at.
void change_time_step(const Model& model, double ratio, State& state);

}  // namespace tt
