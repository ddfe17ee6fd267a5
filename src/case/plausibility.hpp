#pragma once

#include <vector>

#include "case/appraise.hpp"

namespace tt {

/// Numbers far from those of the field, each told with its usual range: a factor of 1000 in a unit
/// is caught here. Nothing of it is wrong for certain.
std::vector<Advice> implausible_numbers(const Case& c, const Choice& choice, const Appraisal& a);

}  // namespace tt
