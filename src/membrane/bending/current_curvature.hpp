#pragma once

#include <string_view>

#include "base/isa.hpp"

namespace tt {

/// Eq. 13 of the paper: m = E_b (κ − κ₀) with κ the curvature of the present outline, turning /
/// present arc length. With a tension that depends on the stretch alone this has no energy (∂m/∂λ ≠
/// ∂T/∂K); see docs/theory/membrane.md.
struct CurrentCurvature {
    static constexpr std::string_view name = "current";
    double modulus = 0.0;  ///< E_b

    /// `turning` 2 tan(θ/2) at the node, `arc` and `rest_arc` half the lengths of its two segments,
    /// `rest_curvature` κ₀.
    TT_INLINE double moment(double turning, double arc, double /*rest_arc*/,
                            double rest_curvature) const {
        return modulus * (turning / arc - rest_curvature);
    }
    friend bool operator==(const CurrentCurvature&, const CurrentCurvature&) = default;
};

}  // namespace tt
