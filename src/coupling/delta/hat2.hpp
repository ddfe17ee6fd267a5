#pragma once

#include <string_view>

#include "base/isa.hpp"
#include "coupling/delta/kernel_spread.hpp"

namespace tt {

/// The 2-point hat: φ(r) = 1 − |r|, bilinear interpolation.
struct Hat2 {
    static constexpr std::string_view name = "hat2";
    static constexpr KernelSpread spread{0.260, 0.2734, 0.154, 0.088, 0.65};
    static constexpr int points = 4;  // the outer two without weight
    TT_INLINE static void weights(double r, double (&w)[4], double (&slope)[4]) {
        const double s = r - 1.0;
        slope[0] = 0.0;
        slope[1] = -1.0;
        slope[2] = 1.0;
        slope[3] = 0.0;
        w[0] = 0.0;
        w[1] = 1.0 - s;
        w[2] = s;
        w[3] = 0.0;
    }
    friend bool operator==(const Hat2&, const Hat2&) = default;
};

}  // namespace tt
