#include "case/shapes/loop.hpp"

#include <cmath>

#include <fmt/format.h>

namespace tt {
namespace {

/// Corners of the left half, x from where the channel parts; the right half is its mirror image.
struct LeftHalf {
    double upper_x, upper_y;  ///< outer wall, where it runs along x again
    double lower_x, lower_y;
    Vec2 tip;                           ///< of the island
    double island_upper, island_lower;  ///< x where its straight sides begin
    double middle;                      ///< x of the mirror

    explicit LeftHalf(const LoopShape& s) {
        const double half = 0.5 * s.parent_width.si, side = 0.5 * s.island_width.si;
        const double wu = s.branch_widths[0].si, wl = s.branch_widths[1].si;
        const double angle = s.angle.si, slope = std::tan(angle);
        upper_y = side + wu;
        lower_y = -side - wl;
        upper_x = (upper_y - half) / slope;
        lower_x = (-half - lower_y) / slope;
        const Vec2 over{wu * std::sin(angle), half - wu * std::cos(angle)};
        const Vec2 under{wl * std::sin(angle), -half + wl * std::cos(angle)};
        tip = meeting_of(over, angle, under, -angle);
        island_upper = tip.x + (side - tip.y) / slope;
        island_lower = tip.x + (tip.y + side) / slope;
        middle = std::fmax(island_upper, island_lower) + 0.5 * s.island_length.si;
    }
};

}  // namespace

ShapeFaults LoopShape::faults() const {
    ShapeFaults faults;
    if (branch_widths.size() != 2)
        faults.emplace_back("branch_widths",
                            "a loop has two branches; write branch_widths = [\"14 "
                            "um\", \"9.2 um\"], the upper one first");
    judge_ends(lengths, parent_width, faults);
    if (branch_widths.size() != 2 || lengths.size() != 2) return faults;
    const LeftHalf left(*this);
    const double needed = 2.0 * std::fabs(left.tip.y) + 2e-6;
    if (island_width.si < needed)
        faults.emplace_back("island_width",
                            fmt::format("the branches are not parted: the tip of the island would "
                                        "lie beside it; write at least {}",
                                        um(1.5 * needed)));
    if (left.upper_x <= 0.0 || left.lower_x <= 0.0)
        faults.emplace_back("island_width",
                            fmt::format("the branches lie within the width of the parent, {}; "
                                        "write at least {}",
                                        um(parent_width.si), um(1.2 * parent_width.si)));
    if (left.tip.x <= 0.0)
        faults.emplace_back("branch_widths",
                            fmt::format("the tip of the island would stand {} within the parent; "
                                        "write wider branches or a smaller angle",
                                        um(-left.tip.x)));
    return faults;
}

ShapeDrawing LoopShape::drawing() const {
    const LeftHalf left(*this);
    const double x0 = lengths[0].si, half = 0.5 * parent_width.si, side = 0.5 * island_width.si;
    const double x1 = x0 + 2.0 * left.middle, end = x1 + lengths[1].si, middle = x0 + left.middle;
    ShapeDrawing drawing;
    drawing.loops = {{{0.0, -half},
                      {x0, -half},
                      {x0 + left.lower_x, left.lower_y},
                      {x1 - left.lower_x, left.lower_y},
                      {x1, -half},
                      {end, -half},
                      {end, half},
                      {x1, half},
                      {x1 - left.upper_x, left.upper_y},
                      {x0 + left.upper_x, left.upper_y},
                      {x0, half},
                      {0.0, half}},
                     {{x0 + left.tip.x, left.tip.y},
                      {x0 + left.island_lower, -side},
                      {x1 - left.island_lower, -side},
                      {x1 - left.tip.x, left.tip.y},
                      {x1 - left.island_upper, side},
                      {x0 + left.island_upper, side}}};
    drawing.ports = {{"inlet", {0.0, 0.0}}, {"outlet", {end, 0.0}}};
    const double before = x0 - std::fmin(2.0 * half, 0.5 * x0);
    const double behind = x1 + std::fmin(2.0 * half, 0.5 * lengths[1].si);
    drawing.sections = {section_between("before", {before, -half}, {before, half}),
                        section_between("upper", {middle, side}, {middle, left.upper_y}),
                        section_between("lower", {middle, left.lower_y}, {middle, -side}),
                        section_between("behind", {behind, -half}, {behind, half})};
    drawing.forks = {{"fork", "before", {"upper", "lower"}}};
    return drawing;
}

}  // namespace tt
