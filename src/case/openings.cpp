#include "case/openings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace tt {
namespace {

struct Edge {
    std::size_t loop = 0, first = 0;  ///< from this point of the loop to the next
    double off = HUGE_VAL;            ///< of the point asked for
};

Vec2 point_of(const Loop& loop, std::size_t k) { return loop[k % loop.size()]; }

Edge nearest_edge(const std::vector<Loop>& loops, Vec2 point) {
    Edge nearest;
    for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t k = 0; k < loops[l].size(); ++k) {
            const WallSegment segment{loops[l][k], point_of(loops[l], k + 1)};
            if (segment.from == segment.to) continue;
            const double off = norm(point - nearest_on(segment, point));
            if (off < nearest.off) nearest = {l, k, off};
        }
    return nearest;
}

/// The whole straight run of edges that this one is part of.
Opening straight_run(const Loop& loop, std::size_t first) {
    const std::size_t n = loop.size();
    const Vec2 from = loop[first], along = point_of(loop, first + 1) - from;
    const auto straight_on = [&](Vec2 a, Vec2 b) {
        return std::fabs(cross(along, b - a)) <= 1e-6 * norm(along) * norm(b - a) &&
               dot(along, b - a) >= 0.0;
    };
    std::size_t back = 0, forth = 0;
    while (back + forth + 1 < n &&
           straight_on(point_of(loop, first + n - back - 1), point_of(loop, first + n - back)))
        ++back;
    while (back + forth + 1 < n &&
           straight_on(point_of(loop, first + 1 + forth), point_of(loop, first + 2 + forth)))
        ++forth;
    return {point_of(loop, first + n - back), point_of(loop, first + 1 + forth)};
}

std::string in_um(Vec2 p) { return fmt::format("({:.6g}, {:.6g}) um", 1e6 * p.x, 1e6 * p.y); }

/// Along x or y to rounding, and exactly so in what is returned.
bool straighten(Opening& opening) {
    const Vec2 along = opening.to - opening.from;
    constexpr double slightest = 1e-4;
    if (std::fabs(along.x) <= slightest * std::fabs(along.y))
        opening.from.x = opening.to.x = 0.5 * (opening.from.x + opening.to.x);
    else if (std::fabs(along.y) <= slightest * std::fabs(along.x))
        opening.from.y = opening.to.y = 0.5 * (opening.from.y + opening.to.y);
    else
        return false;
    return true;
}

/// As the case says, or by the name where the shape has ports of its own.
std::optional<Vec2> place_of(const PortCase& port, const std::optional<ShapeDrawing>& drawing) {
    if (!drawing)
        return port.at.size() == 2 ? std::optional(Vec2{port.at[0].si, port.at[1].si})
                                   : std::nullopt;
    for (const ShapeDrawing::Port& own : drawing->ports)
        if (own.name == port.name) return own.at;
    return std::nullopt;
}

}  // namespace

PortPlaces port_places(const Case& c) {
    PortPlaces places;
    const std::vector<Loop> loops = c.geometry.channels();
    const auto drawing = c.geometry.drawing();
    for (const PortCase& port : c.ports) {
        places.openings.emplace_back();
        const auto tell = [&](std::string why) {
            places.openings.back() = {};
            places.faults.emplace_back(port.name, std::move(why));
        };
        const auto place = place_of(port, drawing);
        if (loops.empty() || !place) continue;
        const Vec2 at = *place;
        const Corners all = corners_of(loops);
        const Edge edge = nearest_edge(loops, at);
        const Loop& loop = loops[edge.loop];
        if (edge.off > 0.01 * norm(all.high - all.low)) {
            tell(
                fmt::format("at = {} is on no piece of the drawing, which goes from {} to {}; the "
                            "nearest goes from {} to {}",
                            in_um(at), in_um(all.low), in_um(all.high), in_um(loop[edge.first]),
                            in_um(point_of(loop, edge.first + 1))));
            continue;
        }
        Opening& opening = places.openings.back() = straight_run(loop, edge.first);
        const Vec2 along = opening.to - opening.from;
        if (!straighten(opening)) {
            const double angle = std::atan2(along.y, along.x) * 180.0 / std::numbers::pi;
            tell(
                fmt::format("the piece from {} to {} runs at {:.3g} deg; a port lies along x or "
                            "y: draw the channel with an end that does",
                            in_um(opening.from), in_um(opening.to), angle));
            continue;
        }
        for (std::size_t n = 0; n + 1 < places.openings.size(); ++n)
            if (places.openings[n] == opening && opening.from != opening.to)
                tell(fmt::format("it lies where port '{}' is", c.ports[n].name));
    }
    return places;
}

}  // namespace tt
