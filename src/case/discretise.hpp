#pragma once

#include "case/case.hpp"
#include "case/choose.hpp"
#include "simulation/model.hpp"

namespace tt {

/// The one crossing from SI to lattice units: a validated case and the choices made for it become a
/// Model.
Model discretise(const Case& c, const Choice& choice);
inline Model discretise(const Case& c) { return discretise(c, choose(c)); }

}  // namespace tt
