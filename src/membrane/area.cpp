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
#pragma omp simd
    for (int k = 1; k < count - 1; ++k) f(k - 1, k, k + 1);
    f(count - 2, count - 1, 0);
}

/// What the move x → x + u adds to the area, exactly: Σ u·∂A/∂x + ½ Σ u × u_next; and Σ |∂A/∂x|².
struct Change {
    double area = 0.0, gradient2 = 0.0;
};

TT_CLONES Change change_of_move(const Nodes nodes) {
    const Nodes n = nodes;
    constexpr int lanes = 8;
    double area[lanes] = {}, gradient2[lanes] = {};
    const auto add = [&](int before, int k, int next) TT_INLINE_LAMBDA {
        const Vec2 g = gradient(n, before, next);
        area[k % lanes] +=
            n.ux[k] * g.x + n.uy[k] * g.y + 0.5 * (n.ux[k] * n.uy[next] - n.uy[k] * n.ux[next]);
        gradient2[k % lanes] += g.x * g.x + g.y * g.y;
    };
    add(n.count - 1, 0, 1);
    for (int k = 1; k < n.count - 1; ++k) add(k - 1, k, k + 1);
    add(n.count - 2, n.count - 1, 0);
    Change sum;
    for (int lane = 0; lane < lanes; ++lane) {
        sum.area += area[lane];
        sum.gradient2 += gradient2[lane];
    }
    return sum;
}

TT_CLONES void take_off(const Nodes nodes, double factor) {
    const Nodes n = nodes;
    for_each_node(n.count, [&](int before, int k, int next) TT_INLINE_LAMBDA {
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
