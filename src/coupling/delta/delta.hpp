#pragma once

#include <variant>

#include "coupling/delta/cosine4.hpp"
#include "coupling/delta/hat2.hpp"
#include "coupling/delta/peskin4.hpp"
#include "coupling/delta/roma3.hpp"

namespace tt {

/// The discrete delta kernels, each a product of one weight function per axis. Given the offset s ∈ [0, 1) of a
/// node from the second of the four sites around it, `weights(s, w)` sets the weights of the sites at −1, 0, 1, 2.
using Delta = std::variant<Cosine4, Hat2, Roma3, Peskin4>;

}  // namespace tt
