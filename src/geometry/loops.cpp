#include "geometry/loops.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tt {
namespace {

/// The multiples of a period by which [low, high] must move to come within [from, to].
std::pair<int, int> shifts(double low, double high, double from, double to, double period) {
    if (period <= 0.0) return {0, 0};
    return {static_cast<int>(std::ceil((from - high) / period)),
            static_cast<int>(std::floor((to - low) / period))};
}

Corners corners(const Loop& loop) {
    Vec2 low = loop.front(), high = loop.front();
    for (const Vec2 p : loop) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {low, high};
}

/// Two pieces in one place, as of two loops that meet along an edge, bound nothing.
void cancel_pairs(std::vector<WallSegment>& segments) {
    constexpr double fine = 1e6;  // places a unit of length, so that rounding does not matter
    using Key = std::array<long long, 4>;
    const auto key = [](const WallSegment& s) {
        const auto place = [](Vec2 p) {
            return std::array{std::llround(p.x * fine), std::llround(p.y * fine)};
        };
        auto a = place(s.from), b = place(s.to);
        if (b < a) std::swap(a, b);
        return Key{a[0], a[1], b[0], b[1]};
    };
    std::map<Key, std::size_t> single;
    std::vector<bool> cancelled(segments.size(), false);
    for (std::size_t n = 0; n < segments.size(); ++n) {
        const auto [found, fresh] = single.try_emplace(key(segments[n]), n);
        if (fresh) continue;
        cancelled[n] = cancelled[found->second] = true;
        single.erase(found);
    }
    std::size_t n = 0;
    std::erase_if(segments, [&](const WallSegment&) { return cancelled[n++]; });
}

template <class F>
void for_each_point(Solid& solid, F&& f) {
    for (Loop& loop : solid.loops)
        for (Vec2& point : loop) f(point);
    for (Opening& opening : solid.openings) {
        f(opening.from);
        f(opening.to);
    }
}

/// Both ends of it lie on the opening, to a hundredth of a unit.
bool is_part_of(const WallSegment& segment, const Opening& opening) {
    constexpr double rounding = 1e-2;
    const Vec2 along = opening.to - opening.from;
    const double length = norm(along);
    const auto on = [&](Vec2 p) {
        const double way = dot(p - opening.from, along) / length;
        return std::fabs(cross(along, p - opening.from)) <= rounding * length && way >= -rounding &&
               way <= length + rounding;
    };
    return on(segment.from) && on(segment.to);
}

}  // namespace

Corners corners_of(const std::vector<Loop>& loops) {
    if (loops.empty()) return {};
    Corners all = corners(loops.front());
    for (const Loop& loop : loops) {
        const Corners e = corners(loop);
        all.low = {std::min(all.low.x, e.low.x), std::min(all.low.y, e.low.y)};
        all.high = {std::max(all.high.x, e.high.x), std::max(all.high.y, e.high.y)};
    }
    return all;
}

Solid moved(Solid solid, Vec2 by) {
    for_each_point(solid, [&](Vec2& p) { p += by; });
    return solid;
}

Solid scaled(Solid solid, double factor) {
    for_each_point(solid, [&](Vec2& p) { p *= factor; });
    solid.period_x *= factor;
    solid.period_y *= factor;
    return solid;
}

std::vector<Loop> solid_loops(const Solid& solid, double width, double height) {
    std::vector<Loop> loops;
    if (solid.outside) loops.push_back({{0, 0}, {width, 0}, {width, height}, {0, height}});
    for (const Loop& loop : solid.loops) {
        const auto [low, high] = corners(loop);
        const auto [x0, x1] = shifts(low.x, high.x, 0.0, width, solid.period_x);
        const auto [y0, y1] = shifts(low.y, high.y, 0.0, height, solid.period_y);
        for (int n = x0; n <= x1; ++n)
            for (int m = y0; m <= y1; ++m) {
                loops.push_back(loop);
                for (Vec2& p : loops.back()) p += Vec2{n * solid.period_x, m * solid.period_y};
            }
    }
    return loops;
}

std::vector<WallSegment> segments_near(const Solid& solid, double width, double height,
                                       double reach) {
    std::vector<WallSegment> segments;
    for (std::size_t l = 0; l < solid.loops.size(); ++l) {
        const Loop& loop = solid.loops[l];
        const auto [low, high] = corners(loop);
        const auto [x0, x1] = shifts(low.x, high.x, -reach, width + reach, solid.period_x);
        const auto [y0, y1] = shifts(low.y, high.y, -reach, height + reach, solid.period_y);
        for (int n = x0; n <= x1; ++n)
            for (int m = y0; m <= y1; ++m)
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    const Vec2 a = loop[k], b = loop[(k + 1) % loop.size()];
                    const Vec2 shift{n * solid.period_x, m * solid.period_y};
                    if (a != b) segments.push_back({a + shift, b + shift, static_cast<int>(l)});
                }
    }
    cancel_pairs(segments);
    for (WallSegment& segment : segments)
        for (std::size_t n = 0; n < solid.openings.size(); ++n)
            if (is_part_of(segment, solid.openings[n])) segment.opening = static_cast<int>(n);
    return segments;
}

std::vector<double> crossings_of_row(const std::vector<WallSegment>& segments, double y) {
    std::vector<double> crossings;
    for (const auto& [a, b, loop, opening] : segments) {
        if ((a.y < y) == (b.y < y)) continue;
        crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

std::vector<OpenPiece> open_pieces(const Solid& solid, Vec2 box, bool walled, bool upright,
                                   double at) {
    std::vector<WallSegment> segments = segments_near(solid, box.x, box.y, box.x + box.y);
    if (upright)
        for (WallSegment& segment : segments)
            for (Vec2* p : {&segment.from, &segment.to}) std::swap(p->x, p->y);
    const bool bounded = walled && upright;
    const double low = bounded ? 0.0 : -HUGE_VAL, high = bounded ? box.y : HUGE_VAL;
    std::vector<OpenPiece> pieces;
    double begin = low;
    bool open = !solid.outside && !(walled && !upright && (at < 0.0 || at > box.y));
    if (!open && !solid.outside) return {};
    const auto close = [&](double end) {
        begin = std::max(begin, low);
        end = std::min(end, high);
        if (open && end > begin) pieces.push_back({begin, end});
    };
    for (const double crossing : crossings_of_row(segments, at)) {
        close(crossing);
        open = !open;
        begin = crossing;
    }
    close(high);
    return pieces;
}

double meeting(Vec2 a, Vec2 b, const WallSegment& segment) {
    const Vec2 way = b - a, along = segment.to - segment.from, apart = segment.from - a;
    const double turn = cross(way, along);
    if (turn == 0.0) return -1.0;
    const double t = cross(apart, along) / turn, s = cross(apart, way) / turn;
    return t >= 0.0 && t <= 1.0 && s >= 0.0 && s <= 1.0 ? t : -1.0;
}

Vec2 nearest_on(const WallSegment& segment, Vec2 point) {
    const Vec2 along = segment.to - segment.from;
    const double share = dot(point - segment.from, along) / dot(along, along);
    return segment.from + std::clamp(share, 0.0, 1.0) * along;
}

}  // namespace tt
