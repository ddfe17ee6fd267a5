#include "membrane/outline_checks.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace tt {
namespace {

int sign(double v) { return (v > 0.0) - (v < 0.0); }

bool within(double v, double a, double b) { return std::min(a, b) <= v && v <= std::max(a, b); }

/// Do the closed segments a–b and c–d share a point?
bool meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const int c_side = sign(cross(b - a, c - a));
    const int d_side = sign(cross(b - a, d - a));
    const int a_side = sign(cross(d - c, a - c));
    const int b_side = sign(cross(d - c, b - c));
    if (c_side * d_side < 0 && a_side * b_side < 0) return true;
    const auto on = [](int side, Vec2 p, Vec2 q, Vec2 r) {
        return side == 0 && within(p.x, q.x, r.x) && within(p.y, q.y, r.y);
    };
    return on(c_side, c, a, b) || on(d_side, d, a, b) || on(a_side, a, c, d) || on(b_side, b, c, d);
}

/// Does the outline turn straight back at the node between two consecutive segments?
bool folds_back(Vec2 before, Vec2 node, Vec2 after) {
    return cross(node - before, after - node) == 0.0 && dot(node - before, after - node) < 0.0;
}

/// Does every segment go forward around the mean of the nodes, and all of them together once? Then
/// no two can meet. Most outlines do; a curled one need not.
bool goes_around_once(const Outline& outline) {
    const int n = outline.size();
    Vec2 centre;
    for (int k = 0; k < n; ++k) centre += outline[k] / n;
    int turns = 0;
    for (int k = 0; k < n; ++k) {
        const Vec2 a = outline[k] - centre, b = outline[k + 1 < n ? k + 1 : 0] - centre;
        if (!(cross(a, b) > 0.0)) return false;
        turns += a.y < 0.0 && b.y >= 0.0 ? 1 : 0;
    }
    return turns == 1;
}

}  // namespace

std::optional<SelfCrossing> self_crossing(const Outline& outline) {
    if (goes_around_once(outline)) return std::nullopt;
    const int n = outline.size();
    const auto end = [&](int k) { return outline[k + 1 < n ? k + 1 : 0]; };
    const auto low = [&](int k) { return std::min(outline[k].x, end(k).x); };
    const auto high = [&](int k) { return std::max(outline[k].x, end(k).x); };
    const auto crossing = [&](int k, int m) {
        if (m == k + 1) return folds_back(outline[k], outline[m], end(m));
        if (k == 0 && m == n - 1) return folds_back(outline[m], outline[k], end(k));
        return within(outline[m].y, outline[k].y, end(k).y) ||
                       within(end(m).y, outline[k].y, end(k).y) ||
                       within(outline[k].y, outline[m].y, end(m).y)
                   ? meet(outline[k], end(k), outline[m], end(m))
                   : false;
    };
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int k, int m) { return low(k) < low(m); });
    std::optional<SelfCrossing> found;
    for (int i = 0; i < n; ++i) {
        for (int j = i + 1; j < n && low(order[j]) <= high(order[i]); ++j) {
            const auto [k, m] = std::minmax(order[i], order[j]);
            if (found && (found->first < k || (found->first == k && found->second <= m))) continue;
            if (crossing(k, m)) found = SelfCrossing{k, m};
        }
    }
    return found;
}

}  // namespace tt
