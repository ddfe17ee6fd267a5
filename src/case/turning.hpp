#pragma once

#include "base/vec2.hpp"

namespace tt {

/// `p` turned by the angle of `axis`, its cosine and sine.
inline Vec2 turned(Vec2 axis, Vec2 p) {
    return {axis.x * p.x - axis.y * p.y, axis.y * p.x + axis.x * p.y};
}
inline Vec2 turned_back(Vec2 axis, Vec2 p) { return turned({axis.x, -axis.y}, p); }
inline Vec2 turned_left(Vec2 p) { return {-p.y, p.x}; }

/// Turned on by an angle of about 2 t, exactly of unit length but for rounding.
inline Vec2 turned_on(Vec2 axis, double t) {
    const Vec2 spin = Vec2{1.0 - t * t, 2.0 * t} / (1.0 + t * t);
    const Vec2 on = turned(spin, axis);
    return on / norm(on);
}

}  // namespace tt
