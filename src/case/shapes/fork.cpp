#include "case/shapes/fork.hpp"

#include <cmath>

#include <fmt/format.h>

namespace tt {
namespace {

constexpr double bend = 1.5;         ///< radius of the middle line where it bends back, in widths
constexpr double level = 1.0 / 3.0;  ///< share of a daughter that runs along x again

/// One of the two channels behind the fork: its outer wall begins at the corner of the parent.
struct Daughter {
    double side;  ///< 1 upper, −1 lower
    double width, angle, length;
    Vec2 corner;

    double straight() const { return (1.0 - level) * length - bend * width * std::fabs(angle); }
    ChannelPen start() const {
        const Vec2 left{-std::sin(angle), std::cos(angle)};
        return {corner - 0.5 * side * width * left, angle, width};
    }
    Vec2 inner_start() const {
        const Vec2 left{-std::sin(angle), std::cos(angle)};
        return corner - side * width * left;
    }
};

struct Parts {
    Daughter upper, lower;
    Vec2 tip_upper, tip_lower;  ///< one point, or the ends of a blunt wall

    explicit Parts(const ForkShape& s) {
        const double x = s.lengths[0].si, half = 0.5 * s.parent_width.si;
        upper = {1.0, s.daughter_widths[0].si, s.angles[0].si, s.lengths[1].si, {x, half}};
        lower = {-1.0, s.daughter_widths[1].si, s.angles[1].si, s.lengths[2].si, {x, -half}};
        const Vec2 a = upper.inner_start(), b = lower.inner_start();
        tip_upper = tip_lower = meeting_of(a, upper.angle, b, lower.angle);
        if (tip_upper.x >= x) return;
        // Of narrow daughters the tip would stand in the parent.
        tip_upper = {x, a.y + (x - a.x) * std::tan(upper.angle)};
        tip_lower = {x, b.y + (x - b.x) * std::tan(lower.angle)};
    }
    /// Way along a daughter's inner wall to the tip.
    static double way_to(const Daughter& d, Vec2 tip) {
        return dot(tip - d.inner_start(), {std::cos(d.angle), std::sin(d.angle)});
    }
};

}  // namespace

ShapeFaults ForkShape::faults() const {
    ShapeFaults faults;
    const auto tell = [&](std::string_view key, std::string why) {
        faults.emplace_back(key, std::move(why));
    };
    if (daughter_widths.size() != 2)
        tell("daughter_widths",
             "a fork has two daughters; write daughter_widths = [\"14 um\", "
             "\"9.2 um\"], the upper one first");
    if (angles.size() != 2)
        tell("angles",
             "a fork has two daughters; write angles = [\"36 deg\", \"-36 deg\"], the "
             "upper one first");
    if (lengths.size() != 3)
        tell("lengths",
             "a fork has three channels; write lengths = [\"60 um\", \"120 um\", \"120 "
             "um\"], of parent, upper and lower");
    if (!faults.empty()) return faults;
    constexpr double least = 0.35;  // 20 degrees
    if (angles[0].si - angles[1].si < least) {
        tell("angles",
             "the upper daughter must leave at 20 deg more than the lower one, or they "
             "meet again; write angles = [\"36 deg\", \"-36 deg\"]");
        return faults;
    }
    if (lengths[0].si < parent_width.si)
        tell("lengths",
             fmt::format("the parent is {} long and {} wide; write at least {}", um(lengths[0].si),
                         um(parent_width.si), um(2.0 * parent_width.si)));
    const Parts parts(*this);
    for (const Daughter* d : {&parts.upper, &parts.lower}) {
        const double tip = Parts::way_to(*d, d->side > 0.0 ? parts.tip_upper : parts.tip_lower);
        const double missing = std::fmax(tip, 0.0) + 0.5 * d->width - d->straight();
        if (missing > 0.0)
            tell("lengths",
                 fmt::format(
                     "the {} daughter, {} long, is not straight for long enough to part "
                     "from the other before it bends back to x; write {}",
                     d->side > 0.0 ? "upper" : "lower", um(d->length),
                     um(std::ceil(1e6 * (d->length + 1.1 * missing / (1.0 - level))) * 1e-6)));
    }
    return faults;
}

ShapeDrawing ForkShape::drawing() const {
    const Parts parts(*this);
    ShapeDrawing drawing;
    const double half = 0.5 * parent_width.si, x = lengths[0].si;
    const auto drawn = [&](const Daughter& d, const char* section) {
        ChannelPen pen = d.start();
        pen.go(d.straight());
        if (d.angle != 0.0) pen.turn(-d.angle, bend * d.width);
        const double last = level * d.length;
        pen.go(0.25 * last);
        drawing.sections.push_back(pen.section(section));
        pen.go(0.75 * last);
        return pen;
    };
    const double before = x - std::fmin(parent_width.si, 0.5 * x);
    drawing.sections.push_back(section_between("parent", {before, -half}, {before, half}));
    const ChannelPen upper = drawn(parts.upper, "upper_daughter");
    const ChannelPen lower = drawn(parts.lower, "lower_daughter");
    Loop loop{{0.0, -half}};
    loop.insert(loop.end(), lower.right_wall().begin(), lower.right_wall().end());
    loop.insert(loop.end(), lower.left_wall().rbegin(), lower.left_wall().rend() - 1);
    loop.push_back(parts.tip_lower);
    if (parts.tip_upper != parts.tip_lower) loop.push_back(parts.tip_upper);
    loop.insert(loop.end(), upper.right_wall().begin() + 1, upper.right_wall().end());
    loop.insert(loop.end(), upper.left_wall().rbegin(), upper.left_wall().rend());
    loop.push_back({0.0, half});
    drawing.loops = {loop};
    drawing.ports = {{"inlet", {0.0, 0.0}}, {"upper", upper.place()}, {"lower", lower.place()}};
    drawing.forks = {{"fork", "parent", {"upper_daughter", "lower_daughter"}}};
    return drawing;
}

}  // namespace tt
