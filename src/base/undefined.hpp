#pragma once

#include <limits>

namespace tt {

/// Where there is no number: a mean of nothing, a ratio to what is not there. Files hold an empty
/// field, null or NaN in its place, as their format has it.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace tt
