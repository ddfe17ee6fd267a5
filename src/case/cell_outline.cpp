#include "case/cell_outline.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "membrane/shapes.hpp"

namespace tt {

OutlineMeasures measures_of(const CellOutline& outline) {
    const auto [left, right] = std::minmax_element(outline.points.begin(), outline.points.end(),
                                                   [](Vec2 a, Vec2 b) { return a.x < b.x; });
    const auto [bottom, top] = std::minmax_element(outline.points.begin(), outline.points.end(),
                                                   [](Vec2 a, Vec2 b) { return a.y < b.y; });
    OutlineMeasures m;
    m.width = right->x - left->x;
    m.height = top->y - bottom->y;
    m.area = area_of(outline.points);
    m.perimeter = perimeter_of(outline.points);
    m.reduced_area = 4.0 * std::numbers::pi * m.area / (m.perimeter * m.perimeter);
    m.radius = std::sqrt(m.area / std::numbers::pi);
    return m;
}

std::string description(const CellOutline& outline) {
    const OutlineMeasures m = measures_of(outline);
    return fmt::format(
        "{}: {} points{}, {} in the file; {:.4g} x {:.4g} um, area {:.4g} um^2, perimeter {:.4g} "
        "um, reduced area {:.3g}, radius of the circle of its area {:.4g} um",
        std::filesystem::path(outline.file).filename().string(), outline.given,
        outline.closed ? ", the last the first again" : "",
        outline.clockwise ? "clockwise" : "counter-clockwise", 1e6 * m.width, 1e6 * m.height,
        1e12 * m.area, 1e6 * m.perimeter, m.reduced_area, 1e6 * m.radius);
}

}  // namespace tt
