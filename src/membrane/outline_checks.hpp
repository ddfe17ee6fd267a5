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

/// A node that comes near a segment of the same outline.
struct SelfApproach {
    int node = 0;
    int segment = 0;
};

/// The first node that is nearer than `reach` to a segment from which it is more than four times as
/// far, and two nodes at least, along the outline; nothing if there is none. Linear, but for
/// sorting. Precondition: evenly spaced nodes, positions finite.
std::optional<SelfApproach> self_approach(const Outline& outline, double reach);

}  // namespace tt
