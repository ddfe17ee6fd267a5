#include "membrane/area.hpp"

#include "base/isa.hpp"
#include "base/parallel.hpp"

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

/// Calls f(before, k, next) for every node.
template <class F>
TT_INLINE void for_each_node(int count, F&& f) {
    f(count - 1, 0, 1);
    for (int k = 1; k < count - 1; ++k) f(k - 1, k, k + 1);
    f(count - 2, count - 1, 0);
}

/// What the move x → x + u adds to the area, exactly: Σ u·∂A/∂x + ½ Σ u × u_next; and Σ |∂A/∂x|².
struct Change {
    double area = 0.0, gradient2 = 0.0;
};

Change change_of_move(const Nodes& n) {
    Change sum;
    for_each_node(n.count, [&](int before, int k, int next) {
        const Vec2 u{n.ux[k], n.uy[k]}, u_next{n.ux[next], n.uy[next]};
        const Vec2 g = gradient(n, before, next);
        sum.area += dot(u, g) + 0.5 * cross(u, u_next);
        sum.gradient2 += dot(g, g);
    });
    return sum;
}

void take_off(const Nodes& n, double factor) {
    for_each_node(n.count, [&](int before, int k, int next) {
        const Vec2 g = gradient(n, before, next);
        n.ux[k] -= factor * g.x;
        n.uy[k] -= factor * g.y;
    });
}

}  // namespace

void hold_areas(Suspension& cells) {
    const auto [begin, end] = team_share(cells.cell_count());
    for (int cell = begin; cell < end; ++cell) {
        const int first = cells.first[cell];
        const Nodes nodes{&cells.x[first], &cells.y[first], &cells.ux[first], &cells.uy[first],
                          cells.node_count(cell)};
        const Change change = change_of_move(nodes);
        const double error = cells.area[cell] - cells.reference_area[cell];
        take_off(nodes, (change.area + share_of_error * error) / change.gradient2);
    }
    team_barrier();
}

}  // namespace tt
