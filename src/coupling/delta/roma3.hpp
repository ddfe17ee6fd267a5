#pragma once

#include <algorithm>
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
    TT_INLINE static void weights(double s, double (&w)[4], double (&slope)[4]) {
        // Distance d ∈ [−½, ½] to the nearest site, which is the second one or the third.
        const bool second = s < 0.5;
        const double d = second ? s : s - 1.0;
        const double root = std::sqrt(1.0 - 3.0 * d * d);
        const double centre = (1.0 + root) / 3.0;
        const double before = (2.0 - 3.0 * d - root) / 6.0;  // site at distance 1 + d
        const double after = (2.0 + 3.0 * d - root) / 6.0;   // site at distance 1 − d
        const double turn = 0.5 * d / root;
        slope[0] = second ? turn - 0.5 : 0.0;
        slope[1] = second ? -2.0 * turn : turn - 0.5;
        slope[2] = second ? turn + 0.5 : -2.0 * turn;
        slope[3] = second ? 0.0 : turn + 0.5;
        w[0] = second ? before : 0.0;
        w[1] = second ? centre : before;
        w[2] = second ? after : centre;
        w[3] = second ? 0.0 : after;
    }
};

}  // namespace tt
