#include "case/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "base/units.hpp"
#include "case/contact_at_start.hpp"
#include "case/kinds.hpp"
#include "case/membrane_of.hpp"
#include "case/plausibility.hpp"
#include "membrane/outline_checks.hpp"
#include "membrane/stability.hpp"

namespace tt {
namespace {

/// Collects advice.
class Adviser {
public:
    template <class... Args>
    void consider(fmt::format_string<Args...> format, Args&&... args) {
        advice.push_back(
            {Advice::Weight::consider, fmt::format(format, std::forward<Args>(args)...)});
    }
    template <class... Args>
    void refuse(fmt::format_string<Args...> format, Args&&... args) {
        advice.push_back(
            {Advice::Weight::refuse, fmt::format(format, std::forward<Args>(args)...)});
    }

    std::vector<Advice> advice;
};

void advise_on_step(const Case& c, const Choice& choice, const Appraisal& a, Adviser& adviser) {
    double tightest = 1e9;
    for (const Bound& b : a.bounds)
        if (b.name != "area pressure") tightest = std::min(tightest, b.margin());
    if (tightest < 1.0)
        adviser.refuse(
            "The time step {} is {:.3g} times too long to be stable: write dt = \"{}\" in "
            "[numerics], or "
            "leave dt, relaxation_time and density_scale out.",
            rounded_text(choice.dt, 3), 1.0 / tightest,
            rounded_text(Time{0.5 * tightest * choice.dt.si}, 2));
    for (const Bound& b : a.bounds)
        if (b.name == "area pressure" && b.margin() < 1.0)
            adviser.refuse(
                "area_stiffness = {} is stiffer than the lattice fluid can answer: write at most "
                "\"{}\" in "
                "[membrane], or leave it out.",
                rounded_text(choice.kinds[b.kind].area_stiffness, 3),
                rounded_text(
                    Pressure{safe_area_step_number(a.kinds[b.kind].radius_sites) / b.limit *
                             b.margin() * choice.kinds[b.kind].area_stiffness.si},
                    2));
    if (a.mach > largest_mach && a.mach <= mach_limit)
        adviser.consider(
            "Mach number {:.2g}: errors of compressibility of about {:.1f} %; halving dt quarters "
            "them.",
            a.mach, 100.0 * a.mach * a.mach);
    if (std::holds_alternative<Bgk>(c.numerics.collision) && a.tau_cytoplasm > 0.8)
        adviser.consider("BGK at relaxation time {:.3g} is off by {}; write collision = \"trt\".",
                         a.tau_cytoplasm, a.tau_cytoplasm > 2.0 ? "5 % and more" : "2 % and more");
    if (choice.relaxation_time < 0.55)
        adviser.consider(
            "Relaxation time {:.3g} is close to the limit 1/2 of stability; write relaxation_time "
            "= 1.",
            choice.relaxation_time);
}

/// A step that the user gave, longer than a limit of accuracy allows.
void advise_on_change(const Case& c, const Choice& choice, const Appraisal& a, Adviser& adviser) {
    for (const StepLimit& limit : choice.limits) {
        const double change = limit.change * (choice.dt.si / limit.step.si);
        if (change < 1.01 * c.numerics.step_tolerance || limit.change == 0.0) continue;
        if (choice.density_scale <= 1.0 + 1e-9) continue;  // what it does is physics
        adviser.consider(
            "The time step may change D, strain, lambda_C and mu_rel by {} %, by its {} ({}). "
            "Write dt = \"{}\", or leave dt and density_scale out.",
            rounded_text(100.0 * change, Dimension{}, 2), limit.name, limit.reason,
            rounded_text(limit.step, 2));
    }
    if (a.cells == 0 || a.transits == 0.0 ||
        !std::holds_alternative<LinearEquilibrium>(choice.equilibrium))
        return;
    adviser.consider(
        "With equilibrium = \"linear\" and a raised density a cell that the flow carries along "
        "feels its own speed, which slows its way to the middle. Write equilibrium = "
        "\"incompressible\".");
}

/// A site spacing [m] to write: at most this, and one that divides the box.
std::string spacing_text(const Case& c, double most) {
    return rounded_text(fitting_spacing(c, Length{most}), 7);
}

/// Below that a run in a fast flow blows up sooner or later, whatever the time step: seen from 6e-5
/// on, and not at 5e-4.
constexpr double smallest_viscosity_ratio = 5e-4;

void advise_on_resolution(const Case& c, const Choice& choice, const Appraisal& a,
                          Adviser& adviser) {
    if (a.cells == 0) return;
    const KindFigures& smallest = *std::min_element(
        a.kinds.begin(), a.kinds.end(),
        [](const auto& one, const auto& other) { return one.radius_sites < other.radius_sites; });
    if (smallest.radius_sites < 9.5)
        adviser.consider("{:.3g} sites to the radius of a cell{} are few; write dx = \"{}\".",
                         smallest.radius_sites,
                         smallest.name.empty() ? "" : fmt::format(" of kind '{}'", smallest.name),
                         spacing_text(c, choice.dx.si * smallest.radius_sites / 16.0));
    if (a.start_turn_deg > largest_turn_deg || a.start_radius < smallest_radius_sites)
        adviser.consider(
            "The shape at the start is not resolved: it turns by {:.0f} degrees between segments, "
            "radius of curvature {:.2g} sites. Write dx = \"{}\".",
            a.start_turn_deg, a.start_radius,
            spacing_text(c, choice.dx.si * std::min(0.5 * largest_turn_deg / a.start_turn_deg,
                                                    0.5 * a.start_radius / smallest_radius_sites)));
    // A membrane under the compression E_s, the most that it takes, buckles at the wavelength
    // 2π √(E_b/E_s): four segments to it (docs/decisions/0011-checks.md).
    constexpr double shortest = 2.0 / std::numbers::pi;
    const bool moves = choice.shear_rate.si > 0.0 && !is_drop(c.membrane);
    if (moves && a.bending_length > 0.0 && a.bending_length < shortest)
        adviser.consider(
            "The bending length sqrt(E_b/E_s) is {:.2g} sites: a membrane that the flow compresses "
            "buckles below the grid and crumples. Write dx = \"{}\".",
            a.bending_length, spacing_text(c, choice.dx.si * a.bending_length / shortest));
    if (a.node_distance < 0.35 || a.node_distance > 1.55)
        adviser.consider(
            "Nodes {:.2g} sites apart; between 0.35 and 1.5 the result hardly depends on it. Leave "
            "node_spacing out.",
            a.node_distance);
    if (std::holds_alternative<SharpInterface>(c.numerics.interface_viscosity) &&
        a.viscosity_ratio > 1.5)
        adviser.consider(
            "With a sharp jump of viscosity the error does not fall as dx^2 (studies/interface). "
            "Write interface_viscosity = \"area-fraction\".");
    if (a.viscosity_ratio < smallest_viscosity_ratio)
        adviser.refuse(
            "Viscosity ratio {:.2g}: what is inside the cells is too thin to be computed beside "
            "what "
            "is outside. Write cytoplasm_viscosity = \"{}\" in [cells], or more.",
            a.viscosity_ratio,
            rounded_text(Viscosity{2.0 * smallest_viscosity_ratio * c.plasma.viscosity.si}, 2));
    if (std::max(a.viscosity_ratio, 1.0 / a.viscosity_ratio) > largest_corrected_contrast) {
        if (choice.jump_correction)
            adviser.refuse(
                "Viscosity ratio {:.3g}: with the jump at the membrane corrected, segments fold "
                "whatever the time step. Write jump_correction = false in [numerics], or leave it "
                "out.",
                a.viscosity_ratio);
        else
            adviser.consider(
                "Viscosity ratio {:.3g} is beyond what the jump at the membrane can be corrected "
                "for (1/20 to 20): the error falls as dx only. At ratio 50 and 100, with 20 sites "
                "to the radius, D was 9 to 24 % high.",
                a.viscosity_ratio);
    }
    if (a.contact_distance > 0.0 && a.cells > 1 && a.contact_distance < 1.5)
        adviser.consider(
            "zero_force_distance is {:.2g} sites, so gaps between cells are not resolved; write dx "
            "= \"{}\".",
            a.contact_distance, spacing_text(c, 0.5 * a.contact_distance * choice.dx.si));
}

void advise_on_outline(const Case& c, const State& initial, Adviser& adviser) {
    const std::vector<Case> kinds = cases_by_kind(c);
    const std::vector<std::int32_t>& kind_of = initial.cells.kind;
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        const CellOutline* drawn = kinds[n].cells.outline();
        const auto first = std::find(kind_of.begin(), kind_of.end(), static_cast<std::int32_t>(n));
        if (!drawn || first == kind_of.end()) continue;
        for (const std::string& remark : drawn->remarks) adviser.consider("{}", remark);
        constexpr double site = 1.0;
        if (self_approach(outline(initial.cells, static_cast<int>(first - kind_of.begin())), site))
            adviser.consider(
                "Two parts of the outline {} are less than a site apart: what lies between them is "
                "not resolved. Write a smaller dx.",
                drawn->file);
    }
}

void advise_on_drawing(const Case& c, Adviser& adviser) {
    const auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape);
    if (!drawn) return;
    for (const std::string& remark : drawn->remarks) adviser.consider("{}", remark);
}

void advise_on_physics(const Case& c, const Appraisal& a, Adviser& adviser) {
    if (a.cells == 0) return;
    const std::vector<Case> kinds = cases_by_kind(c);
    const auto any = [&](auto&& of_kind) {
        return std::any_of(kinds.begin(), kinds.end(), of_kind);
    };
    const auto unbending = [](const Case& k) { return k.membrane.bending_modulus.si == 0.0; };
    const auto as_printed = [](const Case& k) {
        const HardeningCase& hardening = k.membrane.hardening;
        return hardening.compression == Hardening::Compression::as_printed &&
               !hardening.apply_to.empty();
    };
    if (any(unbending) && a.shear_number >= 0.5)
        adviser.consider(
            "Without bending stiffness the membrane wrinkles at G >= 0.5; write bending_modulus.");
    // Two cells in a channel, circles or biconcave, two grids: ran at 0.75, three of four broke
    // at 1.
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        const MembraneCase& membrane = kinds[n].membrane;
        const bool stiffens = !membrane.hardening.apply_to.empty() ||
                              std::holds_alternative<Skalak>(membrane.law) || is_drop(membrane);
        if (c.flow.channel() && a.cells > 1 && !stiffens && a.kinds[n].shear_number > 0.75)
            adviser.consider(
                "G = {:.3g}: several cells whose tension does not harden ran in a channel at G = "
                "0.75, and at 1 most broke. Write a slower flow, or [membrane.hardening].",
                a.kinds[n].shear_number);
    }
    if (any(as_printed))
        adviser.consider(
            "Eq. 12 as printed softens in compression, and segments fold within about 1 ms; write "
            "compression = \"symmetric\".");
    if (c.flow.shear() && a.strained_time < 15.0)
        adviser.consider(
            "k t = {:.3g} at the end; a cell is steady after k t = 16, 27, 47 at G = 0.2, 0.5, 1 "
            "and "
            "viscosity ratio 5. Write end = \"{}\".",
            a.strained_time, rounded_text(Time{c.time.end.si * 20.0 / a.strained_time}, 2));
    for (const KindFigures& kind : a.kinds) {
        constexpr double folds = 5.0;
        const double wanted = folds * kind.settling_time();
        if (kind.stretching_viscosity == 0.0 || !c.flow.shear() || a.strained_time >= wanted)
            continue;
        adviser.consider(
            "The viscosity of the membrane, Bq = {:.3g}, slows the way to the steady state: k t = "
            "{:.3g} brings it nearer by a factor of e, and the run has {:.3g}. Write end = \"{}\".",
            kind.stretching_viscosity, kind.settling_time(), a.strained_time,
            rounded_text(Time{c.time.end.si * wanted / a.strained_time}, 2));
    }
    if (a.transits > 0.0 && a.transits < 5.5)
        adviser.consider(
            "{:.2g} transits; five should be left out before averaging. Write end = \"{}\".",
            a.transits, rounded_text(Time{c.time.end.si * 10.0 / a.transits}, 2));
    else if (a.transits > 0.0) {
        const double from = c.time.average_from ? c.time.average_from->si : 0.5 * c.time.end.si;
        const double before = a.transits * from / c.time.end.si;
        if (before < 4.9)
            adviser.consider(
                "Averages start after {:.2g} transits; five should be left out. Write average_from "
                "= \"{}\".",
                before, rounded_text(Time{c.time.end.si * 5.0 / a.transits}, 3));
    }
}

}  // namespace

std::vector<Advice> advice_on(const Case& c, const Choice& choice, const Model& model,
                              const State& initial, const Appraisal& a) {
    Adviser adviser;
    advise_on_step(c, choice, a, adviser);
    advise_on_change(c, choice, a, adviser);
    advise_on_resolution(c, choice, a, adviser);
    advise_on_outline(c, initial, adviser);
    advise_on_drawing(c, adviser);
    advise_on_physics(c, a, adviser);
    if (const auto why = bursting_contact(c, model, initial)) adviser.refuse("{}", *why);
    const std::vector<Advice> unusual = implausible_numbers(c, choice, a);
    adviser.advice.insert(adviser.advice.end(), unusual.begin(), unusual.end());
    return std::move(adviser.advice);
}

}  // namespace tt
