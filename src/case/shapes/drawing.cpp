#include "case/shapes/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace tt {
namespace {

Vec2 unit(double angle) {
    // Along the axes exactly: ports and sections are.
    const double quarters = angle / (0.5 * std::numbers::pi);
    if (std::fabs(quarters - std::round(quarters)) < 1e-9) {
        constexpr Vec2 axes[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        return axes[((std::lround(quarters) % 4) + 4) % 4];
    }
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

SectionCase section_between(std::string name, Vec2 from, Vec2 to) {
    return {std::move(name), {Length{from.x}, Length{from.y}}, {Length{to.x}, Length{to.y}}};
}

ChannelPen::ChannelPen(Vec2 start, double angle, double width)
    : place_(start), angle_(angle), width_(width) {
    note();
}

Vec2 ChannelPen::ahead() const { return unit(angle_); }

Vec2 ChannelPen::left() const {
    const Vec2 a = ahead();
    return {-a.y, a.x};
}

void ChannelPen::note() {
    right_.push_back(place_ - 0.5 * width_ * left());
    left_.push_back(place_ + 0.5 * width_ * left());
}

void ChannelPen::go(double length) {
    place_ += length * ahead();
    note();
}

void ChannelPen::turn(double angle, double radius) {
    const double side = angle < 0.0 ? -1.0 : 1.0;
    const Vec2 centre = place_ + side * radius * left();
    // Chords that are off by 10⁻⁴ of the outer radius, at the most.
    const int pieces = std::max(8, static_cast<int>(std::ceil(std::fabs(angle) / 0.026)));
    const double start = angle_;
    for (int k = 1; k <= pieces; ++k) {
        angle_ = start + angle * k / pieces;
        place_ = centre - side * radius * left();
        note();
    }
}

void ChannelPen::widen(double width, double length) {
    width_ = width;
    go(length);
}

SectionCase ChannelPen::section(std::string name) const {
    const Vec2 half = 0.5 * width_ * left();
    return section_between(std::move(name), place_ - half, place_ + half);
}

Loop ChannelPen::outline() const {
    Loop loop = right_;
    loop.insert(loop.end(), left_.rbegin(), left_.rend());
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    return loop;
}

void judge_ends(const std::vector<Length>& lengths, Length width, ShapeFaults& faults) {
    if (lengths.size() != 2)
        faults.emplace_back("lengths",
                            "there is a channel before and one behind it; write lengths = "
                            "[\"60 um\", \"60 um\"]");
    for (const Length length : lengths)
        if (length < width)
            faults.emplace_back("lengths",
                                fmt::format("a piece of {} is shorter than the channel is wide, "
                                            "{}; write at least {}",
                                            um(length.si), um(width.si), um(2.0 * width.si)));
}

Vec2 meeting_of(Vec2 a, double angle_a, Vec2 b, double angle_b) {
    const Vec2 along = unit(angle_a), other = unit(angle_b);
    return a + cross(b - a, other) / cross(along, other) * along;
}

std::optional<Vec2> crossing_of(const std::vector<Loop>& loops) {
    struct Piece {
        WallSegment wall;
        std::size_t loop, first, count;
    };
    std::vector<Piece> pieces;
    for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t k = 0; k < loops[l].size(); ++k)
            pieces.push_back(
                {{loops[l][k], loops[l][(k + 1) % loops[l].size()]}, l, k, loops[l].size()});
    const auto left = [](const Piece& p) { return std::min(p.wall.from.x, p.wall.to.x); };
    const auto right = [](const Piece& p) { return std::max(p.wall.from.x, p.wall.to.x); };
    std::stable_sort(pieces.begin(), pieces.end(),
                     [&](const Piece& a, const Piece& b) { return left(a) < left(b); });
    for (std::size_t a = 0; a < pieces.size(); ++a)
        for (std::size_t b = a + 1; b < pieces.size() && left(pieces[b]) <= right(pieces[a]); ++b) {
            const Piece &p = pieces[a], &q = pieces[b];
            const std::size_t apart = p.first > q.first ? p.first - q.first : q.first - p.first;
            if (p.loop == q.loop && (apart <= 1 || apart + 1 == p.count)) continue;
            if (meeting(p.wall.from, p.wall.to, q.wall) >= 0.0) return q.wall.from;
        }
    return std::nullopt;
}

std::string um(double length) { return fmt::format("{:.4g} um", 1e6 * length); }

}  // namespace tt
