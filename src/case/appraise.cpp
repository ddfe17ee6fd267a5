#include "case/appraise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <variant>

#include "base/error.hpp"
#include "base/units.hpp"
#include "case/advise.hpp"
#include "case/kinds.hpp"
#include "membrane/outline.hpp"
#include "membrane/outline_checks.hpp"
#include "membrane/stability.hpp"
#include "observe/checks.hpp"
#include "simulation/schedule.hpp"

namespace tt {
namespace {

/// What of the membranes the grid must resolve.
void resolve(const Case& c, const Choice& choice, const Suspension& cells, Appraisal& a) {
    a.bending_length = HUGE_VAL;
    for (const KindFigures& kind : a.kinds)
        if (!kind.rigid) a.bending_length = std::min(a.bending_length, kind.bending_length);
    if (a.rigid()) a.bending_length = 0.0;
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
    for (const FeedState& feed : initial.feeds)
        a.feed_cells.push_back(feed.state.cells.cell_count());
    a.nodes = cells.node_count();
    if (a.cells == 0) return;
    const double area =
        std::accumulate(cells.reference_area.begin(), cells.reference_area.end(), 0.0);
    const double length = std::accumulate(cells.rest_length.begin(), cells.rest_length.end(), 0.0);
    a.hematocrit = area / (choice.walls ? static_cast<double>(choice.walls->open_sites())
                                        : static_cast<double>(a.sites));
    a.cell_area = area / a.cells;
    a.radius_sites = std::sqrt(a.cell_area / std::numbers::pi);
    a.node_distance = length / a.nodes;
    for (const KindFigures& kind : a.kinds)
        if (std::abs(std::log(kind.viscosity_ratio)) > std::abs(std::log(a.viscosity_ratio)))
            a.viscosity_ratio = kind.viscosity_ratio;
    resolve(c, choice, cells, a);
}

/// Of each kind, from its case.
void characterise_kinds(const Case& c, const Choice& choice, const Suspension& cells,
                        Appraisal& a) {
    const double dx = choice.dx.si;
    const double mu = c.plasma.viscosity.si;
    for (const Case& one : cases_by_kind(c)) {
        const auto n = static_cast<std::int32_t>(a.kinds.size());
        const double radius = equivalent_radius(one).si, modulus = one.membrane.shear_modulus.si;
        a.kinds.push_back(
            {c.kinds.empty() ? "" : c.kinds[n].name, one.membrane.rigid,
             static_cast<int>(std::count(cells.kind.begin(), cells.kind.end(), n)), radius / dx,
             one.cells.cytoplasm_viscosity.si / mu, shear_number_at(one, choice.shear_rate),
             one.membrane.rigid ? 0.0 : std::sqrt(one.membrane.bending_modulus.si / modulus) / dx,
             one.membrane.membrane_viscosity.si / (mu * radius),
             one.membrane.bending_viscosity.si / (mu * radius * radius * radius)});
    }
}

/// How dense the start is.
void measure_start(const Model& model, const Suspension& cells, Appraisal& a) {
    if (a.cells == 0) return;
    a.smallest_gap = smallest_gap(model.lattice, cells, gap_reach);
    a.wall_distance = model.lattice.ny;
    const Walls* const walls = model.boundaries.walls.get();
    for (int c = 0; c < a.cells; ++c) {
        if (cells.led[static_cast<std::size_t>(c)] != 0) continue;  // partly behind its port
        for (int n = cells.first[c]; n < cells.first[c + 1]; ++n) {
            const double y = cells.y[n];
            const double away =
                walls ? walls->distance_at(cells.position(n)) : std::min(y, model.lattice.ny - y);
            a.wall_distance = std::min(a.wall_distance, away);
        }
    }
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
    const double radius = largest_cell_radius(c).si;
    const double width = c.domain.width.si;
    a.tau_plasma = 0.5 + 3.0 * model.viscosity.plasma;
    const std::vector<double>& cytoplasm = model.viscosity.cytoplasm;
    const double thickest = *std::max_element(cytoplasm.begin(), cytoplasm.end());
    a.tau_cytoplasm = 0.5 + 3.0 * (a.cells > 0 ? thickest : model.viscosity.plasma);
    if (model.viscosity.layer_thickness > 0.0)
        a.tau_cytoplasm = std::max(a.tau_cytoplasm, 0.5 + 3.0 * model.viscosity.layer_viscosity);
    a.channel_reynolds = rho * k * width * width / mu;
    a.mach = choice.largest_speed.si * choice.dt.si / choice.dx.si * std::sqrt(3.0);
    a.strained_time = k * c.time.end.si;
    if (c.flow.channel()) a.transits = k * width * c.time.end.si / c.domain.length.si;
    if (a.cells == 0) return;
    for (const KindFigures& kind : a.kinds)
        a.shear_number = std::max(a.shear_number, kind.shear_number);
    a.cell_reynolds = rho * k * radius * radius / mu;
    a.cell_reynolds_run = choice.density_scale * a.cell_reynolds;
}

/// Of the membranes of one kind.
void bound_membrane(const Choice& choice, const Model& model, std::size_t kind, Appraisal& a) {
    // The fluids on both sides slow a membrane down.
    const double plasma = model.viscosity.plasma, cytoplasm = model.viscosity.cytoplasm[kind];
    const double viscosity = 0.5 * (plasma + cytoplasm);
    const Membrane& membrane = model.kinds[kind].membrane;
    if (membrane.rigid) return;
    const double stretch = choice.kinds[kind].expected_stretch;
    const bool late = choice.relaxation_time > 1.5;
    a.bounds.push_back({"membrane tension",
                        tension_step_number(tension_slope(membrane, stretch), viscosity,
                                            choice.relaxation_time, 1.0, 1.0),
                        membrane.mobility > 0.0 ? implicit_tension_step_limit : tension_step_limit,
                        (late ? "(tau-1/2) T' dt/(mu dx) at " : "T' dt/(mu dx) at stretch ") +
                            fmt::format("{:.3g}", stretch)});
    const double lesser = std::min(plasma, cytoplasm);
    const double bent = stretch_of_hardened(membrane, stretch);
    a.bounds.push_back(
        {"bending", bending_step_number(bending_modulus(membrane, bent), lesser, 1.0, 1.0),
         bending_step_limit, fmt::format("E_b dt/(mu dx^3) at stretch {:.3g}", bent)});
    if (membrane.hold_area) return;  // the area cannot run away
    const double cell_stretch = expected_cell_stretch(stretch_of_hardened(membrane, stretch));
    a.bounds.push_back({"area pressure",
                        area_step_number(area_stiffness(membrane, cell_stretch), plasma,
                                         choice.relaxation_time, 1.0),
                        area_step_limit,
                        fmt::format("k_p (tau-1/2) dt/mu at {:.3g}", cell_stretch)});
}

void bound(const Choice& choice, const Model& model, Appraisal& a) {
    a.bounds.push_back({"Mach number", a.mach, mach_limit, "largest speed / speed of sound"});
    if (a.cells == 0) return;
    for (std::size_t kind = 0; kind < model.kinds.size(); ++kind) {
        const std::size_t before = a.bounds.size();
        bound_membrane(choice, model, kind, a);
        for (std::size_t n = before; n < a.bounds.size(); ++n) {
            a.bounds[n].kind = kind;
            if (model.kinds.size() > 1)
                a.bounds[n].definition += fmt::format(" ({})", model.kinds[kind].name);
        }
    }
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

}  // namespace

bool Appraisal::refused() const {
    return std::any_of(advice.begin(), advice.end(),
                       [](const Advice& x) { return x.weight == Advice::Weight::refuse; });
}

bool Appraisal::rigid() const {
    return std::all_of(kinds.begin(), kinds.end(), [](const KindFigures& k) { return k.rigid; });
}

Appraisal appraise(const Case& c, const Choice& choice, const Model& model, const State& initial) {
    Appraisal a;
    if (initial.cells.cell_count() > 0) characterise_kinds(c, choice, initial.cells, a);
    count_all(c, choice, initial, a);
    measure_start(model, initial.cells, a);
    characterise(c, choice, model, a);
    bound(choice, model, a);
    size_output(c, a);
    a.advice = advice_on(c, choice, model, initial, a);
    return a;
}

}  // namespace tt
