#include "verify/selftest.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "verify/balance.hpp"
#include "verify/cell.hpp"
#include "verify/drop.hpp"
#include "verify/fluid.hpp"

namespace tt {
namespace {

using Checks = std::vector<Check>;

Checks plain_channels() {
    return {{"Poiseuille, body force: error", 0.0, poiseuille_error(13, 0.3, DrivenBy::body_force),
             1e-12},
            {"Poiseuille, pressure ends: error", 0.0,
             poiseuille_error(13, 0.3, DrivenBy::pressure_ends), 1e-12},
            {"two-layer Couette: error", 0.0, two_layer_couette_error(), 1e-12}};
}

Checks vortices() {
    return {{"Taylor-Green: energy left", std::exp(-2.0), taylor_green_energy(32), 0.01}};
}

Checks sums() {
    const Drift drift = drift_of_relaxing_cell();
    return {{"net force of a membrane on the fluid", 0.0, drift.momentum, 1e-11},
            {"mass gained", 0.0, drift.mass, 1e-13}};
}

Checks bits() {
    return {{"same bits on 2 threads", 1.0, same_bits_on_threads(2) ? 1.0 : 0.0, 0.0},
            {"same bits on 3 threads", 1.0, same_bits_on_threads(3) ? 1.0 : 0.0, 0.0},
            {"same bits after a restart", 1.0, same_bits_after_restart() ? 1.0 : 0.0, 0.0}};
}

Checks resting_drop() {
    const LaplacePressure rest = laplace_pressure(12.0, 0.01);
    return {{"drop at rest: pressure jump R/gamma", 1.0, rest.ratio, 1e-3},
            {"  mu u/gamma left over", 0.0, rest.spurious_flow, 5e-4}};
}

Checks relaxing_drop() {
    DropScene coarse, fine;
    coarse.radius = 6.0;
    fine.radius = 12.0;
    coarse.box = 36.0;
    fine.box = 72.0;
    coarse.viscosity = fine.viscosity = 1.0;
    const double time =
        (4.0 * relaxation_time_ratio(fine, 4) - relaxation_time_ratio(coarse, 4)) / 3.0;
    return {{"drop relaxing: time of mode 4", 1.0, time, 0.02}};
}

Checks sheared_drop() {
    constexpr double capillary_number = 0.03;
    Checks checks;
    for (const double ratio : {1.0, 5.0}) {
        const DropInShear drop = drop_in_unbounded_shear(ratio, capillary_number, 4.0);
        checks.push_back({fmt::format("drop in shear, ratio {}: D", ratio),
                          drop_deformation(ratio, capillary_number), drop.taylor, 0.02});
        checks.push_back({"  intrinsic viscosity", drop_intrinsic_viscosity(ratio),
                          drop.intrinsic_viscosity, 0.03});
    }
    return checks;
}

Checks capsule(int viscosity_ratio, double until_strain, double taylor, double angle, double strain,
               double period) {
    const TankTreading is = tank_treading(capsule_case(viscosity_ratio), until_strain);
    const TankTreading must = exact_tank_treading(viscosity_ratio);
    return {{fmt::format("cell in shear, ratio {}: D", viscosity_ratio), must.taylor, is.taylor,
             taylor},
            {"  inclination [deg]", must.inclination_deg, is.inclination_deg,
             angle / must.inclination_deg},
            {"  strain", must.strain, is.strain, strain},
            {"  tank-treading period k", must.period, is.period, period}};
}

Checks soft_capsule() { return capsule(1, 7.0, 0.015, 0.6, 0.04, 0.02); }
Checks viscous_capsule() { return capsule(5, 16.0, 0.06, 0.8, 0.14, 0.05); }

Checks rigid_ellipse() {
    return {
        {"stiff ellipse: period/Jeffery's", 1.0, jeffery_period_ratio_of_rigid_ellipse(), 0.06}};
}

constexpr std::array<SelftestPart, 10> parts{{
    {"plain_channels", plain_channels},
    {"vortices", vortices},
    {"sums", sums},
    {"bits", bits},
    {"resting_drop", resting_drop},
    {"relaxing_drop", relaxing_drop},
    {"sheared_drop", sheared_drop},
    {"soft_capsule", soft_capsule},
    {"viscous_capsule", viscous_capsule},
    {"rigid_ellipse", rigid_ellipse},
}};

}  // namespace

std::span<const SelftestPart> selftest_parts() { return parts; }

}  // namespace tt
