#include "case/read_outline.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "case/outline_faults.hpp"
#include "io/imagej_roi.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

[[noreturn]] void refuse(const std::string& file, std::string message) {
    throw CaseError({{file, 0, 0, std::move(message)}});
}

/// Points without those that stand at the place of the one before, the first being after the last.
GivenPoints without_repeats(const PointList& list) {
    GivenPoints given;
    const std::size_t n = list.points.size();
    for (std::size_t k = 0; k < n; ++k) {
        if (!given.points.empty() && given.points.back() == list.points[k]) continue;
        given.points.push_back(list.points[k]);
        given.numbers.push_back(static_cast<int>(k) + 1);
        if (!list.lines.empty()) given.lines.push_back(list.lines[k]);
    }
    if (given.points.size() > 1 && given.points.back() == given.points.front()) {
        given.points.pop_back();
        given.numbers.pop_back();
        if (!given.lines.empty()) given.lines.pop_back();
    }
    return given;
}

/// Do all steps run along x or y, with more corners than a drawn polygon has?
bool is_staircase(const std::vector<Vec2>& points) {
    constexpr int corners_of_a_drawing = 12;
    int corners = 0;
    bool along_x_before = points.front().y == points.back().y;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 step = points[(k + 1) % points.size()] - points[k];
        if (step.x != 0.0 && step.y != 0.0) return false;
        const bool along_x = step.y == 0.0;
        corners += along_x != along_x_before ? 1 : 0;
        along_x_before = along_x;
    }
    return corners > corners_of_a_drawing;
}

bool is_whole(const std::vector<Vec2>& points) {
    return std::all_of(points.begin(), points.end(),
                       [](Vec2 p) { return p.x == std::round(p.x) && p.y == std::round(p.y); });
}

PointList points_of(std::string_view bytes, const std::string& file) {
    if (is_imagej_roi(bytes)) return parse_imagej_roi(bytes, file);
    if (bytes.substr(0, 2) == "PK")
        refuse(file, "this is a zip archive, as ImageJ saves several ROIs; save one as .roi");
    return parse_points(bytes, file);
}

/// A heading that says in which unit the numbers are must agree with how they are read.
void refuse_other_unit(const std::string& unit, const std::string& file,
                       const OutlineShape& shape) {
    if (unit.empty() || shape.pixel) return;
    if (unit.substr(0, 2) == "px" || unit.substr(0, 5) == "pixel")
        refuse(file,
               "its numbers are pixels; write pixel = \"0.1 um\", the side of one, in "
               "[cells]");
    try {
        const Measure one = parse_measure("1 " + unit);
        if (one.dimension == Length::dimension && one.si != 1e-6)
            refuse(file, fmt::format("the heading says {}; write pixel = \"1 {}\" in [cells]", unit,
                                     unit));
    } catch (const UnitError&) {  // a word in brackets that is no unit
    }
}

double shortest_step(const std::vector<Vec2>& points) {
    double shortest = HUGE_VAL;
    for (std::size_t k = 0; k < points.size(); ++k)
        shortest = std::min(shortest, norm(points[(k + 1) % points.size()] - points[k]));
    return shortest;
}

std::string steps_advice(const CellOutline& outline) {
    const double step = shortest_step(outline.points);
    const double longer =
        perimeter_of(outline.points) / perimeter_of(smoothed(outline.points, 1.5 * step)) - 1.0;
    return fmt::format(
        "All steps of the outline {} run along x or y, as the edges of pixels: its perimeter is "
        "about {:.0f} % too long, and the cell is taken for so much deflated. Write smoothing = "
        "\"{}\" in [cells], one and a half pixels, or trace it with subpixels.",
        outline.file, 100.0 * longer, rounded_text(Length{1.5 * step}, 2));
}

std::string direction_advice(const CellOutline& outline, const OutlineShape& shape) {
    return fmt::format(
        "{} {}. Images count y downwards: write y_down = true in [cells] if this outline does, "
        "else its mirror image is what runs; y_down = false if it does not.{}",
        outline.file, shape.pixel ? "is in pixels" : "runs clockwise",
        shape.pixel ? " Its first number is taken for x: lists of row, column must be turned round."
                    : "");
}

std::string unit_advice(const CellOutline& outline) {
    return fmt::format(
        "All coordinates of {} are whole numbers, and are read as x, y in um. If they are pixels, "
        "write pixel = \"0.1 um\", the side of one, and y_down = true in [cells]; lists of row, "
        "column must be turned round to column, row.",
        outline.file);
}

/// From the numbers of the file to metres, y upwards, counter-clockwise.
void scale(CellOutline& outline, double unit, bool y_down) {
    constexpr double least_area = 1e-30;  // m²; below, products of coordinates underflow
    for (Vec2& p : outline.points) p = unit * Vec2{p.x, y_down ? -p.y : p.y};
    if (area_of(outline.points) < 0.0) std::reverse(outline.points.begin(), outline.points.end());
    if (!(area_of(outline.points) > least_area))
        refuse(outline.file, "the outline encloses no area; its numbers are um");
}

void smooth(CellOutline& outline, const OutlineShape& shape) {
    const double length = shape.smoothing->si, perimeter = perimeter_of(outline.points);
    if (!(length < 0.05 * perimeter) || !(length > 1e-4 * perimeter))
        refuse(outline.file,
               fmt::format("smoothing = {} does not go with a perimeter of {}; write about one and "
                           "a half pixels, at least {} and at most {}",
                           to_text(*shape.smoothing), rounded_text(Length{perimeter}),
                           rounded_text(Length{1.1e-4 * perimeter}, 2),
                           rounded_text(Length{0.049 * perimeter}, 2)));
    outline.points = smoothed(outline.points, length);
    GivenPoints smooth{outline.points, {}, std::vector<int>(outline.points.size())};
    if (outline_fault(smooth, outline.file))
        refuse(outline.file, fmt::format("with smoothing = {} the outline crosses itself; write "
                                         "less",
                                         to_text(*shape.smoothing)));
}

}  // namespace

CellOutline read_outline(std::string_view bytes, const std::string& file,
                         const OutlineShape& shape) {
    const PointList list = points_of(bytes, file);
    refuse_other_unit(list.unit, file, shape);
    GivenPoints given = without_repeats(list);
    if (auto fault = outline_fault(given, file)) throw CaseError({std::move(*fault)});

    CellOutline outline;
    outline.file = file;
    outline.bytes = bytes;
    outline.given = static_cast<int>(list.points.size());
    outline.closed = list.points.front() == list.points.back();
    outline.clockwise = area_of(given.points) < 0.0;
    outline.staircase = is_staircase(given.points);
    outline.points = std::move(given.points);
    if (!shape.pixel && is_whole(outline.points)) outline.remarks.push_back(unit_advice(outline));
    if (!shape.y_down && !list.y_down && (outline.clockwise || shape.pixel))
        outline.remarks.push_back(direction_advice(outline, shape));

    scale(outline, shape.pixel.value_or(Length{1e-6}).si, shape.y_down.value_or(list.y_down));
    if (outline.staircase && !shape.smoothing) outline.remarks.push_back(steps_advice(outline));
    if (shape.smoothing) smooth(outline, shape);
    outline.points = placed(outline.points, 0.0, -centroid_of(outline.points));
    return outline;
}

}  // namespace tt
