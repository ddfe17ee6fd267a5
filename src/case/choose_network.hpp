#pragma once

#include <vector>

#include "case/choose.hpp"
#include "fluid/ports.hpp"

namespace tt {

/// What the ports of a case hold, in units in which viscosity and site are 1 and speeds are in m/s.
std::vector<PortCondition> slow_ports(const Case& c, const Choice& choice, const Walls& walls);

/// Shear rate and speed of plasma alone between ports; of the ports the largest pseudo-shear rate.
Undisturbed choose_network_flow(const Case& c, Choice& choice);

}  // namespace tt
