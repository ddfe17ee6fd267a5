#pragma once

#include "membrane/suspension.hpp"

namespace tt {

/// Viscosities of a membrane, of which the state keeps tension and moment. Lattice units.
struct MembraneViscosity {
    double stretching = 0.0;  ///< η_m: tension η_m e, e the rate at which a segment stretches
    double bending = 0.0;     ///< η_b: moment η_b dω/ds, ω the rate at which a segment turns

    explicit operator bool() const { return stretching > 0.0 || bending > 0.0; }
};

/// Adds to the node forces of a cell those of its membrane's viscosity, T t and q n of tension T
/// and moment m (Kelvin–Voigt: beside the elastic ones). The velocities are those of the last step,
/// and forces made of them outright would feed on themselves from step to step. So T and m are
/// state, and each step they change by dT of (1 + η_m p D Dᵀ) dT = η_m e − T, with D Dᵀ the rate of
/// stretching that the tension makes if a force per length moves a node with the mobility p = (τ +
/// ½)/μ of the plasma, and m likewise with (1 − √(η_b p) Δ)², which is no less than its operator.
/// At rest T = η_m e and m = η_b dω/ds whatever p, which only sets a delay of some steps. Neither
/// limits the time step (docs/theory/membrane-viscosity.md). Forces and torques sum to zero.
void add_viscous_forces(const MembraneViscosity& viscosity, double plasma, Suspension& cells,
                        int cell);

/// Power that a cell's membrane turns into heat, Σ (T²/η_m + m²/η_b) ds.
double viscous_dissipation(const MembraneViscosity& viscosity, const Suspension& cells, int cell);

}  // namespace tt
