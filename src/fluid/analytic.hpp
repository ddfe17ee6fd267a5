#pragma once

#include <cmath>
#include <complex>

#include "base/vec2.hpp"

/// Exact solutions of plane flow, in any consistent units. y runs from the wall at 0 to the wall at
/// `height`.
namespace tt::analytic {

/// Flow between plates that move with speeds u_b and u_t: u = u_b + (u_t − u_b) y/H.
inline double couette(double y, double height, double bottom_speed, double top_speed) {
    return bottom_speed + (top_speed - bottom_speed) * y / height;
}

/// Flow between resting plates driven by a force per volume g: μ u″ = −g, so u = g y (H − y)/(2μ).
inline double poiseuille(double y, double height, double viscosity, double force) {
    return force * y * (height - y) / (2.0 * viscosity);
}

/// Womersley flow between resting plates: a force per mass g sin ωt has, long after its start,
/// u = Im [g/(iω) (1 − cosh(λ (y − H/2))/cosh(λ H/2)) e^{iωt}], λ² = iω/ν.
inline double womersley(double y, double height, double kinematic_viscosity, double force,
                        double angular_frequency, double time) {
    const std::complex<double> i(0.0, 1.0), at = i * angular_frequency;
    const std::complex<double> wave = std::sqrt(at / kinematic_viscosity);
    const std::complex<double> across =
        1.0 - std::cosh(wave * (y - 0.5 * height)) / std::cosh(0.5 * wave * height);
    return (force / at * across * std::exp(at * time)).imag();
}

/// Two layers of dynamic viscosities μ_b (0 ≤ y ≤ a) and μ_t (a ≤ y ≤ H) between plates.
struct TwoLayers {
    double height;
    double interface;         ///< a
    double bottom_viscosity;  ///< μ_b
    double top_viscosity;     ///< μ_t
};

/// Plates at rest below and moving with U above: the shear stress τ is uniform,
/// τ (a/μ_b + (H − a)/μ_t) = U; u = τ y/μ_b below the interface, U − τ (H − y)/μ_t above it.
inline double couette(double y, const TwoLayers& layers, double top_speed) {
    const double stress = top_speed / (layers.interface / layers.bottom_viscosity +
                                       (layers.height - layers.interface) / layers.top_viscosity);
    if (y <= layers.interface) return stress * y / layers.bottom_viscosity;
    return top_speed - stress * (layers.height - y) / layers.top_viscosity;
}

/// Both plates at rest, force per volume g: the shear stress is τ₀ − g y and
///
///     u = (τ₀ y − g y²/2)/μ_b  below,   u = (g (H² − y²)/2 − τ₀ (H − y))/μ_t  above the interface;
///
/// u is continuous there if τ₀ (a/μ_b + (H − a)/μ_t) = g/2 (a²/μ_b + (H² − a²)/μ_t).
inline double poiseuille(double y, const TwoLayers& layers, double force) {
    const double a = layers.interface;
    const double h = layers.height;
    const double wall_stress =
        0.5 * force * (a * a / layers.bottom_viscosity + (h * h - a * a) / layers.top_viscosity) /
        (a / layers.bottom_viscosity + (h - a) / layers.top_viscosity);
    if (y <= a) return (wall_stress * y - 0.5 * force * y * y) / layers.bottom_viscosity;
    return (0.5 * force * (h * h - y * y) - wall_stress * (h - y)) / layers.top_viscosity;
}

/// Taylor–Green vortices of wave numbers k, q at time t, exact for Stokes and Navier–Stokes flow:
///
///     u = U (−cos kx sin qy, (k/q) sin kx cos qy) exp(−ν (k² + q²) t).
inline Vec2 taylor_green(Vec2 x, Vec2 wave_number, double speed, double kinematic_viscosity,
                         double time) {
    const double k = wave_number.x;
    const double q = wave_number.y;
    const double now = speed * std::exp(-kinematic_viscosity * (k * k + q * q) * time);
    return {-now * std::cos(k * x.x) * std::sin(q * x.y),
            now * k / q * std::sin(k * x.x) * std::cos(q * x.y)};
}

/// Its pressure in Navier–Stokes flow, p = −¼ ρ U² (cos 2kx + (k/q)² cos 2qy) exp(−2ν (k² + q²) t);
/// zero in Stokes flow.
inline double taylor_green_pressure(Vec2 x, Vec2 wave_number, double speed,
                                    double kinematic_viscosity, double time) {
    const double k = wave_number.x;
    const double q = wave_number.y;
    const double now = speed * std::exp(-kinematic_viscosity * (k * k + q * q) * time);
    return -0.25 * now * now *
           (std::cos(2.0 * k * x.x) + k * k / (q * q) * std::cos(2.0 * q * x.y));
}

}  // namespace tt::analytic
