#include "membrane/area.hpp"

#include "base/parallel.hpp"

namespace tt {
namespace {

constexpr double share_of_error = 1e-3;  ///< of A − A_ref, undone per step

/// Outward normal of a node times its arc length: the derivative of the area by its position.
Vec2 area_gradient(const Suspension& s, int before, int next) {
    return 0.5 * turned_right(s.position(next) - s.position(before));
}

/// What the move x → x + u adds to the area of a cell, exactly: Σ u·∂A/∂x + ½ Σ u × u_next.
double area_of_move(const Suspension& s, int cell) {
    const int first = s.first[cell], last = s.first[cell + 1] - 1;
    double sum = 0.0;
    for (int k = first, before = last; k <= last; before = k++) {
        const int next = k < last ? k + 1 : first;
        const Vec2 u = s.velocity(k);
        sum += dot(u, area_gradient(s, before, next)) + 0.5 * cross(u, s.velocity(next));
    }
    return sum;
}

void hold_area(Suspension& s, int cell) {
    const int first = s.first[cell], last = s.first[cell + 1] - 1;
    const double excess =
        area_of_move(s, cell) + share_of_error * (s.area[cell] - s.reference_area[cell]);
    const double shift = excess / s.perimeter[cell];
    for (int k = first, before = last; k <= last; before = k++) {
        const Vec2 normal = area_gradient(s, before, k < last ? k + 1 : first);
        const double length = norm(normal);
        if (!(length > 0.0)) continue;
        s.ux[k] -= shift * normal.x / length;
        s.uy[k] -= shift * normal.y / length;
    }
}

}  // namespace

void hold_areas(Suspension& cells) {
    const auto [begin, end] = team_share(cells.cell_count());
    for (int cell = begin; cell < end; ++cell) hold_area(cells, cell);
    team_barrier();
}

}  // namespace tt
