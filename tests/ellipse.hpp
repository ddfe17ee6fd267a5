#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "base/vec2.hpp"

namespace tt::test {

inline constexpr double pi = std::numbers::pi;

struct Ellipse {
    Vec2 centre;
    double major = 1.0;
    double minor = 1.0;
    double inclination = 0.0;

    /// Point at parameter θ: a cos θ along the long axis, b sin θ across it.
    Vec2 at(double theta) const {
        const double c = std::cos(inclination), s = std::sin(inclination);
        const Vec2 p{major * std::cos(theta), minor * std::sin(theta)};
        return centre + Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
    }
    /// `count` nodes at evenly spaced θ, the first at `start`.
    std::vector<Vec2> nodes(int count, double start = 0.0) const {
        std::vector<Vec2> points;
        for (int k = 0; k < count; ++k) points.push_back(at(start + 2.0 * pi * k / count));
        return points;
    }
};

}  // namespace tt::test
