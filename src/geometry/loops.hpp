#pragma once

#include <array>
#include <utility>
#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// A closed polygon; the last point joins the first. Either way round.
using Loop = std::vector<Vec2>;

/// A piece of a loop that fluid passes, straight and along an axis.
struct Opening {
    Vec2 from, to;
    friend bool operator==(const Opening&, const Opening&) = default;
};

/// What is solid in the plane: by the even–odd rule what an odd number of loops goes around, or,
/// where `outside`, what an even number does. Any one unit of length. Where a period is not 0 the
/// same loops stand again at all its multiples.
struct Solid {
    std::vector<Loop> loops;
    bool outside = false;
    double period_x = 0.0, period_y = 0.0;
    std::vector<Opening> openings = {};  ///< in the loops

    bool empty() const { return loops.empty(); }
    friend bool operator==(const Solid&, const Solid&) = default;
};

/// The same in another unit, `factor` times as large in numbers.
Solid scaled(Solid solid, double factor);
/// The same moved.
Solid moved(Solid solid, Vec2 by);

/// Lowest and highest corner of all loops; of none the origin.
struct Corners {
    Vec2 low, high;
};
Corners corners_of(const std::vector<Loop>& loops);

/// The loops of what is solid in the box [0, width] × [0, height], those of periodic images that
/// reach into it too: by the even–odd rule, with the box itself as one where fluid is inside.
std::vector<Loop> solid_loops(const Solid& solid, double width, double height);

/// One straight piece of a loop, in an image that reaches into the box it was made for.
struct WallSegment {
    Vec2 from, to;
    int loop = 0;
    int opening = -1;  ///< that it is part of; else −1
};

/// All pieces of the loops that come within `reach` of the box [0, width] × [0, height], those of
/// periodic images included. Where two loops meet along an edge the edge bounds nothing and is left
/// out: the rectangles that chip files are made of are one piece.
std::vector<WallSegment> segments_near(const Solid& solid, double width, double height,
                                       double reach);

/// Where the loops cross the line y, sorted by x; between the first and the second is inside.
/// Points on the line count as above it, so that each loop is crossed an even number of times.
/// Twins of `segments_near` with enough reach.
std::vector<double> crossings_of_row(const std::vector<WallSegment>& segments, double y);

/// Where there is fluid on a line along an axis, along y at x = `at` where `upright`: intervals of
/// the other coordinate, in order. Beyond the walls of a box, y < 0 and y > `height`, is none where
/// `walled`. Infinite ends are those of a line that no wall ends.
struct OpenPiece {
    double begin, end;
};
std::vector<OpenPiece> open_pieces(const Solid& solid, Vec2 box, bool walled, bool upright,
                                   double at);

/// Share of the way from a to b, in [0, 1], at which it first meets the segment; negative if it
/// does not. Parallel ones do not meet.
double meeting(Vec2 a, Vec2 b, const WallSegment& segment);

/// The point of the segment nearest to `point`.
Vec2 nearest_on(const WallSegment& segment, Vec2 point);

}  // namespace tt
