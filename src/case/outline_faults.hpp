#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/vec2.hpp"

namespace tt {

/// The points of a file, no two neighbours at one place, and where each stands in it.
struct GivenPoints {
    std::vector<Vec2> points;
    std::vector<int> lines;    ///< empty: the file has none, and points are told by their number
    std::vector<int> numbers;  ///< of each point in the file, from 1
};

/// What makes an outline none of a cell: too few points, points on one line, a loop that is run
/// twice, or that crosses or touches itself, with both places. Nothing for a simple loop.
std::optional<Fault> outline_fault(const GivenPoints& given, const std::string& file);

}  // namespace tt
