#include "report/triangulate.hpp"

#include <algorithm>
#include <numeric>

namespace tt {
namespace {

/// What is left of the polygon while ears are cut.
struct Rest {
    std::span<const Vec2> points;
    std::vector<int> corners;

    int at(std::size_t k) const { return corners[k % corners.size()]; }
    std::array<int, 3> corner(std::size_t k) const {
        return {at(k + corners.size() - 1), at(k), at(k + 1)};
    }
    /// Twice the area, negative at a hollow corner.
    double area(const std::array<int, 3>& t) const {
        return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    }
    bool contains(const std::array<int, 3>& t, Vec2 p) const {
        for (int side = 0; side < 3; ++side) {
            const Vec2 from = points[t[side]], to = points[t[(side + 1) % 3]];
            if (cross(to - from, p - from) < 0.0) return false;
        }
        return true;
    }
    bool is_ear(std::size_t k) const {
        const std::array<int, 3> t = corner(k);
        if (area(t) <= 0.0) return false;
        return std::none_of(corners.begin(), corners.end(), [&](int c) {
            return c != t[0] && c != t[1] && c != t[2] && contains(t, points[c]);
        });
    }
};

}  // namespace

std::vector<std::array<int, 3>> triangulate(std::span<const Vec2> polygon) {
    Rest rest{polygon, std::vector<int>(polygon.size())};
    std::iota(rest.corners.begin(), rest.corners.end(), 0);
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t k = 0, refused = 0; rest.corners.size() > 2;) {
        // None is left of a polygon that crosses itself, or whose points lie on a line: cut anyhow.
        if (refused < rest.corners.size() && !rest.is_ear(k)) {
            ++refused;
            k = (k + 1) % rest.corners.size();
            continue;
        }
        triangles.push_back(rest.corner(k));
        rest.corners.erase(rest.corners.begin() + static_cast<std::ptrdiff_t>(k));
        refused = 0;
        k = (k + 1) % rest.corners.size();  // not its neighbour at once: fans make slivers
    }
    return triangles;
}

}  // namespace tt
