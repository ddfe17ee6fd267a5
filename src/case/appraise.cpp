#include "case/appraise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <variant>

#include "base/error.hpp"
#include "base/units.hpp"
#include "case/contact_at_start.hpp"
#include "case/plausibility.hpp"
#include "membrane/outline.hpp"
#include "membrane/outline_checks.hpp"
#include "membrane/stability.hpp"
#include "observe/checks.hpp"
#include "simulation/schedule.hpp"

namespace tt {
namespace {

constexpr double mach_limit =
    2.0 * largest_mach;  // beyond, the error of compressibility, of order Ma², passes a tenth

/// What of the membranes the grid must resolve.
void resolve(const Case& c, const Choice& choice, const Suspension& cells, Appraisal& a) {
    const double modulus = c.membrane.shear_modulus.si;
    if (modulus > 0.0)
        a.bending_length = std::sqrt(c.membrane.bending_modulus.si / modulus) / choice.dx.si;
    if (const MorseContact* morse = c.contact.morse())
        a.contact_distance = morse->zero_force_distance.si / choice.dx.si;
    a.start_radius = HUGE_VAL;
    for (int cell = 0; cell < cells.cell_count(); ++cell) {
        const SharpestBend bend = sharpest_bend(outline(cells, cell));
        a.start_turn_deg = std::max(a.start_turn_deg, bend.turn * 180.0 / std::numbers::pi);
        a.start_radius = std::min(a.start_radius, bend.radius);
    }
}

void count_all(const Case& c, const Choice& choice, const State& initial, Appraisal& a) {
    const Suspension& cells = initial.cells;
    a.sites = static_cast<std::int64_t>(choice.nx) * choice.ny;
    a.steps = steps_until(c.time.end.si, choice.dt.si);
    a.cells = cells.cell_count();
    a.nodes = cells.node_count();
    if (a.cells == 0) return;
    const double area =
        std::accumulate(cells.reference_area.begin(), cells.reference_area.end(), 0.0);
    const double length = std::accumulate(cells.rest_length.begin(), cells.rest_length.end(), 0.0);
    a.hematocrit = area / static_cast<double>(a.sites);
    a.radius_sites = std::sqrt(area / a.cells / 3.14159265358979323846);
    a.node_distance = length / a.nodes;
    resolve(c, choice, cells, a);
    a.viscosity_ratio = c.cells.cytoplasm_viscosity.si / c.plasma.viscosity.si;
}

/// How dense the start is.
void measure_start(const Model& model, const Suspension& cells, Appraisal& a) {
    if (a.cells == 0) return;
    a.smallest_gap = smallest_gap(model.lattice, cells, gap_reach);
    a.wall_distance = model.lattice.ny;
    for (const double y : cells.y)
        a.wall_distance = std::min({a.wall_distance, y, model.lattice.ny - y});
    for (int c = 0; c < a.cells; ++c)
        for (int k = cells.first[c]; k < cells.first[c + 1]; ++k) {
            const int next = k + 1 < cells.first[c + 1] ? k + 1 : cells.first[c];
            const double length = norm(cells.position(next) - cells.position(k));
            a.start_stretch =
                std::max(a.start_stretch, std::abs(length / cells.rest_length[k] - 1.0));
        }
}

void characterise(const Case& c, const Choice& choice, const Model& model, Appraisal& a) {
    const double k = std::abs(choice.shear_rate.si);
    const double mu = c.plasma.viscosity.si;
    const double rho = c.plasma.density.si;
    const double radius = equivalent_radius(c).si;
    const double width = c.domain.width.si;
    a.tau_plasma = 0.5 + 3.0 * model.viscosity.plasma;
    a.tau_cytoplasm =
        0.5 + 3.0 * (a.cells > 0 ? model.viscosity.cytoplasm : model.viscosity.plasma);
    if (model.viscosity.layer_thickness > 0.0)
        a.tau_cytoplasm = std::max(a.tau_cytoplasm, 0.5 + 3.0 * model.viscosity.layer_viscosity);
    a.channel_reynolds = rho * k * width * width / mu;
    a.mach = choice.largest_speed.si * choice.dt.si / choice.dx.si * std::sqrt(3.0);
    a.strained_time = k * c.time.end.si;
    if (c.flow.channel()) a.transits = k * width * c.time.end.si / c.domain.length.si;
    if (a.cells == 0) return;
    a.shear_number = mu * k * radius / c.membrane.shear_modulus.si;
    a.cell_reynolds = rho * k * radius * radius / mu;
    a.cell_reynolds_run = choice.density_scale * a.cell_reynolds;
}

void bound(const Choice& choice, const Model& model, Appraisal& a) {
    a.bounds.push_back({"Mach number", a.mach, mach_limit, "largest speed / speed of sound"});
    if (a.cells == 0) return;
    // The fluids on both sides slow a membrane down.
    const double viscosity = 0.5 * (model.viscosity.plasma + model.viscosity.cytoplasm);
    const Membrane& membrane = model.membrane;
    const double stretch = choice.expected_stretch;
    const std::string at = fmt::format("at stretch {:.3g}", stretch);
    const bool late = choice.relaxation_time > 1.5;
    a.bounds.push_back({"membrane tension",
                        tension_step_number(tension_slope(membrane, stretch), viscosity,
                                            choice.relaxation_time, 1.0, 1.0),
                        tension_step_limit,
                        (late ? "(tau-1/2) T' dt/(mu dx) " : "T' dt/(mu dx) ") + at});
    const double lesser = std::min(model.viscosity.plasma, model.viscosity.cytoplasm);
    const double bent = stretch_of_hardened(membrane, stretch);
    a.bounds.push_back(
        {"bending", bending_step_number(bending_modulus(membrane, bent), lesser, 1.0, 1.0),
         bending_step_limit, fmt::format("E_b dt/(mu dx^3) at stretch {:.3g}", bent)});
    if (membrane.hold_area) return;  // the area cannot run away
    const double cell_stretch = expected_cell_stretch(stretch_of_hardened(membrane, stretch));
    a.bounds.push_back({"area pressure",
                        area_step_number(area_stiffness(membrane, cell_stretch),
                                         model.viscosity.plasma, choice.relaxation_time, 1.0),
                        area_step_limit,
                        fmt::format("k_p (tau-1/2) dt/mu at {:.3g}", cell_stretch)});
}

/// frames.h5: three pairs of doubles a node, four floats a site where there are fields
/// (io/frames.hpp); tables: some 14 bytes a number.
void size_output(const Case& c, Appraisal& a) {
    const double end = c.time.end.si;
    const double series = c.output.series ? c.output.series->si : end / 500.0;
    const double frames = c.output.frames ? c.output.frames->si : end / 50.0;
    // At most one a step, however short the interval.
    const auto times = [&](double interval) {
        return 1 +
               static_cast<std::int64_t>(std::min(end / interval, static_cast<double>(a.steps)));
    };
    a.frames = times(frames);
    const double fields = std::max(c.output.fields ? c.output.fields->si : frames, frames);
    const std::int64_t with_fields = std::isfinite(fields) ? times(fields) : 0;
    a.frame_bytes = 48 * a.nodes + 16 * a.sites * with_fields / a.frames;  // mean
    const std::int64_t rows = times(series);
    const std::int64_t checkpoints = 2 * (72 * a.sites + 100 * a.nodes);
    a.disk_bytes = a.frames * a.frame_bytes + rows * 14 * (40 + 22 * a.cells) + checkpoints;
}

/// Collects advice.
class Adviser {
public:
    explicit Adviser(Appraisal& a) : a_(a) {}
    template <class... Args>
    void consider(fmt::format_string<Args...> format, Args&&... args) {
        a_.advice.push_back(
            {Advice::Weight::consider, fmt::format(format, std::forward<Args>(args)...)});
    }
    template <class... Args>
    void refuse(fmt::format_string<Args...> format, Args&&... args) {
        a_.advice.push_back(
            {Advice::Weight::refuse, fmt::format(format, std::forward<Args>(args)...)});
    }

private:
    Appraisal& a_;
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
                rounded_text(choice.area_stiffness, 3),
                rounded_text(Pressure{0.9 * b.margin() * choice.area_stiffness.si}, 2));
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
            "The time step may change D, strain, lambda_C and mu_rel by {:.2g} %, by its {} ({}). "
            "Write dt = \"{}\", or leave dt and density_scale out.",
            100.0 * change, limit.name, limit.reason, rounded_text(limit.step, 2));
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
    if (a.radius_sites < 9.5)
        adviser.consider("{:.3g} sites to the radius of a cell are few; write dx = \"{}\".",
                         a.radius_sites, spacing_text(c, choice.dx.si * a.radius_sites / 16.0));
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
    const bool moves =
        choice.shear_rate.si > 0.0 && !std::holds_alternative<SurfaceTension>(c.membrane.law);
    if (moves && a.bending_length > 0.0 && a.bending_length < shortest)
        adviser.consider(
            "The bending length sqrt(E_b/E_s) is {:.2g} sites: a membrane that the flow compresses "
            "buckles below the grid and crumples. Write dx = \"{}\".",
            a.bending_length, spacing_text(c, choice.dx.si * a.bending_length / shortest));
    if (a.node_distance < 0.35 || a.node_distance > 1.5)
        adviser.consider(
            "Nodes {:.2g} sites apart; between 0.35 and 1.5 the result does not depend on it. "
            "Write "
            "node_spacing = 1.",
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
    const CellOutline* drawn = c.cells.outline();
    if (!drawn || c.numerics.fluid_only) return;
    for (const std::string& remark : drawn->remarks) adviser.consider("{}", remark);
    constexpr double site = 1.0;
    if (self_approach(outline(initial.cells, 0), site))
        adviser.consider(
            "Two parts of the outline {} are less than a site apart: what lies between them is not "
            "resolved. Write a smaller dx.",
            drawn->file);
}

void advise_on_physics(const Case& c, const Appraisal& a, Adviser& adviser) {
    if (a.cells == 0) return;
    if (c.membrane.bending_modulus.si == 0.0 && a.shear_number >= 0.5)
        adviser.consider(
            "Without bending stiffness the membrane wrinkles at G >= 0.5; write bending_modulus.");
    if (c.membrane.hardening.compression == Hardening::Compression::as_printed &&
        !c.membrane.hardening.apply_to.empty())
        adviser.consider(
            "Eq. 12 as printed softens in compression, and segments fold within about 1 ms; write "
            "compression = \"symmetric\".");
    if (c.flow.shear() && a.strained_time < 15.0)
        adviser.consider(
            "k t = {:.3g} at the end; a cell is steady after k t = 16, 27, 47 at G = 0.2, 0.5, 1 "
            "and "
            "viscosity ratio 5. Write end = \"{}\".",
            a.strained_time, rounded_text(Time{c.time.end.si * 20.0 / a.strained_time}, 2));
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

bool Appraisal::refused() const {
    return std::any_of(advice.begin(), advice.end(),
                       [](const Advice& x) { return x.weight == Advice::Weight::refuse; });
}

void expect_stable(const Case& c, const Choice& choice, const Model& model, const State& initial) {
    std::vector<Fault> faults;
    for (const Advice& advice : appraise(c, choice, model, initial).advice)
        if (advice.weight == Advice::Weight::refuse) faults.push_back({"", 0, 0, advice.text});
    if (!faults.empty()) throw CaseError(std::move(faults));
}

Appraisal appraise(const Case& c, const Choice& choice, const Model& model, const State& initial) {
    Appraisal a;
    count_all(c, choice, initial, a);
    measure_start(model, initial.cells, a);
    characterise(c, choice, model, a);
    bound(choice, model, a);
    size_output(c, a);
    Adviser adviser(a);
    advise_on_step(c, choice, a, adviser);
    advise_on_change(c, choice, a, adviser);
    advise_on_resolution(c, choice, a, adviser);
    advise_on_outline(c, initial, adviser);
    advise_on_physics(c, a, adviser);
    if (const auto why = bursting_contact(c, model, initial)) adviser.refuse("{}", *why);
    const std::vector<Advice> unusual = implausible_numbers(c, choice, a);
    a.advice.insert(a.advice.end(), unusual.begin(), unusual.end());
    return a;
}

}  // namespace tt
