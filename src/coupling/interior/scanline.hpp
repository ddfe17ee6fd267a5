#pragma once

#include <string_view>

#include "coupling/patch.hpp"

namespace tt {

/// Which sites lie inside a cell, by scan lines: where a segment passes a line of sites, all sites
/// beyond it change sides. The lines run along y, which turns the sum along them into additions of
/// whole rows. Exact for every outline without self-crossings; on others the result is the winding
/// number.
struct ScanLine {
    static constexpr std::string_view name = "scan-line";
    /// Adds 1 to the sites of `patch` (zero before) inside the outline.
    void operator()(const LocalOutline& outline, Patch& patch) const;
    friend bool operator==(const ScanLine&, const ScanLine&) = default;
};

}  // namespace tt
