#pragma once

#include "verify/experiment.hpp"

namespace tt {

/// A two-dimensional drop: constant surface tension γ, no bending, viscosity r μ inside and μ
/// outside.
struct DropScene {
    double radius = 10.0;  ///< a [sites]
    double viscosity_ratio = 1.0;
    double box = 200.0;  ///< side of the square box, walls apart; rounded to sites
    double viscosity = 1.0 / 3.0;
    double node_distance = 0.5;  ///< of the circle [sites]
};

/// Pressure inside less pressure outside of a drop at rest, over γ/R with R the radius of the
/// circle of its present area: 1 by Laplace's law. The smeared force is the gradient of the smeared
/// step of pressure, so that the jump itself is not smeared away; what is left is the polygon and
/// the kernel's unequal response to directions.
struct LaplacePressure {
    double ratio = 0.0;          ///< Δp R/γ
    double spurious_flow = 0.0;  ///< largest μ u/γ left over
};
LaplacePressure laplace_pressure(double radius, double tension);

/// The time in which an outline r = a (1 + ε cos nθ), ε = 0.02, returns to the circle by a factor
/// e, over that of Stokes flow, 2 a (μ_in + μ_out)/(γ n). The creeping flow inside is ψ = (A rⁿ + B
/// rⁿ⁺²) sin nθ, outside ψ = (C r⁻ⁿ + E r⁻ⁿ⁺²) sin nθ; velocity and tangential stress are
/// continuous, the normal stress jumps by γ (n² − 1) ε/a² cos nθ, which leaves this time for every
/// n ≥ 2. Second order in n h/a: the kernel smooths the wave of force, and again that of velocity.
double relaxation_time_ratio(const DropScene& scene, int mode);

/// What a drop in simple shear does once steady, of capillary number Ca = μ k a/γ.
struct DropInShear {
    double taylor = 0.0;               ///< D of the inertia ellipse
    double inclination = 0.0;          ///< [rad]
    double intrinsic_viscosity = 0.0;  ///< (μ_rel − 1)/φ by the balance of stress
    double area_error = 0.0;
    double spacing_ratio = 0.0;  ///< longest / shortest segment
};
DropInShear drop_in_shear(const DropScene& scene, double capillary_number, double until_strain);

/// The same extrapolated to h/a → 0 and box → ∞, both errors being of second order (walls act by
/// (a/H)²), from drops of radius 7 and 14 sites in a box of 8 radii and of 7 sites in one of 16.
DropInShear drop_in_unbounded_shear(double viscosity_ratio, double capillary_number,
                                    double until_strain);

/// Small-deformation theory of a drop in unbounded shear: D = [Ca⁻² + (1 + r)²]^{−1/2}, the steady
/// state of a deformation that is driven at the rate k/(1 + r), relaxes at γ/(μ a (1 + r)) and is
/// turned with the vorticity.
double drop_deformation(double viscosity_ratio, double capillary_number);
/// (1 + 2r)/(1 + r) of a circular drop, the two-dimensional Taylor formula: 2 if rigid, 1 for a
/// bubble.
double drop_intrinsic_viscosity(double viscosity_ratio);

}  // namespace tt
