#pragma once

#include <optional>
#include <string>

#include "case/case.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Tension at which the membrane of a red cell bursts, 6.5 mN/m: the order of Evans et al. (1976),
/// who found 10 mN/m.
inline constexpr double lysis_tension = 6.5e-3;

/// Why the state cannot be started from, and what to write: contact presses membranes that lie well
/// within its zero_force_distance with more than a cell bears, lysis_tension over its radius.
std::optional<std::string> bursting_contact(const Case& c, const Model& model,
                                            const State& initial);

}  // namespace tt
