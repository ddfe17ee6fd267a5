#pragma once

#include <variant>

namespace tt {

/// f_i^eq = w_i [ δρ + 3 u·c_i ]: Stokes flow. No u² terms, no u·F terms; with it the Reynolds number may be raised
/// without the advection term ever appearing.
struct LinearEquilibrium {};

/// f_i^eq = w_i [ δρ + 3 u·c_i + 9/2 (u·c_i)² − 3/2 u² ] (He and Luo 1997): Navier–Stokes, momentum ρ₀u with ρ₀ = 1.
struct IncompressibleEquilibrium {};

/// f_i^eq = w_i ρ [ 1 + 3 u·c_i + 9/2 (u·c_i)² − 3/2 u² ]: Eq. 2 of the paper; one division a site more.
struct FullEquilibrium {};

using Equilibrium = std::variant<LinearEquilibrium, IncompressibleEquilibrium, FullEquilibrium>;

}  // namespace tt
