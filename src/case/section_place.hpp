#pragma once

#include <optional>

#include "case/case.hpp"

namespace tt {

/// Where a section lies [m], in the coordinates of the drawing.
struct SectionPlace {
    bool upright = true;            ///< along y
    double at = 0.0;                ///< the coordinate that is the same all along it
    double begin = 0.0, end = 0.0;  ///< of the other one
    bool backwards = false;         ///< its `from` is at `end`
};

/// Nothing where it is no line along an axis.
std::optional<SectionPlace> place_of(const SectionCase& section);

}  // namespace tt
