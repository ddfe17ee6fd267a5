#include "case/choose_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/feeds.hpp"
#include "case/kinds.hpp"
#include "case/openings.hpp"

namespace tt {
namespace {

/// Rows of sites, from `fewest` to `most`, that divide the length too into whole sites; 0: none.
int rows_that_divide(const Case& c, int fewest, int most) {
    for (int ny = fewest; ny <= most; ++ny) {
        const double sites = c.domain.length.si / c.domain.width.si * ny;
        if (std::fabs(sites - std::round(sites)) <= 1e-6 * sites) return ny;
    }
    return 0;
}

void choose_box_grid(const Case& c, Choice& choice) {
    const double width = c.domain.width.si, length = c.domain.length.si;
    const double radius = smallest_cell_radius(c).si;
    const double wanted = c.numerics.dx           ? c.numerics.dx->si
                          : c.numerics.fluid_only ? width / 50.0
                                                  : radius / 20.0;
    const int coarsest = std::max(4, static_cast<int>(std::lround(width / wanted)));
    choice.ny = rows_that_divide(c, coarsest, c.numerics.dx ? coarsest : 2 * coarsest);
    if (choice.ny > 0) {
        choice.nx = static_cast<int>(std::lround(length / width * choice.ny));
        choice.dx = Length{width / choice.ny};
    }
    const bool divides = std::fabs(choice.dx.si - wanted) <= 1e-6 * wanted;
    if (choice.ny == 0 || (c.numerics.dx && !divides)) {
        throw CaseError(
            {{"", 0, 0,
              fmt::format(
                  "[numerics] dx = {:.6g} um does not divide width {:.6g} um and length {:.6g} um "
                  "into whole sites; write dx = \"{:.6g} um\" or leave it out",
                  wanted * 1e6, width * 1e6, length * 1e6, width / coarsest * 1e6)}});
    }
}

/// Sites beyond the drawing. Behind a port that feeds cells wait to come in.
struct Margins {
    int left = network_margin, right = network_margin, below = network_margin,
        above = network_margin;
};
Margins network_margins(const Case& c, Length dx) {
    const Corners corners = corners_of(c.geometry.channels());
    const std::vector<Opening> openings = port_places(c).openings;
    const int room = network_margin + static_cast<int>(std::ceil(room_at_feed(c).si / dx.si));
    Margins margins;
    for (std::size_t n = 0; n < openings.size(); ++n) {
        if (!lets_cells_in(c, c.ports[n])) continue;
        const Vec2 low{std::min(openings[n].from.x, openings[n].to.x),
                       std::min(openings[n].from.y, openings[n].to.y)};
        const Vec2 high = openings[n].from + openings[n].to - low;
        if (high.x - corners.low.x < dx.si) margins.left = room;
        if (corners.high.x - low.x < dx.si) margins.right = room;
        if (high.y - corners.low.y < dx.si) margins.below = room;
        if (corners.high.y - low.y < dx.si) margins.above = room;
    }
    return margins;
}

void choose_network_grid(const Case& c, Choice& choice) {
    const double width = c.domain.width.si, length = c.domain.length.si;
    double narrowest = width;
    for (const Opening& opening : port_places(c).openings)
        narrowest = std::min(narrowest, width_of(opening));
    const double wanted = c.numerics.dx           ? c.numerics.dx->si
                          : c.numerics.fluid_only ? narrowest / 16.0
                                                  : smallest_cell_radius(c).si / 20.0;
    const int rows = static_cast<int>(std::ceil(width / wanted * (1.0 - 1e-9)));
    const int dividing = c.numerics.dx ? 0 : rows_that_divide(c, rows, rows + rows / 4);
    choice.dx = Length{dividing > 0 ? width / dividing : wanted};
    const auto sites = [&](double size) {
        return static_cast<int>(std::ceil(size / choice.dx.si * (1.0 - 1e-9)));
    };
    const Margins margins = network_margins(c, choice.dx);
    choice.nx = margins.left + sites(length) + margins.right;
    choice.ny = margins.below + sites(width) + margins.above;
    choice.origin = corners_of(c.geometry.channels()).low -
                    choice.dx.si * Vec2{double(margins.left), double(margins.below)};
}

}  // namespace

Length fitting_spacing(const Case& c, Length most) {
    const double width = c.domain.width.si;
    const int fewest = std::max(4, static_cast<int>(std::ceil(width / most.si * (1.0 - 1e-9))));
    const int rows = rows_that_divide(c, fewest, 2 * fewest);
    return rows > 0 ? Length{width / rows} : most;
}

void choose_grid(const Case& c, Choice& choice) {
    c.network() ? choose_network_grid(c, choice) : choose_box_grid(c, choice);
}

}  // namespace tt
