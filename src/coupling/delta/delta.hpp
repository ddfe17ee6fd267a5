#pragma once

#include <variant>

#include "coupling/delta/cosine4.hpp"
#include "coupling/delta/hat2.hpp"
#include "coupling/delta/peskin4.hpp"
#include "coupling/delta/roma3.hpp"

namespace tt {

/// The discrete delta kernels, each a product of one weight function per axis. Given the offset r ∈
/// [points/2 − 1, points/2) of a node from the first of the `points` sites it reaches,
/// `weights(r, w, slope)` sets the weights of four sites from that one on and their derivatives by
/// r (scaled where Σ slope · distance is not 1, so that both are exact for linear fields).
///
/// The 4-point kernels weigh even and odd sites alike, Σ_even w = Σ_odd w and Σ_even slope = Σ_odd
/// slope = 0. This matters: a lattice Boltzmann fluid conserves the momentum (−1)^{x+t} u as well,
/// undamped but for the walls, and a coupling that sees it can feed it. hat2 and roma3 lack the
/// property; that nodes move with the mean of two steps (simulation/advance.cpp) keeps it from
/// them.
using Delta = std::variant<Cosine4, Hat2, Roma3, Peskin4>;

}  // namespace tt
