#pragma once

#include <string>
#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// The outline of a cell as it was read from a file, and what it was read from.
struct CellOutline {
    std::string file;   ///< as it was opened
    std::string bytes;  ///< its content
    /// [m], about the centroid of the area, counter-clockwise; a simple loop without its end.
    std::vector<Vec2> points;
    int given = 0;                     ///< points that the file holds
    bool closed = false;               ///< its last point is the first again
    bool clockwise = false;            ///< as it stands in the file
    bool staircase = false;            ///< all steps are along x or y: the edges of pixels
    std::vector<std::string> remarks;  ///< what the user should look at, and what to write

    friend bool operator==(const CellOutline&, const CellOutline&) = default;
};

/// What tells whether an outline was read as it was meant. SI.
struct OutlineMeasures {
    double width = 0.0, height = 0.0;  ///< extent along x and y
    double area = 0.0, perimeter = 0.0;
    double reduced_area = 0.0;  ///< 4 π A / L²: 1 for a circle
    double radius = 0.0;        ///< of the circle of the same area
};
OutlineMeasures measures_of(const CellOutline& outline);

/// Both in one line: "rbc.csv: 60 points, closed by the first again, …".
std::string description(const CellOutline& outline);

}  // namespace tt
