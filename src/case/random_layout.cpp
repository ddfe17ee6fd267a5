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

/// Of one sheet that two membranes of cells with these outlines may leave free between them.
double gap_of(const std::vector<std::vector<Vec2>>& shapes) {
    double gap = widest_gap;
    for (const auto& shape : shapes)
        gap = std::min(gap, 0.1 * (2.0 * area_of(shape) / perimeter_of(shape)));
    return gap;
}

}  // namespace

RandomLayout lay_at_random(const Crowd& crowd, const Room& room, std::uint64_t seed,
                           const LayoutWatch& watch) {
    Growth growth(crowd, room, widest_gap, seed);
    wander(growth, crowd.count(), watch);
    if (growth.scale() >= 1.0) return {growth.cells()};
    Pressing pressing(crowd.shapes, room, gap_of(crowd.shapes));
    for (int cell = 0; cell < crowd.count(); ++cell) {
        const Placement& place = growth.cells()[static_cast<std::size_t>(cell)];
        pressing.add(crowd.shape_of[static_cast<std::size_t>(cell)], place.centre, place.angle);
    }
    const double scale = pressing.press(growth.scale(), [&](double filled) {
        if (watch) watch(crowd.count(), filled);
    });
    return {pressing.cells(), scale, pressing.visits()};
}

std::vector<Placement> random_placements(const Crowd& crowd, const Room& room, std::uint64_t seed,
                                         const LayoutWatch& watch, const std::string& where) {
    RandomLayout layout = lay_at_random(crowd, room, seed, watch);
    if (layout.scale >= 1.0) return std::move(layout.cells);
    const int count = crowd.count();
    int fewer = count;
    while (layout.scale < 1.0 && fewer > 1) {
        fewer = std::clamp(static_cast<int>(fewer * layout.scale * layout.scale), 1, fewer - 1);
        layout = lay_at_random(crowd.first(fewer), room, seed, watch);
    }
    if (layout.scale < 1.0)
        throw CaseError({{"", 0, 0,
                          where + ": not one cell fits into the box; make it smaller or the box "
                                  "larger"}});
    const double asked = 100.0 * crowd.area() / room.area();
    const double reached = 100.0 * crowd.first(fewer).area() / room.area();
    throw CaseError(
        {{"", 0, 0,
          fmt::format("{}: no room for {} cells; hematocrit {:.1f} % was "
                      "reached of {:.1f} %: write count = {}, or at most hematocrit = \"{:.1f} %\"",
                      where, count, reached, asked, fewer, std::floor(10.0 * reached) / 10.0)}});
}

}  // namespace tt
