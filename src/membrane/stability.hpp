#pragma once

namespace tt {

/// Bounds of the explicit membrane terms, in lattice units (site spacing, step and density 1). Each
/// is the number that must stay below its limit; limits are those seen in runs
/// (docs/theory/time-step.md).

/// Tension: a site-sized wiggle of a membrane of tension slope T'(1) relaxes at the rate T'/(μ h),
/// μ the mean of the viscosities on both sides; per step T'/ν. A relaxing cell (radius 10 sites,
/// peskin4, τ = 1.5) ran at 1.2 and blew up at 1.35 at viscosity ratio 1, ran at 1.25 and blew up
/// at 1.5 at ratio 5.
constexpr double tension_step_number(double tension_slope, double viscosity) {
    return tension_slope / viscosity;
}
inline constexpr double tension_step_limit = 1.2;

/// Bending: the same wiggle relaxes at E_b/(μ h³).
constexpr double bending_step_number(double modulus, double viscosity) {
    return modulus / viscosity;
}
inline constexpr double bending_step_limit = 2.0;

/// Area pressure: k_p against K_b = μ/((τ − ½) Δt), what the compressibility of the lattice fluid
/// can answer in a step. In lattice units K_b = ν/(3ν) = 1/3 whatever τ.
constexpr double area_step_number(double area_stiffness) { return 3.0 * area_stiffness; }
inline constexpr double area_step_limit = 7.0;

}  // namespace tt
