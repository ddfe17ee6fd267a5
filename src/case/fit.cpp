#include "case/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

/// The outline at rest about its centre [m].
std::vector<Vec2> outline_at_rest(const CellsCase& cells) {
    constexpr int nodes = 360;
    const double radius = cells.radius.si;
    if (std::holds_alternative<BiconcaveShape>(cells.shape)) return biconcave(radius, nodes);
    if (const auto* shape = std::get_if<EllipseShape>(&cells.shape)) {
        const double ratio = std::sqrt(shape->aspect_ratio);
        return ellipse(radius * ratio, radius / ratio, nodes);
    }
    if (std::holds_alternative<OutlineShape>(cells.shape))
        return cells.outline() ? cells.outline()->points : std::vector<Vec2>{};
    return circle(radius, nodes);
}

/// A cell as it lies, about its centre.
struct Extent {
    Vec2 low, high;

    double along() const { return high.x - low.x; }
    double across() const { return high.y - low.y; }
    /// 1 where it just fits, larger where it does not.
    double fill(const DomainCase& box) const {
        return std::max(along() / box.length.si, across() / box.width.si);
    }
};

Extent extent_at(const std::vector<Vec2>& rest, const CellsCase& cells, double angle) {
    const double stretch = std::sqrt(cells.initial_stretch.value_or(1.0));
    std::vector<Vec2> start = rest;
    for (Vec2& p : start) p = {stretch * p.x, p.y / stretch};
    Extent extent;
    for (const Vec2 lies : placed(std::move(start), angle, {})) {
        extent.low = {std::min(extent.low.x, lies.x), std::min(extent.low.y, lies.y)};
        extent.high = {std::max(extent.high.x, lies.x), std::max(extent.high.y, lies.y)};
    }
    return extent;
}

/// The way to lie that leaves most room in the box, of all half degrees.
double roomiest_angle(const std::vector<Vec2>& rest, const Case& c) {
    const auto radians = [](int halves) { return halves * std::numbers::pi / 360.0; };
    int best = 0;
    double least = HUGE_VAL;
    for (int halves = 0; halves < 360; ++halves) {
        const double fill = extent_at(rest, c.cells, radians(halves)).fill(c.domain);
        if (fill >= least * (1.0 - 1e-9)) continue;
        least = fill;
        best = halves;
    }
    return radians(best);
}

std::string size_text(const Extent& extent) {
    return fmt::format("{} long and {} wide as it lies", rounded_text(Length{extent.along()}),
                       rounded_text(Length{extent.across()}));
}

/// What to write instead of a cell that does not fit.
std::string cure(const Case& c, const std::vector<Vec2>& rest, const Extent& extent) {
    constexpr double room = 0.8;  // a film of plasma to each wall that a grid resolves
    const double most = room / extent.fill(c.domain);
    const double radius = most * c.cells.radius.si;
    std::string text = fmt::format("write radius = \"{}\"", rounded_text(Length{radius}, 3));
    const bool from_file = std::holds_alternative<OutlineShape>(c.cells.shape);
    if (from_file) text = fmt::format("one of {:.3g} times its size does", most);
    if (!from_file && radius < smallest_radius) {
        const bool wide = extent.across() / c.domain.width.si > extent.along() / c.domain.length.si;
        const double size = wide ? extent.across() : extent.along();
        const double spacing = c.numerics.dx ? c.numerics.dx->si : 0.1 * size;
        text = fmt::format("write {} = \"{}\"", wide ? "width" : "length",
                           rounded_text(Length{std::ceil(2.0 * size / spacing) * spacing}, 9));
    }
    if (std::holds_alternative<AtRandom>(c.cells.layout)) return text;
    const double angle = roomiest_angle(rest, c);
    if (extent_at(rest, c.cells, angle).fill(c.domain) < room)
        text += fmt::format(", or angle = \"{:.3g} deg\"", angle * 180.0 / std::numbers::pi);
    return text;
}

void judge_rows(Judge& judge, const Case& c, const Extent& extent) {
    if (2.0 * extent.across() > c.domain.width.si)
        judge.tell({"cells.layout"},
                   fmt::format("two rows of cells {} wide do not fit into {}",
                               rounded_text(Length{extent.across()}), to_text(c.domain.width)));
    if (!c.cells.count) return;
    const double per_row = std::ceil(static_cast<double>(*c.cells.count) / 2.0);
    if (per_row * extent.along() > c.domain.length.si)
        judge.tell(
            {"cells.count"},
            fmt::format("{} cells {} wide in two rows are longer than the box, {}", *c.cells.count,
                        rounded_text(Length{extent.along()}), to_text(c.domain.length)));
}

/// Returns whether as many cells as that can be.
bool judge_number(Judge& judge, const Case& c, double share) {
    if (c.cells.hematocrit && *c.cells.hematocrit < 0.5 * share)
        judge.tell({"cells.hematocrit"},
                   fmt::format("hematocrit = {:.3g} % is less than half a cell: one is {:.3g} % of "
                               "the box; write hematocrit = \"{:.3g} %\", or a longer box",
                               100.0 * *c.cells.hematocrit, 100.0 * share, 100.0 * share));
    if (!c.cells.count) return true;
    const double hematocrit = static_cast<double>(*c.cells.count) * share;
    if (hematocrit <= 0.9) return true;
    judge.tell({"cells.count"},
               fmt::format("{} cells would fill {:.0f} % of the box; at most {} fit (90 %); write "
                           "count = {}",
                           *c.cells.count, 100.0 * hematocrit, std::floor(0.9 / share),
                           std::max(1.0, 2.0 * std::floor(0.3 / share))));
    return false;
}

void judge_overlap(Judge& judge, const Case& c, const std::vector<std::vector<Length>>& positions) {
    const double radius = c.cells.radius.si;
    const bool walls = c.domain.sides == Sides::walls;
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto& p = positions[i];
            const auto& q = positions[j];
            if (p.size() != 2 || q.size() != 2) return;
            const double dx = std::remainder(p[0].si - q[0].si, c.domain.length.si);
            const double apart = p[1].si - q[1].si;
            const double dy = walls ? apart : std::remainder(apart, c.domain.width.si);
            if (std::hypot(dx, dy) >= 2.0 * radius) continue;
            return judge.tell({"cells.positions"},
                              fmt::format("cells {} and {} overlap: they are {} apart and {} wide",
                                          j + 1, i + 1, rounded_text(Length{std::hypot(dx, dy)}),
                                          rounded_text(Length{2.0 * radius})));
        }
}

}  // namespace

void judge_fit(Judge& judge, const Case& c) {
    const std::vector<Vec2> rest = outline_at_rest(c.cells);
    if (rest.empty()) return;
    const bool random = std::holds_alternative<AtRandom>(c.cells.layout);
    const double angle = random ? roomiest_angle(rest, c) : c.cells.angle.si;
    const Extent extent = extent_at(rest, c.cells, angle);
    if (extent.fill(c.domain) >= 1.0)
        return judge.tell(
            {"cells.radius", "cells.file", "domain.width"},
            fmt::format("a cell is {} and the box {} by {}; it does not fit; {}", size_text(extent),
                        to_text(c.domain.length), to_text(c.domain.width), cure(c, rest, extent)));
    const bool number =
        judge_number(judge, c, area_of(rest) / (c.domain.length.si * c.domain.width.si));
    if (std::holds_alternative<PaperRows>(c.cells.layout) && number) judge_rows(judge, c, extent);
}

void judge_positions(Judge& judge, const Case& c) {
    const auto* layout = std::get_if<AtPositions>(&c.cells.layout);
    const std::vector<Vec2> rest = outline_at_rest(c.cells);
    if (!layout || rest.empty()) return;
    const Extent extent = extent_at(rest, c.cells, c.cells.angle.si);
    const double lowest = -extent.low.y, highest = c.domain.width.si - extent.high.y;
    for (const auto& p : layout->positions) {
        if (p.size() != 2) return;
        if (c.domain.sides == Sides::walls && c.geometry.straight() && lowest < highest &&
            (p[1].si < lowest || p[1].si > highest))
            judge.tell({"cells.positions"},
                       fmt::format("the cell at [{}, {}] reaches into a wall; its y may be from {} "
                                   "to {}",
                                   to_text(p[0]), to_text(p[1]), rounded_text(Length{lowest}),
                                   rounded_text(Length{highest})));
    }
    if (std::holds_alternative<CircleShape>(c.cells.shape) && !c.cells.initial_stretch)
        judge_overlap(judge, c, layout->positions);
}

}  // namespace tt
