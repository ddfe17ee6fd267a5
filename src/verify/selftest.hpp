#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tt {

/// One number held against what it must be.
struct Check {
    std::string what;
    double expected = 0.0;
    double got = 0.0;
    double tolerance = 0.0;

    /// Relative, or absolute where nothing is expected.
    double error() const { return expected == 0.0 ? got : got / expected - 1.0; }
    /// Written so that a NaN fails.
    bool passed() const { return error() <= tolerance && -error() <= tolerance; }
};

/// Scenes with an exact or a converged reference answer, each a second or so; the physics of this
/// very build. Tolerances are some two times the errors seen (docs/validation.md), which
/// resolution sets, and rounding where the lattice is exact.
struct SelftestPart {
    std::string_view name;
    std::vector<Check> (*run)();
};
std::span<const SelftestPart> selftest_parts();

}  // namespace tt
