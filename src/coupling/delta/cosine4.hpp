#pragma once

#include <cmath>
#include <string_view>

#include "base/isa.hpp"
#include "coupling/delta/kernel_spread.hpp"

namespace tt {

/// The paper's kernel (Eq. 8 as corrected): φ(r) = ¼ (1 + cos(π r / 2)), |r| ≤ 2. The four points
/// are a quarter turn apart, so one sine and one cosine serve all. It sums to 1 exactly, but its
/// first moment does not vanish: up to 0.021 sites, so torque is conserved to 2 % of a site times
/// the force only. Peskin4 has no such defect.
struct Cosine4 {
    static constexpr std::string_view name = "cosine4";
    static constexpr KernelSpread spread{0.429, 0.359, 0.0965, 0.108, 0.3675};
    static constexpr int points = 4;
    TT_INLINE static void weights(double r, double (&w)[4], double (&slope)[4]) {
        const double s = r - 1.0;
        // sin(πs/2) and cos(πs/2) by their series about s = ½ (|x| ≤ π/4): error below 1e-15.
        const double x = 1.5707963267948966 * (s - 0.5);
        const double q = x * x;
        const double sine =
            x * (1.0 +
                 q * (-1.0 / 6 +
                      q * (1.0 / 120 + q * (-1.0 / 5040 + q * (1.0 / 362880 +
                                                               q * (-1.0 / 39916800 +
                                                                    q * (1.0 / 6227020800.0 -
                                                                         q / 1307674368000.0)))))));
        const double cosine =
            1.0 +
            q * (-1.0 / 2 +
                 q * (1.0 / 24 + q * (-1.0 / 720 +
                                      q * (1.0 / 40320 + q * (-1.0 / 3628800 +
                                                              q * (1.0 / 479001600.0 +
                                                                   q * (-1.0 / 87178291200.0)))))));
        const double half_root = 0.70710678118654752;
        const double sin_s = half_root * (sine + cosine);
        const double cos_s = half_root * (cosine - sine);
        // The derivatives, over Σ w' r = (π/4)(sin + cos) so as to be exact for a linear field.
        const double scale = 0.5 / (sin_s + cos_s);
        slope[0] = -scale * cos_s;
        slope[1] = -scale * sin_s;
        slope[2] = scale * cos_s;
        slope[3] = scale * sin_s;
        w[0] = 0.25 * (1.0 - sin_s);
        w[1] = 0.25 * (1.0 + cos_s);
        w[2] = 0.25 * (1.0 + sin_s);
        w[3] = 0.25 * (1.0 - cos_s);
    }
    friend bool operator==(const Cosine4&, const Cosine4&) = default;
};

}  // namespace tt
