#pragma once

#include <string_view>

#include "base/isa.hpp"

namespace tt {

/// m = E_b (K − κ₀) with K the turning per *rest* arc length: the hyperelastic rod, which has the
/// energy ∫ ½ E_b (K − κ₀)² ds₀. Equal to Eq. 13 where the membrane is unstretched.
struct ReferenceCurvature {
    static constexpr std::string_view name = "reference";
    double modulus = 0.0;  ///< E_b

    TT_INLINE double moment(double turning, double /*arc*/, double rest_arc,
                            double rest_curvature) const {
        return modulus * (turning / rest_arc - rest_curvature);
    }
    friend bool operator==(const ReferenceCurvature&, const ReferenceCurvature&) = default;
};

}  // namespace tt
