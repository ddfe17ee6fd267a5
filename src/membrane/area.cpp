#include "membrane/area.hpp"

#include "base/four.hpp"
#include "base/isa.hpp"

namespace tt {
namespace {

constexpr double share_of_error = 1e-3;  ///< of A − A_ref, undone per step

/// One cell's nodes, 0 … count − 1.
struct Nodes {
    const double *x, *y;
    double *ux, *uy;
    int count;
};

/// ∂A/∂x of a node: half the way between its neighbours, turned outwards.
TT_INLINE Vec2 gradient(const Nodes& n, int before, int next) {
    return {0.5 * (n.y[next] - n.y[before]), 0.5 * (n.x[before] - n.x[next])};
}

/// What the move x → x + u adds to the area, exactly: Σ u·∂A/∂x + ½ Σ u × u_next; and Σ |∂A/∂x|².
struct Change {
    double area = 0.0, gradient2 = 0.0;

    TT_INLINE void add(const Nodes& n, int before, int k, int next) {
        const Vec2 u{n.ux[k], n.uy[k]}, u_next{n.ux[next], n.uy[next]};
        const Vec2 g = gradient(n, before, next);
        area += dot(u, g) + 0.5 * cross(u, u_next);
        gradient2 += dot(g, g);
    }
};

/// Four nodes at a time: one sum would wait for each of its terms.
TT_CLONES Change change_of_move(const Nodes& n) {
    const auto at = [](const double* p) TT_INLINE_LAMBDA { return load_four(p); };
    Four<double> area{}, gradient2{};
    int k = 1;
    for (; k + 4 < n.count; k += 4) {
        const Four<double> gx = 0.5 * (at(n.y + k + 1) - at(n.y + k - 1));
        const Four<double> gy = 0.5 * (at(n.x + k - 1) - at(n.x + k + 1));
        const Four<double> ux = at(n.ux + k), uy = at(n.uy + k);
        area += (ux * gx + uy * gy) + 0.5 * (ux * at(n.uy + k + 1) - uy * at(n.ux + k + 1));
        gradient2 += gx * gx + gy * gy;
    }
    Change sum{(area[0] + area[1]) + (area[2] + area[3]),
               (gradient2[0] + gradient2[1]) + (gradient2[2] + gradient2[3])};
    for (; k < n.count - 1; ++k) sum.add(n, k - 1, k, k + 1);
    sum.add(n, n.count - 1, 0, 1);
    sum.add(n, n.count - 2, n.count - 1, 0);
    return sum;
}

TT_INLINE void take_off_node(const Nodes& n, double factor, int before, int k, int next) {
    const Vec2 g = gradient(n, before, next);
    n.ux[k] -= factor * g.x;
    n.uy[k] -= factor * g.y;
}

TT_CLONES void take_off(const Nodes& nodes, double factor) {
    const Nodes n = nodes;
#pragma omp simd
    for (int k = 1; k < n.count - 1; ++k) take_off_node(n, factor, k - 1, k, k + 1);
    take_off_node(n, factor, n.count - 1, 0, 1);
    take_off_node(n, factor, n.count - 2, n.count - 1, 0);
}

}  // namespace

void hold_area(Suspension& cells, int cell) {
    const int first = cells.first[cell];
    const Nodes nodes{&cells.x[first], &cells.y[first], &cells.ux[first], &cells.uy[first],
                      cells.node_count(cell)};
    const Change change = change_of_move(nodes);
    const double error = cells.area[cell] - cells.reference_area[cell];
    take_off(nodes, (change.area + share_of_error * error) / change.gradient2);
}

}  // namespace tt
