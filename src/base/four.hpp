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

TT_INLINE double sum_of(const Four& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace tt
