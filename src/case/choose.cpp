#include "case/choose.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/membrane_of.hpp"

namespace tt {
namespace {

/// Sites across the width such that the length is a whole number of sites too, at or just finer
/// than `dx`.
void choose_grid(const Case& c, Choice& choice) {
    const double width = c.domain.width.si, length = c.domain.length.si;
    const double radius = equivalent_radius(c).si;
    const double wanted = c.numerics.dx           ? c.numerics.dx->si
                          : c.numerics.fluid_only ? width / 50.0
                                                  : radius / 20.0;
    const int coarsest = std::max(4, static_cast<int>(std::lround(width / wanted)));
    const int finest = c.numerics.dx ? coarsest : 2 * coarsest;
    for (int ny = coarsest; ny <= finest; ++ny) {
        const double sites = length / width * ny;
        if (std::fabs(sites - std::round(sites)) > 1e-6 * sites) continue;
        choice.ny = ny;
        choice.nx = static_cast<int>(std::lround(sites));
        choice.dx = Length{width / ny};
        break;
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

/// Nominal shear rate, largest speed, pressure gradient.
Undisturbed choose_flow(const Case& c, Choice& choice) {
    const double width = c.domain.width.si, viscosity = c.plasma.viscosity.si;
    const FlowCase& flow = c.flow;
    Rate wall_rate;
    if (flow.drive == "shear") {
        const double k = flow.shear_rate
                             ? flow.shear_rate->si
                             : flow.shear_number.value_or(0.0) * c.membrane.shear_modulus.si /
                                   (viscosity * equivalent_radius(c).si);
        choice.shear_rate = wall_rate = Rate{k};
        choice.largest_speed = Velocity{0.5 * k * width};
    } else if (flow.drive != "none") {
        // Poiseuille: U = g H²/(12 μ), largest speed 3/2 U, shear rate at the walls 6 U/H.
        const double k = flow.pseudo_shear_rate
                             ? flow.pseudo_shear_rate->si
                             : flow.pressure_gradient->si * width / (12.0 * viscosity);
        choice.shear_rate = Rate{k};
        wall_rate = Rate{6.0 * k};
        choice.largest_speed = Velocity{1.5 * k * width};
        choice.pressure_gradient = PressureGradient{12.0 * viscosity * k / width};
    }
    return {choice.shear_rate, wall_rate, choice.largest_speed};
}

/// Of Δt, τ and S: what is given stays, the rest follows.
void choose_step(const Case& c, const Undisturbed& flow, Choice& choice) {
    const NumericsCase& n = c.numerics;
    const double dx = choice.dx.si, rho = c.plasma.density.si, mu = c.plasma.viscosity.si;
    const double unit = dx * dx * rho / (3.0 * mu);  // Δt = (τ − ½) S unit
    if (n.dt && n.relaxation_time && n.density_scale) {
        const double implied = (*n.relaxation_time - 0.5) * *n.density_scale * unit;
        if (std::fabs(implied - n.dt->si) > 1e-6 * implied) {
            throw CaseError({{"", 0, 0,
                              fmt::format("[numerics] dt, relaxation_time and density_scale "
                                          "contradict each other: the last "
                                          "two give dt = {:.6g} us; leave one of the three out",
                                          implied * 1e6)}});
        }
    }
    choice.relaxation_time = n.relaxation_time.value_or(
        n.dt && n.density_scale ? 0.5 + n.dt->si / (*n.density_scale * unit)
                                : auto_relaxation_time);
    const double half_step = choice.relaxation_time - 0.5;
    const Membrane membrane = membrane_of(c.membrane, Scales{});
    choice.expected_stretch = expected_stretch(c, flow, membrane);
    choice.limits = step_limits(c, flow, choice.equilibrium, choice.dx, choice.relaxation_time,
                                choice.expected_stretch, membrane);
    choice.dt = n.dt              ? *n.dt
                : n.density_scale ? Time{half_step * *n.density_scale * unit}
                                  : choice.limits.front().step;
    choice.density_scale = choice.dt.si / (half_step * unit);
}

/// Without advection and at a raised density a cell that is carried along feels its own speed
/// (docs/theory/fluid.md); at rest in a shear flow it is better off without inertia.
std::string choose_equilibrium(const Case& c) {
    if (c.numerics.equilibrium != "auto") return c.numerics.equilibrium;
    return carries_cells(c) ? "incompressible" : "linear";
}

/// The narrower kernel has about half the error. But where the viscosities differ much, its
/// correction of the jump answers node-sized wiggles the wrong way round
/// (docs/theory/interface.md).
std::string choose_delta(const Case& c) {
    if (c.numerics.delta != "auto") return c.numerics.delta;
    constexpr double largest = 10.0 * (1.0 + 1e-9);  // "12 cP" over "1.2 cP" is 10.000000000000002
    const double ratio = c.cells.cytoplasm_viscosity.si / c.plasma.viscosity.si;
    return std::max(ratio, 1.0 / ratio) <= largest ? "roma3" : "peskin4";
}

/// k_p: well within what the lattice fluid's compressibility allows, at most 10 kPa. Of a cell
/// whose area is held it does not matter.
Pressure choose_area_stiffness(const Case& c, const Choice& choice) {
    if (c.membrane.area_stiffness) return *c.membrane.area_stiffness;
    const double fluid = c.plasma.viscosity.si / ((choice.relaxation_time - 0.5) * choice.dt.si);
    const Hardening hardening = hardening_of(c.membrane.hardening);
    const double alpha =
        hardening.area ? hardening(expected_cell_stretch(choice.expected_stretch)) : 1.0;
    return Pressure{std::min(1e4, std::min(5.0, auto_area_step_number / alpha) * fluid)};
}

}  // namespace

double Choice::cell_reynolds(const Case& c) const {
    const double radius = equivalent_radius(c).si;
    return density_scale * c.plasma.density.si * shear_rate.si * radius * radius /
           c.plasma.viscosity.si;
}

double Choice::expected_change() const {
    double change = 0.0;
    for (const StepLimit& limit : limits)
        change = std::max(change, limit.change * (dt.si / limit.step.si));
    return change;
}

Choice choose(const Case& c) {
    Choice choice;
    choose_grid(c, choice);
    choice.equilibrium = choose_equilibrium(c);
    choice.delta = choose_delta(c);
    choose_step(c, choose_flow(c, choice), choice);
    choice.node_spacing = c.numerics.node_spacing.value_or(1.0);
    choice.area_stiffness = choose_area_stiffness(c, choice);
    return choice;
}

}  // namespace tt
