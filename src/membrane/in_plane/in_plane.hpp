#pragma once

#include <variant>

#include "membrane/in_plane/hookean.hpp"
#include "membrane/in_plane/neo_hookean.hpp"
#include "membrane/in_plane/skalak.hpp"
#include "membrane/in_plane/surface_tension.hpp"

namespace tt {

/// The in-plane laws. A new law is one header with `tension(λ)`, its `slope(λ)` and
/// `energy(λ)` plus its name here.
using InPlane = std::variant<NeoHookean, Hookean, Skalak, SurfaceTension>;

}  // namespace tt
