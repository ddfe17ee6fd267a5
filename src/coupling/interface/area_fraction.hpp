#pragma once

#include <string_view>

#include "coupling/patch.hpp"

namespace tt {

/// The fraction of the unit square around a site that lies inside the outline, exact for the
/// polygon: the area under each segment is summed with its sign, square by square. Σ over sites =
/// area of the cell. Needs no interior method.
struct AreaFraction {
    static constexpr std::string_view name = "area-fraction";
    static constexpr double reach() { return 0.0; }

    template <class Interior>
    void operator()(const Interior&, const LocalOutline& outline, Patch& patch) const {
        cover(outline, patch);
    }
    /// Sets the fractions of `patch` (zero before).
    static void cover(const LocalOutline& outline, Patch& patch);
    friend bool operator==(const AreaFraction&, const AreaFraction&) = default;
};

}  // namespace tt
