#pragma once

#include <string_view>
#include <variant>

#include "base/vec2.hpp"
#include "grid/d2q9.hpp"

namespace tt {

/// f_i^eq = w_i [ δρ + 3 u·c_i ]: Stokes flow. No u² terms, no u·F terms; with it the Reynolds
/// number may be raised without the advection term ever appearing.
struct LinearEquilibrium {
    static constexpr std::string_view name = "linear";
    friend bool operator==(const LinearEquilibrium&, const LinearEquilibrium&) = default;
};

/// f_i^eq = w_i [ δρ + 3 u·c_i + 9/2 (u·c_i)² − 3/2 u² ] (He and Luo 1997): Navier–Stokes, momentum
/// ρ₀u with ρ₀ = 1.
struct IncompressibleEquilibrium {
    static constexpr std::string_view name = "incompressible";
    friend bool operator==(const IncompressibleEquilibrium&,
                           const IncompressibleEquilibrium&) = default;
};

/// f_i^eq = w_i ρ [ 1 + 3 u·c_i + 9/2 (u·c_i)² − 3/2 u² ]: Eq. 2 of the paper; one division more.
struct FullEquilibrium {
    static constexpr std::string_view name = "full";
    friend bool operator==(const FullEquilibrium&, const FullEquilibrium&) = default;
};

using Equilibrium = std::variant<LinearEquilibrium, IncompressibleEquilibrium, FullEquilibrium>;

/// c_i · v.
constexpr double along(int i, Vec2 v) { return d2q9::cx[i] * v.x + d2q9::cy[i] * v.y; }

/// f_i^eq − w_i for density deviation δρ = ρ − 1 and velocity u; the formulas stand at the types.
inline double population(LinearEquilibrium, int i, double density_deviation, Vec2 u) {
    return d2q9::weight[i] * (density_deviation + 3.0 * along(i, u));
}
inline double population(IncompressibleEquilibrium, int i, double density_deviation, Vec2 u) {
    const double cu = along(i, u);
    return d2q9::weight[i] * (density_deviation + 3.0 * cu + 4.5 * cu * cu - 1.5 * dot(u, u));
}
inline double population(FullEquilibrium, int i, double density_deviation, Vec2 u) {
    const double cu = along(i, u);
    const double density = 1.0 + density_deviation;
    return d2q9::weight[i] *
           (density_deviation + density * (3.0 * cu + 4.5 * cu * cu - 1.5 * dot(u, u)));
}

/// Velocity that belongs to momentum Σ f c + ½F (Eq. 4).
inline Vec2 velocity(LinearEquilibrium, double, Vec2 momentum) { return momentum; }
inline Vec2 velocity(IncompressibleEquilibrium, double, Vec2 momentum) { return momentum; }
inline Vec2 velocity(FullEquilibrium, double density_deviation, Vec2 momentum) {
    return momentum / (1.0 + density_deviation);
}

/// Guo's forcing term before the factor (1 − ω/2) (Eq. 3, corrected):
/// w_i [ 3 (c_i − u) + 9 (c_i·u) c_i ] · F; in Stokes flow w_i 3 c_i·F.
inline double forcing(LinearEquilibrium, int i, Vec2, Vec2 force) {
    return d2q9::weight[i] * 3.0 * along(i, force);
}
template <class OtherEquilibrium>
double forcing(OtherEquilibrium, int i, Vec2 u, Vec2 force) {
    return d2q9::weight[i] *
           (3.0 * (along(i, force) - dot(u, force)) + 9.0 * along(i, u) * along(i, force));
}

}  // namespace tt
