#pragma once

#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "geometry/loops.hpp"

namespace tt {

/// Where the ports of a case lie in what is drawn [m], in their order.
struct PortPlaces {
    std::vector<Opening> openings;
    /// Ports that lie nowhere, and why; their opening is a point.
    std::vector<std::pair<std::string, std::string>> faults;
};
PortPlaces port_places(const Case& c);

inline double width_of(const Opening& opening) { return norm(opening.to - opening.from); }

}  // namespace tt
