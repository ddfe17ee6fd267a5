#pragma once

#include <cmath>
#include <string_view>

#include "base/isa.hpp"

namespace tt {

/// The 3D neo-Hookean membrane in uniaxial tension (Eq. 10 of the paper): T(λ) = E_s (λ³ −
/// 1)/λ^{3/2}. Small strains: T = 3 E_s (λ − 1). Energy per rest length W = E_s (2/5 λ^{5/2} + 2
/// λ^{−1/2} − 12/5).
struct NeoHookean {
    static constexpr std::string_view name = "neo-hookean";
    double shear_modulus = 0.0;  ///< E_s

    TT_INLINE double tension(double stretch) const {
        const double root = std::sqrt(stretch);
        return shear_modulus * (stretch * root - 1.0 / (stretch * root));
    }
    TT_INLINE double slope(double stretch) const {
        const double root = std::sqrt(stretch);
        return 1.5 * shear_modulus * (root + 1.0 / (stretch * stretch * root));
    }
    double energy(double stretch) const {
        return shear_modulus * (0.4 * std::pow(stretch, 2.5) + 2.0 / std::sqrt(stretch) - 2.4);
    }
    friend bool operator==(const NeoHookean&, const NeoHookean&) = default;
};

}  // namespace tt
