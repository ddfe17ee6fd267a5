#include "case/layout.hpp"

#include <cmath>

#include "base/random.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

/// Value at a share t ∈ [0, 1) of the way round of what is given at points evenly along it: the
/// cubic through the four nearest (Catmull and Rom 1974).
Vec2 along(const std::vector<Vec2>& values, double t) {
    const int count = static_cast<int>(values.size());
    const int k = static_cast<int>(t * count);
    const double s = t * count - k;
    const auto at = [&](int n) { return values[(n + count) % count]; };
    const Vec2 a = at(k - 1), b = at(k), c = at(k + 1), d = at(k + 2);
    return b +
           0.5 * s *
               ((c - a) + s * (2.0 * a - 5.0 * b + 4.0 * c - d) + s * s * (3.0 * (b - c) + d - a));
}

/// Moves all nodes along their normals until the outline encloses `area`.
void swell_to(double area, std::vector<Vec2>& outline) {
    const std::size_t count = outline.size();
    for (int round = 0; round < 3; ++round) {
        const double swell = (area - area_of(outline)) / perimeter_of(outline);
        const std::vector<Vec2> before = outline;
        for (std::size_t k = 0; k < count; ++k) {
            const Vec2 along = before[(k + 1) % count] - before[(k + count - 1) % count];
            outline[k] += swell / norm(along) * turned_right(along);
        }
    }
}

}  // namespace

double Crowd::area() const {
    double area = 0.0;
    for (int cell = 0; cell < count(); ++cell) area += area_of(shape(cell));
    return area;
}

std::vector<Vec2> placed(const std::vector<Vec2>& shape, const Placement& place) {
    if (place.bend.empty()) return placed(shape, place.angle, place.centre);
    std::vector<Vec2> bent = shape;
    const auto count = static_cast<double>(shape.size());
    for (std::size_t k = 0; k < shape.size(); ++k)
        bent[k] += along(place.bend, static_cast<double>(k) / count);
    swell_to(area_of(shape), bent);
    return placed(std::move(bent), place.angle, place.centre);
}

std::vector<Placement> two_rows(int count, double length, double width, double perturbation,
                                std::uint64_t seed) {
    Random random(seed);
    std::vector<Placement> cells;
    const int per_row = count / 2;
    for (int c = 0; c < count; ++c) {
        const Vec2 symmetric{(c % per_row + 0.5) * length / per_row,
                             c < per_row ? 0.25 * width : 0.75 * width};
        const double dx = random.uniform(-perturbation, perturbation);
        const double dy = random.uniform(-perturbation, perturbation);
        cells.push_back({symmetric + Vec2{dx, dy}, 0.0});
    }
    return cells;
}

}  // namespace tt
