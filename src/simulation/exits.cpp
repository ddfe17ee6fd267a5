#include "simulation/exits.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/outline.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {
namespace {

/// Nothing but fluid between a place and the exit ahead of it.
bool in_sight(const Exit& exit, const Walls& walls, Vec2 place, double way) {
    for (double at = 0.0; at < way - 0.5; at += 1.0) {
        const Vec2 p = place + at * exit.out;
        const int i = static_cast<int>(std::floor(p.x)), j = static_cast<int>(std::floor(p.y));
        if (!walls.is_open(i, j)) return false;
    }
    return true;
}

Departed departed(const Exit& exit, std::int64_t number, const State& state, int cell) {
    const Suspension& cells = state.cells;
    const Outline shape = outline(cells, cell);
    Departed d;
    d.id = cells.id[cell];
    d.time = static_cast<double>(state.step);
    d.exit = number;
    d.kind = cells.kind[cell];
    d.place = place_along(exit, middle_of(shape));
    d.area = area_moments(shape).area;
    d.lambda_C = perimeter(shape) / cells.reference_perimeter[cell];
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
        d.speed += dot(cells.velocity(n), exit.out) / shape.size();
        d.rest_length.push_back(cells.rest_length[n]);
    }
    return d;
}

void take_out(State& state, int cell) {
    const int begin = state.cells.first[cell], end = state.cells.first[cell + 1];
    for (auto* kept : {&state.interior.x, &state.interior.y})
        kept->erase(kept->begin() + begin, kept->begin() + end);
    remove_cell(state.cells, cell);
}

/// Of a cell with this middle, `way_to`.
double way_to(const Exit& exit, const Model& model, const Suspension& cells, int cell,
              Vec2 middle) {
    const Outline shape = outline(cells, cell);
    const Vec2 along = exit.to - exit.from;
    const double share = dot(middle - exit.from, along) / dot(along, along);
    const double way = dot(exit.from - middle, exit.out);
    const double farthest = exit.fade + kernel_reach + 0.5 * cells.perimeter[cell];
    if (share < 0.0 || share > 1.0 || way < 0.0 || way > farthest) return HUGE_VAL;
    if (!in_sight(exit, *model.boundaries.walls, middle, way)) return HUGE_VAL;
    double foremost = way;
    for (int k = 0; k < shape.size(); ++k)
        foremost = std::min(foremost, dot(exit.from - shape[k], exit.out));
    return foremost;
}

}  // namespace

double place_along(const Exit& exit, Vec2 point) {
    const Vec2 along = exit.to - exit.from;
    const double from = dot(point - exit.from, along) / norm(along);
    return along.x + along.y > 0.0 ? from : norm(along) - from;
}

double way_to(const Exit& exit, const Model& model, const Suspension& cells, int cell) {
    return way_to(exit, model, cells, cell, middle_of(outline(cells, cell)));
}

void fade_forces(const Model& model, Suspension& cells) {
    const auto [begin, end] = own_cells(cells);
    for (int c = begin; c < end; ++c) {
        const Vec2 middle = middle_of(outline(cells, c));
        double left = 1.0;
        for (const Exit& exit : model.exits)
            if (exit.fade > 0.0)
                left = std::min(left,
                                (way_to(exit, model, cells, c, middle) - kernel_reach) / exit.fade);
        if (left >= 1.0) continue;
        for (int n = cells.first[c]; n < cells.first[c + 1]; ++n) {
            cells.fx[n] *= std::max(left, 0.0);
            cells.fy[n] *= std::max(left, 0.0);
        }
    }
}

bool release_cells(const Model& model, State& state) {
    const std::size_t before = state.departed.size();
    for (int c = 0; c < state.cells.cell_count();) {
        const Vec2 middle = middle_of(outline(state.cells, c));
        bool leaves = false;
        const bool led = state.cells.led[static_cast<std::size_t>(c)] != 0;
        for (std::size_t n = 0; n < model.exits.size() && !leaves && !led; ++n) {
            leaves = way_to(model.exits[n], model, state.cells, c, middle) < kernel_reach;
            if (leaves)
                state.departed.push_back(
                    departed(model.exits[n], static_cast<std::int64_t>(n), state, c));
        }
        if (leaves)
            take_out(state, c);
        else
            ++c;
    }
    return state.departed.size() > before;
}

}  // namespace tt
