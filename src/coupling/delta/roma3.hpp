#pragma once

#include <cmath>
#include <string_view>

#include "base/isa.hpp"
#include "coupling/delta/kernel_spread.hpp"

namespace tt {

/// The 3-point kernel of Roma, Peskin and Berger (1999): φ(r) = (1 + √(1 − 3r²))/3 for |r| ≤ ½,
/// (5 − 3|r| − √(1 − 3(1 − |r|)²))/6 for ½ ≤ |r| ≤ 3/2.
struct Roma3 {
    static constexpr std::string_view name = "roma3";
    static constexpr KernelSpread spread{0.333, 0.3057, 0.122, 0.100, 0.479};
    static constexpr int points = 3;
    TT_INLINE static void weights(double r, double (&w)[4], double (&slope)[4]) {
        const double d = r - 1.0;  // from the middle site, which is the nearest
        const double root = std::sqrt(1.0 - 3.0 * d * d);
        const double turn = 0.5 * d / root;
        slope[0] = turn - 0.5;
        slope[1] = -2.0 * turn;
        slope[2] = turn + 0.5;
        slope[3] = 0.0;
        w[0] = (1.0 / 6.0) * (2.0 - 3.0 * d - root);
        w[1] = (1.0 / 3.0) * (1.0 + root);
        w[2] = (1.0 / 6.0) * (2.0 + 3.0 * d - root);
        w[3] = 0.0;
    }
    friend bool operator==(const Roma3&, const Roma3&) = default;
};

}  // namespace tt
