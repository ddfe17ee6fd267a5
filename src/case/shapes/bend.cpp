#include "case/shapes/bend.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace tt {

ShapeFaults BendShape::faults() const {
    ShapeFaults faults;
    judge_ends(lengths, width, faults);
    if (radius.si < 0.6 * width.si)
        faults.emplace_back("radius",
                            fmt::format("the middle line bends at {}, and of a channel of {} the "
                                        "inner wall would cross itself; write at least {}",
                                        um(radius.si), um(width.si), um(width.si)));
    if (std::fabs(angle.si) < 0.017)
        faults.emplace_back("angle", "a bend by less than 1 deg is none; write angle = \"90 deg\"");
    return faults;
}

ShapeDrawing BendShape::drawing() const {
    ShapeDrawing drawing;
    ChannelPen pen({0.0, 0.0}, 0.0, width.si);
    const double first = lengths[0].si, last = lengths[1].si;
    const double quarters = std::fabs(angle.si) / (0.5 * std::numbers::pi);
    const bool aligned = std::fabs(quarters - std::round(quarters)) < 1e-3;
    const double turn =
        aligned ? std::copysign(0.5 * std::numbers::pi * std::round(quarters), angle.si) : angle.si;
    const double before = first - std::fmin(width.si, 0.5 * first);
    pen.go(before);
    drawing.sections.push_back(pen.section("before"));
    pen.go(first - before);
    pen.turn(turn, radius.si);
    if (!aligned) pen.turn(-turn, radius.si);
    pen.go(std::fmin(width.si, 0.5 * last));
    drawing.sections.push_back(pen.section("behind"));
    pen.go(last - std::fmin(width.si, 0.5 * last));
    drawing.loops = {pen.outline()};
    drawing.ports = {{"inlet", {0.0, 0.0}}, {"outlet", pen.place()}};
    return drawing;
}

}  // namespace tt
