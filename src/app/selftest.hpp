#pragma once

#include <span>

#include "verify/selftest.hpp"

namespace tt {

/// Runs the parts and prints a line a check; with `json` a list of objects instead. A part that
/// ends in an error counts as a check that failed. Exit code 0 if every check passed, 1 otherwise.
int run_selftest(std::span<const SelftestPart> parts, bool json);

}  // namespace tt
