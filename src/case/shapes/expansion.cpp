#include "case/shapes/expansion.hpp"

#include <cmath>

#include <fmt/format.h>

namespace tt {

ShapeFaults ExpansionShape::faults() const {
    ShapeFaults faults;
    judge_ends(lengths, width, faults);
    if (wide_length.si < 0.5 * wide_width.si)
        faults.emplace_back("wide_length",
                            fmt::format("the wide piece is {} long and {} wide; write at least {}",
                                        um(wide_length.si), um(wide_width.si), um(wide_width.si)));
    return faults;
}

ShapeDrawing ExpansionShape::drawing() const {
    ShapeDrawing drawing;
    ChannelPen pen({0.0, 0.0}, 0.0, width.si);
    const double first = lengths[0].si, last = lengths[1].si;
    const double near = std::fmin(width.si, 0.5 * first), far = std::fmin(width.si, 0.5 * last);
    pen.go(first - near);
    drawing.sections.push_back(pen.section("before"));
    pen.go(near);
    pen.widen(wide_width.si, taper_length.si);
    pen.go(0.5 * wide_length.si);
    drawing.sections.push_back(pen.section("within"));
    pen.go(0.5 * wide_length.si);
    pen.widen(width.si, taper_length.si);
    pen.go(far);
    drawing.sections.push_back(pen.section("behind"));
    pen.go(last - far);
    drawing.loops = {pen.outline()};
    drawing.ports = {{"inlet", {0.0, 0.0}}, {"outlet", pen.place()}};
    return drawing;
}

}  // namespace tt
