#pragma once

#include <string_view>

#include "coupling/patch.hpp"

namespace tt {

/// Which sites lie inside a cell, by the flood fill of the paper (its reference 27): start outside
/// and walk from site to site; a step over the membrane changes sides. The border is kept as the
/// set of cut links between neighbouring sites, not as marked sites, so that shapes thinner than a
/// site spacing do not close or leak. Slower than ScanLine and its oracle.
struct FloodFill {
    static constexpr std::string_view name = "flood-fill";
    /// Sets the sites of `patch` inside the outline to 1. Allocates.
    void operator()(const LocalOutline& outline, Patch& patch) const;
    friend bool operator==(const FloodFill&, const FloodFill&) = default;
};

}  // namespace tt
