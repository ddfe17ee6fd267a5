#include "app/check_kinds.hpp"

#include <string>

#include <fmt/format.h>

#include "app/check_walls.hpp"

namespace tt {

void print_kinds(const Appraisal& a) {
    if (a.kinds.size() < 2) return;
    for (const KindFigures& kind : a.kinds)
        print_line("kind " + kind.name,
                   fmt::format("{} cell{}, radius {:.3g} sites, {}", kind.cells,
                               kind.cells == 1 ? "" : "s", kind.radius_sites,
                               kind.rigid ? "rigid"
                                          : fmt::format("viscosity ratio {:.3g}, G = {}",
                                                        kind.viscosity_ratio,
                                                        plain(kind.shear_number, 3))));
}

void print_membrane_viscosity(const Appraisal& a) {
    for (const KindFigures& kind : a.kinds) {
        const std::string of = kind.name.empty() ? "" : " of kind " + kind.name;
        if (kind.stretching_viscosity > 0.0)
            print_line("viscosity eta_m",
                       fmt::format("Bq = eta_m/(mu a) = {}{}: slows start-up and recoil, k t = {} "
                                   "per e-fold; hardly changes steady tank-treading",
                                   plain(kind.stretching_viscosity, 3), of,
                                   plain(kind.settling_time(), 3)));
        if (kind.bending_viscosity > 0.0)
            print_line("viscosity eta_b",
                       fmt::format("Bb = eta_b/(mu a^3) = {}{}: less deformation and inclination, "
                                   "tumbling sooner",
                                   plain(kind.bending_viscosity, 3), of));
    }
}

}  // namespace tt
