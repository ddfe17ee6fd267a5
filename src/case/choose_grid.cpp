#include "case/choose_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
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
    const double radius = equivalent_radius(c).si;
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

void choose_network_grid(const Case& c, Choice& choice) {
    const double width = c.domain.width.si, length = c.domain.length.si;
    double narrowest = width;
    for (const Opening& opening : port_places(c).openings)
        narrowest = std::min(narrowest, width_of(opening));
    const double wanted = c.numerics.dx           ? c.numerics.dx->si
                          : c.numerics.fluid_only ? narrowest / 16.0
                                                  : equivalent_radius(c).si / 20.0;
    const int rows = static_cast<int>(std::ceil(width / wanted * (1.0 - 1e-9)));
    const int dividing = c.numerics.dx ? 0 : rows_that_divide(c, rows, rows + rows / 4);
    choice.dx = Length{dividing > 0 ? width / dividing : wanted};
    const auto sites = [&](double size) {
        return static_cast<int>(std::ceil(size / choice.dx.si * (1.0 - 1e-9))) + 2 * network_margin;
    };
    choice.nx = sites(length);
    choice.ny = sites(width);
    const Vec2 margin{network_margin * choice.dx.si, network_margin * choice.dx.si};
    choice.origin = corners_of(c.geometry.channels()).low - margin;
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
