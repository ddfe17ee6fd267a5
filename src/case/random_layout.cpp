#include "case/random_layout.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/growth.hpp"
#include "case/pressing.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

/// Between membranes of cells that wander, and the most that pressed ones ask for [sites].
constexpr double widest_gap = 1.0;

/// Wandering pays in small suspensions and where they are dilute: so many sweeps at most, and so
/// many moves.
constexpr int most_sweeps = 4000, most_moves = 200'000;

void wander(Growth& growth, int count, const LayoutWatch& watch) {
    double growing = 0.1;
    const int sweeps = std::min(most_sweeps, most_moves / count);
    for (int sweep = 0; sweep < sweeps && growth.scale() < 1.0; ++sweep) {
        growth.sweep();
        growing = growth.grow(1.0 + growing) ? std::min(0.1, 1.2 * growing)
                                             : std::max(1e-4, 0.8 * growing);
        if (watch) watch(count, growth.scale() * growth.scale());
    }
}

/// Of one sheet that two membranes of cells with this outline may leave free between them.
double gap_of(const std::vector<Vec2>& shape) {
    const double thickness = 2.0 * area_of(shape) / perimeter_of(shape);
    return std::min(widest_gap, 0.1 * thickness);
}

}  // namespace

RandomLayout lay_at_random(const std::vector<Vec2>& shape, int count, const Room& room,
                           std::uint64_t seed, const LayoutWatch& watch) {
    Growth growth(shape, count, room, widest_gap, seed);
    wander(growth, count, watch);
    if (growth.scale() >= 1.0) return {growth.cells()};
    Pressing pressing(shape, room, gap_of(shape));
    for (const Placement& cell : growth.cells()) pressing.add(cell.centre, cell.angle);
    const double scale = pressing.press(growth.scale(), [&](double filled) {
        if (watch) watch(count, filled);
    });
    return {pressing.cells(), scale, pressing.visits()};
}

std::vector<Placement> random_placements(const std::vector<Vec2>& shape, int count,
                                         const Room& room, std::uint64_t seed,
                                         const LayoutWatch& watch, const std::string& where) {
    RandomLayout layout = lay_at_random(shape, count, room, seed, watch);
    if (layout.scale >= 1.0) return std::move(layout.cells);
    int fewer = count;
    while (layout.scale < 1.0 && fewer > 1) {
        fewer = std::clamp(static_cast<int>(fewer * layout.scale * layout.scale), 1, fewer - 1);
        layout = lay_at_random(shape, fewer, room, seed, watch);
    }
    const double one = 100.0 * area_of(shape) / room.area();
    if (layout.scale < 1.0)
        throw CaseError({{"", 0, 0,
                          where + ": not one cell fits into the box; make it smaller or the box "
                                  "larger"}});
    throw CaseError(
        {{"", 0, 0,
          fmt::format("{}: no room for {} cells; hematocrit {:.1f} % was "
                      "reached of {:.1f} %: write count = {}, or at most hematocrit = \"{:.1f} %\"",
                      where, count, fewer * one, count * one, fewer,
                      std::floor(10.0 * fewer * one) / 10.0)}});
}

}  // namespace tt
