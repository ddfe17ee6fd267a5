#pragma once

#include <optional>

#include "membrane/suspension.hpp"

namespace tt {

/// Two segments of one outline that cut each other, by their first nodes, first < second.
struct SelfCrossing {
    int first = 0;
    int second = 0;
};

/// The crossing with the lowest `first`, then the lowest `second`; nothing for a simple outline.
/// Segments that share a node do not count, except where they fold back onto each other. Sorted by
/// x, each segment is compared with those whose x range overlaps its own: n log n, plus the pairs
/// on opposite sides. Allocates; for guards, not for every step. Precondition: positions are
/// finite.
std::optional<SelfCrossing> self_crossing(const Outline& outline);

}  // namespace tt
