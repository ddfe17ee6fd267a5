#pragma once

#include <algorithm>

#include "membrane/forces.hpp"

namespace tt {

// Bounds of the explicit membrane terms. Each number must stay below its limit; limits are those
// seen in runs (docs/theory/time-step.md). A hardened membrane is stiffer the more it is stretched:
// the moduli that enter are those at the largest stretch expected.

/// Stretch λ ≥ 1 at which the hardened tension T(λ) α(λ) reaches `tension`, at most 3; 1 for a law
/// whose tension does not grow from zero.
double stretch_at(const Membrane& membrane, double tension);

/// Largest slope d(T α)/dλ of the in-plane law for 1 ≤ λ ≤ `stretch`, in the unit of its modulus;
/// the tension itself where that is larger, as in a drop.
double tension_slope(const Membrane& membrane, double stretch);

/// E_b, times α(`stretch`) if bending hardens.
double bending_modulus(const Membrane& membrane, double stretch);

/// k_p, times α(`stretch`) if the area pressure hardens.
double area_stiffness(const Membrane& membrane, double stretch);

/// Tension: a site-sized wiggle of a membrane of tension slope T' relaxes at the rate T'/(μ h), μ
/// the mean of the viscosities on both sides; T' Δt/(μ h). A relaxing cell without hardening
/// (radius 10 sites, peskin4, τ = 1.5) ran at 1.2 and blew up at 1.35 at viscosity ratio 1, ran
/// at 1.25 and blew up at 1.5 at ratio 5; with roma3 it ran at 1.5 at both. A hardened cell in
/// shear, with T' at the largest stretch that it came to, ran at 1.06 and blew up at 1.4 and
/// at 1.6. Beyond τ = 1.5 what counts is that stress follows τ − ½ steps late: at τ = 3, 10 and 20
/// the relaxing cell ran where (τ − ½) T' Δt/(μ h) was 1 and blew up at 1.4. Twelve hardened cells
/// in a channel, over 40 ms, two seeds: ran up to 1.6 and blew up at 2.4, one of them late.
constexpr double tension_step_number(double slope, double viscosity, double relaxation_time,
                                     double step, double spacing) {
    return std::max(1.0, relaxation_time - 0.5) * slope * step / (viscosity * spacing);
}
inline constexpr double tension_step_limit = 1.2;

/// The same number with implicit tension (docs/theory/implicit-tension.md).
inline constexpr double implicit_tension_step_limit = 3.5;

/// Bending: the same wiggle relaxes at E_b/(μ h³), μ of the thinner fluid. A cell in a channel
/// (radius 5.4 sites, E_b = 1e-15 J) ran at 1.5 at viscosity ratios 0.25, 1, 5, 20 and 100, at 1.9
/// at ratio 1, and blew up at 2.4 at ratio 5.
constexpr double bending_step_number(double modulus, double viscosity, double step,
                                     double spacing) {
    return modulus * step / (viscosity * spacing * spacing * spacing);
}
inline constexpr double bending_step_limit = 1.5;

/// Area pressure: k_p against μ/((τ − ½) Δt), what the compressibility of the lattice fluid can
/// answer in a step. Without hardening 30 ran and 40 blew up, of a cell in shear and of two in a
/// channel; hardened, with α about 3.5 at the cells' stretch, 31 ran and 49 blew up. A cell whose
/// area is held (membrane/area.hpp) has no such bound: k_p from 1 Pa to 400 kPa, 660 times μ/((τ −
/// ½) Δt), gave the same results.
constexpr double area_step_number(double stiffness, double viscosity, double relaxation_time,
                                  double step) {
    return stiffness * (relaxation_time - 0.5) * step / viscosity;
}
inline constexpr double area_step_limit = 30.0;

/// Two thirds of it, for cells of this radius [sites]: less below 13, as the same pressure changes
/// the area of a small cell by more. Of 5.4 sites, in shear, 5 and 8 ran, 10 and 16 blew up.
constexpr double safe_area_step_number(double radius) {
    constexpr double large = 13.0;
    const double share = radius < large ? radius / large : 1.0;
    return 2.0 / 3.0 * area_step_limit * share * share;
}

}  // namespace tt
