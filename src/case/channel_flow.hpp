#pragma once

#include <array>
#include <string_view>

#include "base/quantity.hpp"
#include "case/case.hpp"

namespace tt {

/// The keys of [flow] of which a channel needs exactly one.
inline constexpr std::array<std::string_view, 6> channel_flow_keys{
    "pseudo_shear_rate", "mean_velocity", "largest_velocity",
    "flow_rate",         "wall_stress",   "pressure_gradient"};

/// The pseudo-shear rate k = U/H of the flow of plasma alone, by whichever key is given: for plane
/// Poiseuille flow the mean velocity is U = k H, the largest 3/2 U, the flow rate per depth U H,
/// the stress on the walls 6 μ k and the pressure gradient 12 μ k/H. Negative: to the left. Zero if
/// none is given.
Rate pseudo_shear_rate(const Case& c);

}  // namespace tt
