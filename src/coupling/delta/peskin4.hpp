#pragma once

#include <cmath>
#include <string_view>

#include "base/isa.hpp"
#include "coupling/delta/kernel_spread.hpp"

namespace tt {

/// Peskin's 4-point kernel (Acta Numerica 2002, Eq. 6.27): sums to 1, first moment 0, even and odd
/// sites weigh alike.
struct Peskin4 {
    static constexpr std::string_view name = "peskin4";
    static constexpr KernelSpread spread{0.4293, 0.3588, 0.0955, 0.108, 0.3665};
    static constexpr int points = 4;
    TT_INLINE static void weights(double r, double (&w)[4], double (&slope)[4]) {
        const double s = r - 1.0;
        const double root = std::sqrt(1.0 + 4.0 * s * (1.0 - s));
        const double turn = (0.25 - 0.5 * s) / root;
        slope[0] = -0.25 - turn;
        slope[1] = -0.25 + turn;
        slope[2] = 0.25 + turn;
        slope[3] = 0.25 - turn;
        w[0] = 0.125 * (3.0 - 2.0 * s - root);
        w[1] = 0.125 * (3.0 - 2.0 * s + root);
        w[2] = 0.125 * (1.0 + 2.0 * s + root);
        w[3] = 0.125 * (1.0 + 2.0 * s - root);
    }
    friend bool operator==(const Peskin4&, const Peskin4&) = default;
};

}  // namespace tt
