#include "case/shapes/serpentine.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace tt {

ShapeFaults SerpentineShape::faults() const {
    ShapeFaults faults;
    if (leg_length < width)
        faults.emplace_back("leg_length",
                            fmt::format("legs of {} are shorter than the channel is wide, {}; "
                                        "write at least {}",
                                        um(leg_length.si), um(width.si), um(2.0 * width.si)));
    if (radius.si < 0.6 * width.si)
        faults.emplace_back(
            "radius", fmt::format("legs {} apart of a channel of {} overlap, or are parted by "
                                  "next to nothing; write at least {}",
                                  um(2.0 * radius.si), um(width.si), um(width.si)));
    return faults;
}

ShapeDrawing SerpentineShape::drawing() const {
    ShapeDrawing drawing;
    ChannelPen pen({0.0, 0.0}, 0.0, width.si);
    const auto leg = [&](std::string_view section) {
        pen.go(0.5 * leg_length.si);
        if (!section.empty()) drawing.sections.push_back(pen.section(std::string(section)));
        pen.go(0.5 * leg_length.si);
    };
    leg("before");
    for (std::int64_t n = 0; n < turns; ++n) {
        pen.turn(n % 2 == 0 ? std::numbers::pi : -std::numbers::pi, radius.si);
        leg(n + 1 == turns ? "behind" : "");
    }
    drawing.loops = {pen.outline()};
    drawing.ports = {{"inlet", {0.0, 0.0}}, {"outlet", pen.place()}};
    return drawing;
}

}  // namespace tt
