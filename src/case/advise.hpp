#pragma once

#include <vector>

#include "case/appraise.hpp"
#include "case/case.hpp"
#include "case/choose.hpp"
#include "observe/checks.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Beyond, the error of compressibility, of order Ma², passes a tenth.
inline constexpr double mach_limit = 2.0 * largest_mach;

/// What the numbers of an appraisal, its own advice apart, ask the user to write.
std::vector<Advice> advice_on(const Case& c, const Choice& choice, const Model& model,
                              const State& initial, const Appraisal& a);

}  // namespace tt
