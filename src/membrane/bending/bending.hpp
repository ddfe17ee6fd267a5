#pragma once

#include <variant>

#include "membrane/bending/current_curvature.hpp"
#include "membrane/bending/reference_curvature.hpp"

namespace tt {

/// The bending laws: how the moment at a node follows from the outline's turning there.
using Bending = std::variant<CurrentCurvature, ReferenceCurvature>;

}  // namespace tt
