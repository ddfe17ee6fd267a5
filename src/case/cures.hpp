#pragma once

#include <vector>

#include "case/case.hpp"
#include "observe/remedy.hpp"

namespace tt {

/// What may keep a case from blowing up without changing what it asks for, the likeliest first: a
/// coupling without the correction of the jump where the viscosities differ much, cells whose area
/// is held, shorter time steps at the same relaxation time. On `threads` threads.
std::vector<Remedy> cures(const Case& c, int threads);

}  // namespace tt
