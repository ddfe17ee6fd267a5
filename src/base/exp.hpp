#pragma once

#include <bit>
#include <cstdint>

#include "base/isa.hpp"

namespace tt {

/// e^x for |x| ≤ 700 (clamped beyond), without a branch or a call, so that a loop of it becomes
/// vector code with the same bits at every vector width. x = k ln 2 + r, |r| ≤ ½ ln 2, Taylor
/// polynomial of degree 13 in r: within 3 ulp.
TT_INLINE double vector_exp(double x) {
    constexpr double shift =
        0x1.8p52;  // adding it rounds to an integer that then sits in the low bits
    const double bounded = x > 700.0 ? 700.0 : (x < -700.0 ? -700.0 : x);
    const double shifted = bounded * 1.4426950408889634 + shift;
    const double k = shifted - shift;
    const double r = (bounded - k * 0x1.62e42fefa3800p-1) - k * 0x1.ef35793c76730p-45;
    double p = 1.0 / 6227020800.0;
    p = p * r + 1.0 / 479001600.0;
    p = p * r + 1.0 / 39916800.0;
    p = p * r + 1.0 / 3628800.0;
    p = p * r + 1.0 / 362880.0;
    p = p * r + 1.0 / 40320.0;
    p = p * r + 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    p = p * r + 1.0;
    p = p * r + 1.0;
    const std::uint64_t exponent = (std::bit_cast<std::uint64_t>(shifted) + 1023u) << 52;
    return p * std::bit_cast<double>(exponent);
}

}  // namespace tt
