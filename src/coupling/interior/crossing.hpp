#pragma once

#include <cmath>

#include "base/vec2.hpp"

namespace tt {

/// A node position rounded to 2⁻²⁰ site (0.2 pm at h = 0.2 µm). Site centres lie on the same
/// raster, so for segments shorter than 64 sites every product below is exact in a double and the
/// answers contradict each other nowhere, not even for sites on the membrane.
inline double snapped(double v) {
    constexpr double shift = 0x1.8p32;
    return (v + shift) - shift;
}

/// Does a segment from coordinate a to b pass the line at c? Half-open, so that of two segments
/// that share a node on the line exactly one passes, or both or none where the outline turns back.
/// As if the line lay at c + 0.
inline bool passes(double a, double b, double c) { return (a <= c) != (b <= c); }

/// Is `p` above the segment a–b, given that the segment passes the column of p? A site on the
/// segment counts as above: sites are thought to lie at (x + ε², y + ε).
inline bool above(Vec2 a, Vec2 b, Vec2 p) {
    return a.x < b.x ? cross(b - a, p - a) >= 0.0 : cross(a - b, p - b) >= 0.0;
}

/// Is `p` to the right of the segment a–b, given that the segment passes the row of p? Same
/// convention: on the segment it is the upward shift ε that decides, unless the segment is
/// vertical.
inline bool right_of(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 low = a.y < b.y ? a : b;
    const Vec2 rise = a.y < b.y ? b - a : a - b;
    const double side = cross(rise, p - low);
    return side < 0.0 || (side == 0.0 && rise.x <= 0.0);
}

}  // namespace tt
