#pragma once

#include <vector>

#include "base/vec2.hpp"
#include "fluid/equilibrium.hpp"
#include "fluid/populations.hpp"
#include "grid/field.hpp"

namespace tt {

/// Density deviation, momentum Σ f c (without ½F) and the second moment of one site.
struct Moments {
    double density_deviation = 0.0;
    Vec2 momentum;
    double xx = 0.0, xy = 0.0, yy = 0.0;  ///< Σ (f − w) c c
};

/// Moments of the populations arriving at site (i, j). In phase odd the halo must be filled
/// (`settle` leaves it so).
template <class Real>
Moments moments(const Populations<Real>& populations, int i, int j);

/// Density deviations of the sites of row j, those of `moments`.
template <class Real>
std::vector<double> density_deviations(const Populations<Real>& populations, int j);

/// Sets every site to the equilibrium of the given velocity (zero: at rest) and density deviation.
/// Phase even. Serial.
template <class Real>
void set_equilibrium(const Equilibrium& equilibrium, const VectorField<>& velocity,
                     const Field<>& density, Populations<Real>& populations);

}  // namespace tt
