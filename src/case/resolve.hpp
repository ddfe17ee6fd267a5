#pragma once

#include <string>

#include "case/case.hpp"
#include "case/choose.hpp"
#include "simulation/model.hpp"

namespace tt {

/// resolved.toml: the case with every default, and what follows from it, in SI and lattice units,
/// as comments below. Reads back to the same Case, so that it runs again as it is.
std::string resolved_toml(const Case& c, const Choice& choice, const Model& model);

/// The part of a case that determines the states of a run; how often it is saved is none of it.
std::string identity_of(const Case& c);

}  // namespace tt
