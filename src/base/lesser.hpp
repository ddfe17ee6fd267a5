#pragma once

#include "base/isa.hpp"

namespace tt {

/// Smaller and larger of two numbers, by value: std::min and std::max return references, which
/// keeps loops of them from becoming vector code.
TT_INLINE double lesser(double a, double b) { return b < a ? b : a; }
TT_INLINE double greater(double a, double b) { return a < b ? b : a; }

}  // namespace tt
