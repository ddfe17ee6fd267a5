#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "membrane/forces.hpp"

namespace tt {

/// The undisturbed flow of a case, SI, whichever way it goes.
struct Undisturbed {
    Rate shear_rate;         ///< nominal k, or pseudo-shear rate
    Rate wall_rate;          ///< largest shear rate: k, or 6 k of a parabola
    Velocity largest_speed;  ///< at the walls, or in the middle
};

/// One reason for a time step no larger than `step`.
struct StepLimit {
    std::string name;    ///< "Reynolds number", "Mach number", …
    Time step;           ///< largest Δt it allows
    std::string reason;  ///< one line with the numbers
    double change = 0.0;  ///< of D, ε, λ_C or μ_rel that goes with `step`, and grows in proportion
                          ///< to Δt; 0: a limit of stability
};

/// A third of the limit of stability: cells make the flow faster here and there.
inline constexpr double auto_mach = 0.1;

/// Half of the limit of stability, in units of T' Δt/(μ Δx) and E_b Δt/(μ Δx³);
/// where τ is larger, five sixths of that of (τ − ½) T' Δt/(μ Δx). With implicit tension two
/// thirds.
inline constexpr double auto_tension_step_number = 0.6;
inline constexpr double auto_late_tension_step_number = 1.0;
inline constexpr double auto_implicit_tension_step_number = 2.5;
inline constexpr double auto_bending_step_number = 0.75;

/// Length of the cells that a case describes: radius of the circle of the stress-free area.
Length equivalent_radius(const Case& c);

/// Whether the flow carries cells along the lattice.
bool carries_cells(const Case& c);

/// The largest stretch that a membrane segment is expected to come to. Its tension is of the order
/// μ k a, k the largest shear rate of the undisturbed flow: in all runs of studies/time-step below
/// 3.5 E_s G^{4/5} with G = μ k a/E_s (shear, hardened or not, G 0.0125 to 0.2, viscosity ratio 1
/// and 5: 47 to 95 % of it; one and two cells in the channel 41 to 52 %, twelve 71 % at 50 /s and
/// 97 % at 500 /s). The stretch follows from the law, T(λ) α(λ). At rest: what the start stretches
/// it to.
double expected_stretch(const Case& c, const Undisturbed& flow, const Membrane& membrane);

/// That of a whole cell, λ_C: ε was 63 to 72 % of the largest of its segments; three quarters.
constexpr double expected_cell_stretch(double expected_stretch) {
    return 1.0 + 0.75 * (expected_stretch - 1.0);
}

/// The stretch to judge hardened bending and area at. Where tension does not harden too, its law
/// alone lets a cell go far beyond where they hold it, so that α(λ) there says nothing: at rest.
double stretch_of_hardened(const Membrane& membrane, double expected_stretch);

/// Time steps that each limit of `auto` allows at site spacing `dx` and relaxation time τ, the
/// tightest first. Limits of accuracy are proportional to numerics.step_tolerance, by the changes
/// measured in studies/time-step at τ from 0.75 to 4; limits of stability are not. At fixed τ, Δt ∝
/// S.
std::vector<StepLimit> step_limits(const Case& c, const Undisturbed& flow,
                                   const Equilibrium& equilibrium, Length dx, double tau,
                                   double stretch, const Membrane& membrane);

/// Of the limits of each kind of cells the tightest, in order. Whose it is, is told where it is not
/// the same for all.
std::vector<StepLimit> tightest_of_kinds(const std::vector<std::vector<StepLimit>>& of_kinds,
                                         const std::vector<KindCase>& kinds);

}  // namespace tt
