#include "case/choose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "membrane/stability.hpp"

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

/// The undisturbed flow: nominal shear rate, largest speed, pressure gradient.
void choose_flow(const Case& c, Choice& choice) {
    const double width = c.domain.width.si, viscosity = c.plasma.viscosity.si;
    const FlowCase& flow = c.flow;
    if (flow.drive == "shear") {
        const double k = flow.shear_rate
                             ? flow.shear_rate->si
                             : flow.shear_number.value_or(0.0) * c.membrane.shear_modulus.si /
                                   (viscosity * equivalent_radius(c).si);
        choice.shear_rate = Rate{k};
        choice.largest_speed = Velocity{0.5 * k * width};
    } else if (flow.drive != "none") {
        // Poiseuille: U = g H²/(12 μ), largest speed 3/2 U.
        const double k = flow.pseudo_shear_rate
                             ? flow.pseudo_shear_rate->si
                             : flow.pressure_gradient->si * width / (12.0 * viscosity);
        choice.shear_rate = Rate{k};
        choice.largest_speed = Velocity{1.5 * k * width};
        choice.pressure_gradient = PressureGradient{12.0 * viscosity * k / width};
    }
}

/// Time steps that each limit of `auto` allows at relaxation time τ, the tightest first. At fixed
/// τ, Δt ∝ S.
std::vector<StepLimit> step_limits(const Case& c, const Choice& choice, double tau) {
    std::vector<StepLimit> limits;
    const double dx = choice.dx.si, rho = c.plasma.density.si, mu = c.plasma.viscosity.si;
    const double radius = equivalent_radius(c).si, k = choice.shear_rate.si;
    const double step_of_unit_scale = (tau - 0.5) / 3.0 * dx * dx * rho / mu;
    if (k > 0.0 && !c.numerics.fluid_only) {
        const double reynolds = rho * k * radius * radius / mu;
        limits.push_back(
            {"Reynolds number", Time{step_of_unit_scale * auto_cell_reynolds / reynolds},
             fmt::format("cell Reynolds number S rho k a^2 / mu <= {} (physical: {:.2g})",
                         auto_cell_reynolds, reynolds)});
    }
    if (k > 0.0) {
        limits.push_back({"Mach number",
                          Time{auto_mach / std::sqrt(3.0) * dx / choice.largest_speed.si},
                          fmt::format("largest speed {:.3g} mm/s at Mach <= {}",
                                      choice.largest_speed.si * 1e3, auto_mach)});
    }
    if (!c.numerics.fluid_only) {
        const double slope = 3.0 * c.membrane.shear_modulus.si;
        limits.push_back({"membrane tension", Time{auto_tension_step_number * mu * dx / slope},
                          fmt::format("tension step number 3 E_s dt / (mu dx) <= {}",
                                      auto_tension_step_number)});
    }
    if (limits.empty())
        limits.push_back({"none", Time{step_of_unit_scale}, "nothing moves: S = 1"});
    std::sort(limits.begin(), limits.end(),
              [](const auto& a, const auto& b) { return a.step.si < b.step.si; });
    return limits;
}

/// Of Δt, τ and S: what is given stays, the rest follows.
void choose_step(const Case& c, Choice& choice) {
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
    choice.limits = step_limits(c, choice, choice.relaxation_time);
    choice.dt = n.dt              ? *n.dt
                : n.density_scale ? Time{half_step * *n.density_scale * unit}
                                  : choice.limits.front().step;
    choice.density_scale = choice.dt.si / (half_step * unit);
}

/// Without advection and at a raised density a cell that is carried along feels its own speed
/// (docs/theory/fluid.md); at rest in a shear flow it is better off without inertia.
std::string choose_equilibrium(const Case& c) {
    if (c.numerics.equilibrium != "auto") return c.numerics.equilibrium;
    const bool carried = c.flow.drive != "shear" && c.flow.drive != "none";
    return carried && !c.numerics.fluid_only ? "incompressible" : "linear";
}

/// k_p: well within what the lattice fluid's compressibility allows, at most 10 kPa.
Pressure choose_area_stiffness(const Case& c, const Choice& choice) {
    if (c.membrane.area_stiffness) return *c.membrane.area_stiffness;
    const double fluid = c.plasma.viscosity.si / ((choice.relaxation_time - 0.5) * choice.dt.si);
    return Pressure{std::min(1e4, auto_area_step_number * fluid)};
}

}  // namespace

double Choice::cell_reynolds(const Case& c) const {
    const double radius = equivalent_radius(c).si;
    return density_scale * c.plasma.density.si * shear_rate.si * radius * radius /
           c.plasma.viscosity.si;
}

Length equivalent_radius(const Case& c) {
    // The biconcave cell is named by its half length R₀; its area is 0.8916 R₀² (13.63 µm² at R₀
    // = 3.91 µm).
    if (c.cells.shape == "biconcave")
        return Length{c.cells.radius.si * std::sqrt(0.8916 / std::numbers::pi)};
    return c.cells.radius;
}

Choice choose(const Case& c) {
    Choice choice;
    choose_grid(c, choice);
    choose_flow(c, choice);
    choose_step(c, choice);
    choice.node_spacing = c.numerics.node_spacing.value_or(1.0);
    choice.equilibrium = choose_equilibrium(c);
    choice.area_stiffness = choose_area_stiffness(c, choice);
    return choice;
}

}  // namespace tt
