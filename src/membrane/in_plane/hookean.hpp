#pragma once

#include <string_view>

#include "base/isa.hpp"

namespace tt {

/// A linear spring of the same small-strain modulus as Eq. 10: T(λ) = 3 E_s (λ − 1), W = 3/2 E_s (λ
/// − 1)².
struct Hookean {
    static constexpr std::string_view name = "hookean";
    double shear_modulus = 0.0;  ///< E_s

    TT_INLINE double tension(double stretch) const { return 3.0 * shear_modulus * (stretch - 1.0); }
    TT_INLINE double slope(double /*stretch*/) const { return 3.0 * shear_modulus; }
    double energy(double stretch) const {
        return 1.5 * shear_modulus * (stretch - 1.0) * (stretch - 1.0);
    }
    friend bool operator==(const Hookean&, const Hookean&) = default;
};

}  // namespace tt
