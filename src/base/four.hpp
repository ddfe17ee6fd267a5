#pragma once

#include <cstring>

#include "base/isa.hpp"

namespace tt {

/// Two, four and eight numbers side by side: of doubles one SSE, AVX or AVX-512 register each or
/// several smaller ones, of floats half as much. Arithmetic is per element, so the bits are those
/// of scalar code. For the four-site rows of the delta kernels, which are too short for the
/// compiler to find.
template <class Real>
struct SideBySide;
template <>
struct SideBySide<double> {
    using Four = double __attribute__((vector_size(32)));
    using Eight = double __attribute__((vector_size(64)));
};
template <>
struct SideBySide<float> {
    using Four = float __attribute__((vector_size(16)));
    using Eight = float __attribute__((vector_size(32)));
};
template <class Real>
using Four = typename SideBySide<Real>::Four;
template <class Real>
using Eight = typename SideBySide<Real>::Eight;

template <class Real>
TT_INLINE Four<Real> load_four(const Real* p) {
    Four<Real> v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

template <class Real>
TT_INLINE void store_four(Real* p, const Four<Real>& v) {
    std::memcpy(p, &v, sizeof v);
}

template <class Vector>
TT_INLINE auto both(const Vector& low, const Vector& high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
template <class Vector>
TT_INLINE Vector swapped(const Vector& v) {
    return __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
}

/// (v₀ + v₁) + (v₂ + v₃) of the halves a, b of ab and c, d of cd, as (a, c, b, d): fewer steps than
/// four sums of their own.
template <class Vector>
TT_INLINE auto sums_of(const Vector& ab, const Vector& cd) {
    const Vector pairs =  // a₀₁ c₀₁ a₂₃ c₂₃ b₀₁ d₀₁ b₂₃ d₂₃
        __builtin_shufflevector(ab, cd, 0, 8, 2, 10, 4, 12, 6, 14) +
        __builtin_shufflevector(ab, cd, 1, 9, 3, 11, 5, 13, 7, 15);
    return __builtin_shufflevector(pairs, pairs, 0, 1, 4, 5) +
           __builtin_shufflevector(pairs, pairs, 2, 3, 6, 7);
}

}  // namespace tt
