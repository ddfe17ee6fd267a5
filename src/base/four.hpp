#pragma once

#include <cstring>

#include "base/isa.hpp"

namespace tt {

/// Four doubles side by side: one AVX register, or two SSE ones. Arithmetic is per element, so the
/// bits are those of scalar code. For the four-site rows of the delta kernels, which are too short
/// for the compiler to find.
using Four = double __attribute__((vector_size(32)));

TT_INLINE Four load_four(const double* p) {
    Four v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

TT_INLINE void store_four(double* p, const Four& v) { std::memcpy(p, &v, sizeof v); }

/// (v₀ + v₁) + (v₂ + v₃) of each of four: fewer steps than four sums of their own.
TT_INLINE Four sums_of(const Four& a, const Four& b, const Four& c, const Four& d) {
    const Four ab_first = __builtin_shufflevector(a, b, 0, 4, 2, 6);   // a₀ b₀ a₂ b₂
    const Four ab_second = __builtin_shufflevector(a, b, 1, 5, 3, 7);  // a₁ b₁ a₃ b₃
    const Four cd_first = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Four cd_second = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    const Four ab = ab_first + ab_second;  // a₀₁ b₀₁ a₂₃ b₂₃
    const Four cd = cd_first + cd_second;
    return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) +
           __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

}  // namespace tt
