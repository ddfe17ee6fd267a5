#include "case/shapes/t_junction.hpp"

#include <cmath>

namespace tt {

ShapeFaults TJunctionShape::faults() const {
    ShapeFaults faults;
    if (daughter_widths.size() != 2)
        faults.emplace_back("daughter_widths",
                            "a junction has two daughters; write daughter_widths = [\"14 um\", "
                            "\"9.2 um\"], the upper one first");
    if (lengths.size() != 3)
        faults.emplace_back("lengths",
                            "a junction has three channels; write lengths = [\"60 um\", \"60 um\", "
                            "\"60 um\"], of parent, upper and lower");
    if (!faults.empty()) return faults;
    const double widths[] = {parent_width.si, daughter_widths[0].si, daughter_widths[1].si};
    for (int n = 0; n < 3; ++n)
        if (lengths[static_cast<std::size_t>(n)].si < widths[n])
            faults.emplace_back("lengths", "a channel of " + um(widths[n]) + " is " +
                                               um(lengths[static_cast<std::size_t>(n)].si) +
                                               " long; write at least " + um(2.0 * widths[n]));
    return faults;
}

ShapeDrawing TJunctionShape::drawing() const {
    const double half = 0.5 * parent_width.si, x = lengths[0].si;
    const double wu = daughter_widths[0].si, wl = daughter_widths[1].si;
    const double top = half + lengths[1].si, bottom = -half - lengths[2].si;
    ShapeDrawing drawing;
    Loop loop{{0.0, -half}, {x, -half}, {x, bottom}, {x + wl, bottom}};
    if (wl != wu) {  // the wall behind them steps
        loop.push_back({x + wl, 0.0});
        loop.push_back({x + wu, 0.0});
    }
    for (const Vec2 p : {Vec2{x + wu, top}, Vec2{x, top}, Vec2{x, half}, Vec2{0.0, half}})
        loop.push_back(p);
    drawing.loops = {loop};
    drawing.ports = {
        {"inlet", {0.0, 0.0}}, {"upper", {x + 0.5 * wu, top}}, {"lower", {x + 0.5 * wl, bottom}}};
    const double before = x - std::fmin(2.0 * half, 0.5 * x);
    const double above = half + std::fmin(wu, 0.5 * lengths[1].si);
    const double below = -half - std::fmin(wl, 0.5 * lengths[2].si);
    drawing.sections = {section_between("parent", {before, -half}, {before, half}),
                        section_between("upper_daughter", {x + wu, above}, {x, above}),
                        section_between("lower_daughter", {x, below}, {x + wl, below})};
    drawing.forks = {{"fork", "parent", {"upper_daughter", "lower_daughter"}}};
    return drawing;
}

}  // namespace tt
