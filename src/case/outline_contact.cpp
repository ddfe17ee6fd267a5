#include "case/outline_contact.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"

namespace tt {
namespace {

/// Squared distance of a point to each edge; returns how often a ray from it to the right crosses
/// the outline.
TT_CLONES int measure_edges(const Edges& outline, double px, double py, double* distance2) {
    const double *x = outline.x, *y = outline.y, *ex = outline.edge_x, *ey = outline.edge_y;
    const double* inverse = outline.inverse;
    int crossings = 0;
#pragma omp simd reduction(+ : crossings)
    for (int k = 0; k < outline.count; ++k) {
        const double ax = x[k] - px, ay = y[k] - py, by = ay + ey[k];
        const double place = -(ax * ex[k] + ay * ey[k]) * inverse[k];
        const double positive = place > 0.0 ? place : 0.0;
        const double along = positive < 1.0 ? positive : 1.0;
        const double dx = ax + along * ex[k], dy = ay + along * ey[k];
        distance2[k] = dx * dx + dy * dy;
        const bool spans = (ay > 0.0) != (by > 0.0);
        const bool to_the_right = (ax * ey[k] - ay * ex[k] > 0.0) == (by > ay);
        crossings += static_cast<int>(spans) & static_cast<int>(to_the_right);
    }
    return crossings;
}

}  // namespace

std::optional<Push> push_from(const Edges& outline, Vec2 point, double gap) {
    double distance2[Edges::most];
    const bool inside = measure_edges(outline, point.x, point.y, distance2) % 2 != 0;
    const auto nearest =
        static_cast<int>(std::min_element(distance2, distance2 + outline.count) - distance2);
    if (!inside && distance2[nearest] >= gap * gap) return std::nullopt;
    const Vec2 from = outline.node(nearest), edge = outline.edge(nearest);
    const double along = std::clamp(dot(point - from, edge) * outline.inverse[nearest], 0.0, 1.0);
    const Vec2 apart = point - from - along * edge;
    const double distance = norm(apart);
    // On the outline itself the line between the two points has no direction; its normal has.
    const bool on = distance < 1e-6 * gap;
    const Vec2 normal = turned_right(edge) / norm(edge);
    const Vec2 outward = on ? normal : (inside ? -1.0 : 1.0) / distance * apart;
    return Push{nearest, along, (inside ? -gap - distance : distance - gap) * outward};
}

}  // namespace tt
