#include "observe/section_measures.hpp"

#include <algorithm>
#include <cmath>

#include "base/undefined.hpp"
#include "membrane/outline.hpp"

namespace tt {
namespace {

/// The outline where its first node is nearest to the line, in coordinates of `from_section`: x
/// along the line, y forward through it.
std::vector<Vec2> seen_from(const SectionLine& line, const Lattice& lattice, const Outline& shape) {
    const Vec2 home = from_section(line, lattice, shape[0]);
    std::vector<Vec2> points;
    for (int k = 0; k < shape.size(); ++k) {
        const Vec2 way = shape[k] - shape[0];
        points.push_back(home + (line.upright ? Vec2{way.y, line.sign * way.x}
                                              : Vec2{way.x, line.sign * way.y}));
    }
    return points;
}

bool is_near(const std::vector<Vec2>& points) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
    return low->y <= 0.0 && high->y >= 0.0;
}

/// Where an outline crosses a line, and the turn with which Σ turn · along is the length inside.
struct LineCrossing {
    double along;
    int turn;
};

/// Crossings of y = 0. Points on the line count as beyond it.
std::vector<LineCrossing> crossings_of(const std::vector<Vec2>& points) {
    std::vector<LineCrossing> crossings;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 a = points[k], b = points[(k + 1) % points.size()];
        if ((a.y < 0.0) == (b.y < 0.0)) continue;
        crossings.push_back({a.x - a.y / (b.y - a.y) * (b.x - a.x), a.y < 0.0 ? 1 : -1});
    }
    return crossings;
}

/// Area of a polygon, positive whichever way round, beyond y = 0: ∮ of what is clipped.
double area_beyond(const std::vector<Vec2>& points) {
    double twice = 0.0;
    const auto add = [&](Vec2 a, Vec2 b) { twice += cross(a, b); };
    Vec2 last;
    bool any = false;
    Vec2 first;
    const auto to = [&](Vec2 p) {
        if (any)
            add(last, p);
        else
            first = p;
        last = p;
        any = true;
    };
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 a = points[k], b = points[(k + 1) % points.size()];
        if (a.y >= 0.0) to(a);
        if ((a.y < 0.0) != (b.y < 0.0)) to({a.x - a.y / (b.y - a.y) * (b.x - a.x), 0.0});
    }
    if (any) add(last, first);
    return 0.5 * std::fabs(twice);
}

/// Length of the crossings' inside within [low, high].
double covered(const std::vector<LineCrossing>& crossings, double low, double high) {
    double length = 0.0;
    for (const auto& [along, turn] : crossings) length += turn * std::clamp(along, low, high);
    return std::fabs(length);
}

}  // namespace

SectionCells cells_on_section(const SectionLine& line, const Lattice& lattice,
                              const Suspension& cells) {
    SectionCells seen;
    seen.share_of_row.assign(line.rows.size(), 0.0);
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int c = 0; c < cells.cell_count(); ++c) {
        const std::vector<Vec2> points = seen_from(line, lattice, outline(cells, c));
        if (!is_near(points)) continue;
        const std::vector<LineCrossing> crossings = crossings_of(points);
        const double length = covered(crossings, line.begin, line.end);
        if (!(length > 0.0)) continue;  // in another channel
        seen.share += length / line.width();
        for (std::size_t k = 0; k < line.rows.size(); ++k)
            seen.share_of_row[k] += covered(crossings, line.rows[k], line.rows[k] + 1.0);
        for (const auto& [along, turn] : crossings) {
            low = std::min(low, along);
            high = std::max(high, along);
        }
    }
    seen.from_begin = low <= high ? low - line.begin : undefined;
    seen.from_end = low <= high ? line.end - high : undefined;
    return seen;
}

double carried_area(const Model& model, const State& state, std::size_t section) {
    const SectionLine& line = model.sections[section].line;
    const SectionState& passed = state.sections[section];
    const Suspension& cells = state.cells;
    double area = passed.area;
    for (int c = 0; c < cells.cell_count(); ++c) {
        const Outline shape = outline(cells, c);
        const std::vector<Vec2> points = seen_from(line, model.lattice, shape);
        if (!is_near(points) || !(covered(crossings_of(points), line.begin, line.end) > 0.0))
            continue;
        // A cell that is counted as beyond has all passed but for what has not; one that is not,
        // only what has: no jump as it is counted, wherever it was at the start.
        const auto id = static_cast<std::size_t>(cells.id[c]);
        const AreaMoments cell = area_moments(shape);
        int side = id < passed.side.size() ? passed.side[id] : 0;
        if (side == 0) side = from_section(line, model.lattice, cell.centroid).y < 0.0 ? -1 : 1;
        area += area_beyond(points) - (side > 0 ? cell.area : 0.0);
    }
    return area;
}

}  // namespace tt
