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

/// Two of them: one AVX-512 register, or two or four smaller ones.
using Eight = double __attribute__((vector_size(64)));

TT_INLINE Eight both(const Four& low, const Four& high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
TT_INLINE Eight swapped(const Eight& v) {
    return __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
}

/// (v₀ + v₁) + (v₂ + v₃) of the halves a, b of ab and c, d of cd, as (a, c, b, d): fewer steps than
/// four sums of their own.
TT_INLINE Four sums_of(const Eight& ab, const Eight& cd) {
    const Eight pairs =  // a₀₁ c₀₁ a₂₃ c₂₃ b₀₁ d₀₁ b₂₃ d₂₃
        __builtin_shufflevector(ab, cd, 0, 8, 2, 10, 4, 12, 6, 14) +
        __builtin_shufflevector(ab, cd, 1, 9, 3, 11, 5, 13, 7, 15);
    return __builtin_shufflevector(pairs, pairs, 0, 1, 4, 5) +
           __builtin_shufflevector(pairs, pairs, 2, 3, 6, 7);
}

}  // namespace tt
