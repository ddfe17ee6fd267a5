#pragma once

#include <optional>

#include "membrane/suspension.hpp"

namespace tt {

/// Two segments of one outline that cut or touch each other, by their first nodes, first < second.
/// Two nodes at one place are told as the segments that start at them.
struct SelfCrossing {
    int first = 0;
    int second = 0;
};

/// One crossing, the same for the same outline; nothing for a simple one. Segments that share a
/// node do not count, except where they fold back onto each other. By a sweep over the nodes from
/// left to right, in which only segments that are neighbours along the sweep line are compared
/// (Shamos and Hoey 1976): n log n for any outline. Positions are rounded to 2⁻²⁹ of the outline's
/// size, on which all decisions are exact. Allocates; for guards, not for every step. Precondition:
/// positions are finite.
std::optional<SelfCrossing> self_crossing(const Outline& outline);

}  // namespace tt
