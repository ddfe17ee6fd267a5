#include "membrane/outline_checks.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include "membrane/outline.hpp"

namespace tt {
namespace {

/// A node on a grid of less than 2³⁰ steps across the outline: products of two differences, and
/// their sums, fit into 64 bits. Ordered by x, then by y.
struct GridPoint {
    std::int64_t x = 0, y = 0;
    auto operator<=>(const GridPoint&) const = default;
};

/// Steps are a power of two, so that whole numbers, as of pixels, stay where they are.
std::vector<GridPoint> on_grid(const Outline& outline) {
    const auto [x_low, x_high] = std::minmax_element(outline.x.begin(), outline.x.end());
    const auto [y_low, y_high] = std::minmax_element(outline.y.begin(), outline.y.end());
    int exponent = 0;
    std::frexp(std::max(*x_high - *x_low, *y_high - *y_low), &exponent);
    std::vector<GridPoint> points(outline.x.size());
    for (std::size_t k = 0; k < points.size(); ++k)
        points[k] = {std::llround(std::ldexp(outline.x[k] - *x_low, 30 - exponent)),
                     std::llround(std::ldexp(outline.y[k] - *y_low, 30 - exponent))};
    return points;
}

int sign(std::int64_t v) { return (v > 0) - (v < 0); }

/// +1 where c lies to the left of the line from a to b, −1 to the right, 0 on it.
int side(GridPoint a, GridPoint b, GridPoint c) {
    return sign((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Is c, on the line through a and b, between them?
bool between(GridPoint a, GridPoint b, GridPoint c) {
    return std::min(a, b) <= c && c <= std::max(a, b);
}

/// Do the closed segments a–b and c–d share a point?
bool meet(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
    const int c_side = side(a, b, c), d_side = side(a, b, d);
    const int a_side = side(c, d, a), b_side = side(c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0) return true;
    return (c_side == 0 && between(a, b, c)) || (d_side == 0 && between(a, b, d)) ||
           (a_side == 0 && between(c, d, a)) || (b_side == 0 && between(c, d, b));
}

/// Does the outline turn straight back at the node between two consecutive segments?
bool folds_back(GridPoint before, GridPoint node, GridPoint after) {
    return side(before, node, after) == 0 && (before < node) == (after < node);
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

/// The segments that a vertical line cuts, from bottom to top, while it moves over the nodes.
class Sweep {
public:
    explicit Sweep(std::vector<GridPoint> points)
        : points_(std::move(points)), cut_(Below{this}), place_(points_.size(), cut_.end()) {}

    std::optional<SelfCrossing> run() {
        std::vector<int> order(points_.size());
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            return points_[a] != points_[b] ? points_[a] < points_[b] : a < b;
        });
        for (std::size_t k = 1; k < order.size(); ++k)
            if (points_[order[k - 1]] == points_[order[k]]) return pair(order[k - 1], order[k]);
        for (const int node : order)
            if (const auto found = pass(node)) return found;
        return std::nullopt;
    }

private:
    /// Which of two segments cut by the sweep line lies below the other. Neither: they meet.
    struct Below {
        const Sweep* sweep;
        bool operator()(int a, int b) const {
            const auto [a_left, a_right] = sweep->ends(a);
            const auto [b_left, b_right] = sweep->ends(b);
            if (a_left == b_left) return side(a_left, a_right, b_right) > 0;
            if (a_left < b_left) return side(a_left, a_right, b_left) > 0;
            return side(b_left, b_right, a_left) < 0;
        }
    };
    using Place = std::set<int, Below>::iterator;

    int after(int node) const { return node + 1 < static_cast<int>(points_.size()) ? node + 1 : 0; }
    int before(int node) const {
        return node > 0 ? node - 1 : static_cast<int>(points_.size()) - 1;
    }
    std::pair<GridPoint, GridPoint> ends(int segment) const {
        return std::minmax(points_[segment], points_[after(segment)]);
    }
    static SelfCrossing pair(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

    bool crosses(int a, int b) const {
        if (b == after(a)) return folds_back(points_[a], points_[b], points_[after(b)]);
        if (a == after(b)) return folds_back(points_[b], points_[a], points_[after(a)]);
        return meet(points_[a], points_[after(a)], points_[b], points_[after(b)]);
    }

    /// Takes out the segments that end at the node, then puts in those that start there.
    std::optional<SelfCrossing> pass(int node) {
        for (const int segment : {before(node), node})
            if (ends(segment).second == points_[node])
                if (const auto found = take_out(segment)) return found;
        for (const int segment : {before(node), node})
            if (ends(segment).first == points_[node])
                if (const auto found = put_in(segment)) return found;
        return std::nullopt;
    }

    std::optional<SelfCrossing> take_out(int segment) {
        const Place next = cut_.erase(place_[segment]);
        if (next == cut_.begin() || next == cut_.end()) return std::nullopt;
        const int low = *std::prev(next), high = *next;
        if (crosses(low, high)) return pair(low, high);
        return std::nullopt;
    }

    std::optional<SelfCrossing> put_in(int segment) {
        const auto [place, is_new] = cut_.insert(segment);
        if (!is_new) return pair(segment, *place);
        place_[segment] = place;
        if (place != cut_.begin() && crosses(*std::prev(place), segment))
            return pair(*std::prev(place), segment);
        const Place next = std::next(place);
        if (next != cut_.end() && crosses(segment, *next)) return pair(segment, *next);
        return std::nullopt;
    }

    std::vector<GridPoint> points_;
    std::set<int, Below> cut_;
    std::vector<Place> place_;  ///< of each segment that is cut
};

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double length2 = dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
    return norm(p - a - t * along);
}

/// A square of the plane, and a node in it.
struct BinnedNode {
    std::int64_t column = 0, row = 0;
    int node = 0;
    auto operator<=>(const BinnedNode&) const = default;
};

}  // namespace

std::optional<SelfApproach> self_approach(const Outline& outline, double reach) {
    const int n = outline.size();
    const double spacing = perimeter(outline) / n;
    const double side = reach + spacing;  // from a node to the first node of a segment in reach
    const int apart = std::max(2, static_cast<int>(std::ceil(4.0 * reach / spacing)));
    const auto bin = [&](int k) {
        return BinnedNode{std::llround(outline[k].x / side), std::llround(outline[k].y / side), k};
    };
    std::vector<BinnedNode> binned;
    for (int k = 0; k < n; ++k) binned.push_back(bin(k));
    std::sort(binned.begin(), binned.end());
    const auto along = [&](int k, int m) { return std::min((k - m + n) % n, (m - k + n) % n); };
    for (int k = 0; k < n; ++k) {
        const BinnedNode own = bin(k);
        for (std::int64_t column = own.column - 1; column <= own.column + 1; ++column) {
            auto other =
                std::lower_bound(binned.begin(), binned.end(), BinnedNode{column, own.row - 1, 0});
            for (; other != binned.end() && other->column == column && other->row <= own.row + 1;
                 ++other) {
                const int m = other->node, after = m + 1 < n ? m + 1 : 0;
                if (along(k, m) > apart && along(k, after) > apart &&
                    distance_to_segment(outline[k], outline[m], outline[after]) < reach)
                    return SelfApproach{k, m};
            }
        }
    }
    return std::nullopt;
}

std::optional<SelfCrossing> self_crossing(const Outline& outline) {
    if (goes_around_once(outline)) return std::nullopt;
    return Sweep(on_grid(outline)).run();
}

}  // namespace tt
