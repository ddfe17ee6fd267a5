#include "case/choose.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "case/channel_flow.hpp"
#include "case/choose_grid.hpp"
#include "case/choose_network.hpp"
#include "base/processors.hpp"
#include "case/feeds.hpp"
#include "case/kinds.hpp"
#include "case/membrane_of.hpp"
#include "case/sections.hpp"
#include "case/walls_of.hpp"
#include "membrane/stability.hpp"

namespace tt {
namespace {

/// Nominal shear rate, largest speed, pressure gradient. Returns their magnitudes: no limit of the
/// step depends on the direction.
Undisturbed choose_flow(const Case& c, Choice& choice) {
    const double width = c.domain.width.si, viscosity = c.plasma.viscosity.si;
    const FlowCase& flow = c.flow;
    if (c.network()) return choose_network_flow(c, choice);
    double at_walls = 0.0, fastest = 0.0;  // of the shear rate and the width
    if (const ShearDrive* shear = flow.shear()) {
        const Case first = cases_by_kind(c).front();
        choice.shear_rate = Rate{shear->shear_rate ? shear->shear_rate->si
                                                   : shear->shear_number.value_or(0.0) *
                                                         first.membrane.shear_modulus.si /
                                                         (viscosity * equivalent_radius(first).si)};
        at_walls = 1.0, fastest = 0.5;
    } else if (flow.channel()) {
        // Poiseuille: U = g H²/(12 μ), largest speed 3/2 U, shear rate at the walls 6 U/H.
        choice.shear_rate = pseudo_shear_rate(c);
        choice.pressure_gradient =
            PressureGradient{12.0 * viscosity * choice.shear_rate.si / width};
        at_walls = 6.0, fastest = 1.5;
        if (const UndisturbedFlow* plasma = choice.undisturbed.get()) {
            // U = g G/(μ H), G the conductance; by how many times that is less than of Poiseuille.
            const double resistance = std::pow(choice.ny, 3) / (12.0 * plasma->conductance);
            if (flow.channel()->pressure_gradient)
                choice.shear_rate = Rate{choice.shear_rate.si / resistance};
            else
                choice.pressure_gradient =
                    PressureGradient{choice.pressure_gradient.si * resistance};
            at_walls = plasma->steepest * choice.ny, fastest = plasma->fastest;
        }
    }
    const double k = std::abs(choice.shear_rate.si);
    choice.largest_speed = Velocity{fastest * k * width};
    return {Rate{k}, Rate{at_walls * k}, choice.largest_speed};
}

/// Where it changes in time, as large as it becomes: of a network the sum of all it may be.
Undisturbed at_its_largest(const Case& c, Undisturbed flow, Choice& choice) {
    double largest = largest_factor(c.flow.waveform);
    for (const PortCase& port : c.ports) largest = std::max(largest, largest_factor(port.waveform));
    flow.wall_rate.si *= largest;
    flow.largest_speed.si *= largest;
    choice.largest_speed = flow.largest_speed;
    return flow;
}

/// The relaxation time that allows the longest step, in hundredths; of equals the nearest to the
/// usual one, so that stress follows no later than it need. Inertia asks for a small S and with it
/// for a large τ, stress delay and stability for a small one: the longest step has one hill.
template <class StepAt>
double of_longest_step(StepAt&& step_at) {
    constexpr int fewest = 100, usual = 150, most = 400;
    const auto step = [&](int hundredths) { return step_at(hundredths / 100.0); };
    int best = usual;
    while (best < most && step(best + 1) > step(best)) ++best;
    while (best > fewest && step(best - 1) > step(best)) --best;
    return best / 100.0;
}

/// Of all kinds.
std::vector<StepLimit> limits_of_kinds(const Case& c, const std::vector<Case>& kinds,
                                       const Undisturbed& flow, const Choice& choice, double tau) {
    std::vector<std::vector<StepLimit>> limits;
    for (std::size_t n = 0; n < kinds.size(); ++n)
        limits.push_back(step_limits(kinds[n], flow, choice.equilibrium, choice.dx, tau,
                                     choice.kinds[n].expected_stretch,
                                     membrane_of(kinds[n].membrane, Scales{})));
    return tightest_of_kinds(limits, c.kinds);
}

/// Of Δt, τ and S: what is given stays, the rest follows. Which τ `auto` takes does not depend on
/// the other two, so that with them all limits of accuracy move in proportion.
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
    const std::vector<Case> kinds = cases_by_kind(c);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        choice.kinds[kind].expected_stretch =
            expected_stretch(kinds[kind], flow, membrane_of(kinds[kind].membrane, Scales{}));
    const auto limits_at = [&](double tau) { return limits_of_kinds(c, kinds, flow, choice, tau); };
    choice.relaxation_time =
        n.relaxation_time ? *n.relaxation_time
        : n.dt && n.density_scale
            ? 0.5 + n.dt->si / (*n.density_scale * unit)
            : of_longest_step([&](double tau) { return limits_at(tau).front().step.si; });
    choice.limits = limits_at(choice.relaxation_time);
    const double half_step = choice.relaxation_time - 0.5;
    choice.dt = n.dt              ? *n.dt
                : n.density_scale ? Time{half_step * *n.density_scale * unit}
                                  : choice.limits.front().step;
    choice.density_scale = choice.dt.si / (half_step * unit);
    constexpr double most = 1e12;  // a year at 30 000 steps a second
    if (c.time.end.si / choice.dt.si > most)
        throw CaseError(
            {{"", 0, 0,
              fmt::format("[time] end = {} takes {:.2g} steps of {}, and at most {:.0g} "
                          "are possible; write end = \"{}\"",
                          to_text(c.time.end), c.time.end.si / choice.dt.si,
                          rounded_text(choice.dt), most,
                          rounded_text(Time{0.9 * most * choice.dt.si}, 2))}});
}

/// Without advection and at a raised density a cell that is carried along feels its own speed
/// (docs/theory/fluid.md); at rest in a shear flow it is better off without inertia.
Equilibrium choose_equilibrium(const Case& c) {
    if (c.numerics.equilibrium) return *c.numerics.equilibrium;
    if (carries_cells(c)) return IncompressibleEquilibrium{};
    return LinearEquilibrium{};
}

/// The narrower kernel has about half the error. But where the viscosities differ much, its
/// correction of the jump answers node-sized wiggles the wrong way round
/// (docs/theory/interface.md).
Delta choose_delta(const Case& c) {
    if (c.numerics.delta) return *c.numerics.delta;
    constexpr double largest = 10.0 * (1.0 + 1e-9);  // "12 cP" over "1.2 cP" is 10.000000000000002
    if (viscosity_contrast(c) <= largest) return Roma3{};
    return Peskin4{};
}

/// Rounded to single precision, fields change what is measured by less than a tenth of such a
/// tolerance (studies/precision). A channel without cells is there for its exact answer.
Precision choose_precision(const Case& c) {
    if (c.numerics.precision) return *c.numerics.precision;
    constexpr double smallest = 0.01 * (1.0 - 1e-9);
    return !c.numerics.fluid_only && c.numerics.step_tolerance >= smallest ? Precision::fp32
                                                                           : Precision::fp64;
}

/// Where the viscosities differ by more the correction takes off more than node-sized wiggles move,
/// and they grow whatever the time step (docs/theory/interface.md).
bool choose_jump_correction(const Case& c) {
    return c.numerics.jump_correction.value_or(viscosity_contrast(c) <= largest_corrected_contrast);
}

/// k_p: well within what the lattice fluid's compressibility allows, at most 10 kPa. Of a cell
/// whose area is held it does not matter.
Pressure choose_area_stiffness(const Case& c, const Choice& choice, double expected_stretch) {
    if (c.membrane.area_stiffness) return *c.membrane.area_stiffness;
    const double fluid = c.plasma.viscosity.si / ((choice.relaxation_time - 0.5) * choice.dt.si);
    const Hardening hardening = hardening_of(c.membrane.hardening);
    const double alpha = hardening.area ? hardening(expected_cell_stretch(expected_stretch)) : 1.0;
    const double radius = equivalent_radius(c).si / choice.dx.si;
    const double number = safe_area_step_number(c.membrane.hold_area ? HUGE_VAL : radius) / alpha;
    return Pressure{std::min(1e4, std::min(5.0, number) * fluid)};
}

}  // namespace

double Choice::cell_reynolds(const Case& c) const {
    const double radius = largest_cell_radius(c).si;
    return density_scale * c.plasma.density.si * std::abs(shear_rate.si) * radius * radius /
           c.plasma.viscosity.si;
}

double Choice::expected_change() const {
    double change = 0.0;
    for (const StepLimit& limit : limits)
        change = std::max(change, limit.change * (dt.si / limit.step.si));
    return change;
}

double node_spacing(const Case& c) {
    return c.numerics.node_spacing.value_or(is_drop(c.membrane) ? 1.0 : 1.5);
}

void expect_sites(const Case& c, const Choice& choice, double most, const std::string& why) {
    const double sites = static_cast<double>(choice.nx) * choice.ny, dx = choice.dx.si;
    if (sites <= most) return;
    // Coarser by a whole number that divides both sides, as far as that is allowed; else the longer
    // side shorter.
    const double narrowest = c.domain.width.si / 6.0, smallest = smallest_cell_radius(c).si / 4.0;
    const double coarsest = c.numerics.fluid_only ? narrowest : std::min(narrowest, smallest);
    int factor = static_cast<int>(std::ceil(std::sqrt(sites / most)));
    while (factor * dx <= coarsest && (choice.nx % factor != 0 || choice.ny % factor != 0))
        ++factor;
    const auto write = [](const char* key, double length) {
        return fmt::format("{} = \"{}\"", key, rounded_text(Length{length}, 9));
    };
    const bool is_long = choice.nx >= choice.ny;
    const double left = std::floor(most / std::min(choice.nx, choice.ny)) * dx;
    throw CaseError({{"", 0, 0,
                      fmt::format("[domain] the box has {:.3g} sites of {}, and at most {:.3g} {}; "
                                  "write {}",
                                  sites, rounded_text(choice.dx), most, why,
                                  factor * dx <= coarsest ? write("dx", factor * dx)
                                  : is_long               ? write("length", left)
                                                          : write("width", left))}});
}

Lattice lattice_of(const Case& c, const Choice& choice) {
    return {choice.nx, choice.ny, c.domain.sides == Sides::walls && !c.network()};
}

/// Walls that are not those of the lattice, and what plasma alone does between them.
void choose_walls(const Case& c, Choice& choice) {
    if (c.geometry.straight()) {
        choice.sections = lattice_sections(c, choice, nullptr);
        return;
    }
    constexpr double most = 4e6;
    expect_sites(c, choice, most, "can be had between walls of any shape");
    const Solid solid = scaled(moved(solid_of(c), -choice.origin), 1.0 / choice.dx.si);
    auto walls = std::make_shared<const Walls>(make_walls(solid, lattice_of(c, choice)));
    std::vector<std::string> messages = faults_of(*walls, choice.dx.si);
    for (std::size_t n = 0; n < walls->openings.size(); ++n)
        if (walls->openings[n].width == 0)
            messages.push_back(
                fmt::format("[port.{}] no fluid lies beside it on the grid; write a "
                            "smaller dx, or draw a wider channel there",
                            c.ports[n].name));
    for (std::string& message : faults_of_feeds(c, choice, *walls))
        messages.push_back(std::move(message));
    if (!messages.empty()) {
        std::vector<Fault> faults;
        for (const std::string& message : messages) faults.push_back({"", 0, 0, message});
        throw CaseError(std::move(faults));
    }
    choice.sections = lattice_sections(c, choice, walls.get());
    std::vector<SectionLine> lines;
    for (const Section& section : choice.sections) lines.push_back(section.line);
    const int threads = usable_processors();
    choice.undisturbed = std::make_shared<const UndisturbedFlow>(
        c.network() ? undisturbed_flow(*walls, slow_ports(c, choice, *walls), lines, threads)
                    : undisturbed_flow(*walls, lines, threads));
    choice.walls = std::move(walls);
    for (std::size_t n = 0; n < lines.size(); ++n)
        choice.sections[n].plasma = choice.undisturbed->sections[n];
}

Choice choose(const Case& c) {
    Choice choice;
    const std::vector<Case> kinds = cases_by_kind(c);
    choice.kinds.resize(kinds.size());
    choose_grid(c, choice);
    expect_sites(c, choice, most_sites, "are possible");
    choose_walls(c, choice);
    choice.equilibrium = choose_equilibrium(c);
    choice.delta = choose_delta(c);
    choice.precision = choose_precision(c);
    choice.jump_correction = choose_jump_correction(c);
    choose_step(c, at_its_largest(c, choose_flow(c, choice), choice), choice);
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        KindChoice& kind = choice.kinds[n];
        kind.node_spacing = node_spacing(kinds[n]);
        kind.area_stiffness = choose_area_stiffness(kinds[n], choice, kind.expected_stretch);
    }
    return choice;
}

}  // namespace tt
