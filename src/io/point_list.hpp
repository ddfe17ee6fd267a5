#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// Points of the plane from a text, in the unit of the text.
struct PointList {
    std::vector<Vec2> points;
    std::vector<int> lines;  ///< on which each point stands; empty: the file has no lines
    std::string unit;        ///< of the heading, "mm" of "X (mm),Y (mm)"; empty: none is named
    bool y_down = false;     ///< known to be so
};

/// Beyond these a file holds something else than an outline.
inline constexpr double largest_coordinate = 1e9;
inline constexpr std::size_t most_points = 100'000;

/// Reads x,y of one point a line as tables and programs write them: columns parted by commas, tabs
/// or spaces; line ends of any kind; a byte order mark; '#' starts a comment; a heading, which may
/// name x and y (or column and row) among other columns. Throws CaseError with the faults by line;
/// one fault alone where the whole text is of another kind (semicolons, decimal commas, UTF-16, no
/// text at all). `name` stands for the file, in which the text begins at `first_line`.
PointList parse_points(std::string_view text, const std::string& name, int first_line = 1);

}  // namespace tt
