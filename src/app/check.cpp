#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "app/case_options.hpp"
#include "app/check_json.hpp"
#include "app/check_kinds.hpp"
#include "app/check_walls.hpp"
#include "app/layout_progress.hpp"
#include "app/picture.hpp"
#include "app/probe.hpp"
#include "app/verb.hpp"
#include "base/tell.hpp"
#include "base/units.hpp"
#include "base/words.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/kinds.hpp"
#include "case/trial.hpp"
#include "io/json.hpp"
#include "observe/progress.hpp"

namespace tt {
namespace {

struct CheckOptions {
    CaseOptions given;
    PictureOption picture;
    bool json = false;
};

std::string bytes_text(double bytes) {
    for (const char* unit : {"B", "kB", "MB", "GB"}) {
        if (bytes < 999.5) return fmt::format("{:.{}f} {}", bytes, bytes < 10.0 ? 1 : 0, unit);
        bytes /= 1000.0;
    }
    return fmt::format("{:.1f} TB", bytes);
}

/// What the grid must resolve, in sites.
std::string resolution_text(const Appraisal& a) {
    std::string text =
        a.rigid() ? std::string("rigid bodies")
        : a.bending_length > 0.0
            ? fmt::format("bending length sqrt(E_b/E_s) {:.2g} sites", a.bending_length)
            : std::string("no bending stiffness");
    if (a.contact_distance > 0.0)
        text += fmt::format(", contact distance {:.2g} sites", a.contact_distance);
    return text + fmt::format(
                      "; the shape at the start turns by {:.2g} deg between segments, "
                      "radius of curvature {:.2g} sites",
                      a.start_turn_deg, a.start_radius);
}

/// How near membranes are at the start, and how much they are stretched there.
std::string start_text(const Case& c, const Choice& choice, const Appraisal& a) {
    std::string text =
        a.smallest_gap < gap_reach
            ? fmt::format("nearest membranes {:.2g} sites ({}) apart", a.smallest_gap,
                          rounded_text(Length{a.smallest_gap * choice.dx.si}, 2))
            : fmt::format("no two membranes nearer than {:.2g} sites", gap_reach);
    if (a.smallest_gap < std::min(gap_reach, a.contact_distance))
        text += fmt::format(", below zero_force_distance, {}",
                            rounded_text(Length{a.contact_distance * choice.dx.si}));
    if (c.domain.sides == Sides::walls || choice.walls)
        text += fmt::format("; {} sites to a wall", plain(a.wall_distance));
    if (a.start_stretch > 1e-6)
        text += fmt::format("; segments stretched by up to {} %", plain(100.0 * a.start_stretch));
    return text;
}

std::string equilibrium_text(const Equilibrium& equilibrium) {
    if (std::holds_alternative<LinearEquilibrium>(equilibrium)) return "linear: Stokes flow";
    if (std::holds_alternative<FullEquilibrium>(equilibrium)) return "full: with advection, Eq. 2";
    return "incompressible: with advection";
}

std::string precision_text(const Case& c, const Choice& choice) {
    const std::string text(word_of(choice.precision));
    if (c.numerics.precision) return text + ", as given";
    if (c.numerics.fluid_only) return text + ": a channel without cells";
    return text + (choice.precision == Precision::fp32 ? ": step_tolerance is 1 % or more"
                                                       : ": step_tolerance is below 1 %");
}

/// What `auto` was held back by: the first limit, and those that meet it where τ was chosen.
std::string step_setters(const Choice& choice) {
    std::string text;
    for (const StepLimit& limit : choice.limits) {
        if (limit.step.si > 1.02 * choice.limits.front().step.si) break;
        text += (text.empty() ? "the " : " and the ") + limit.name;
    }
    return text;
}

void print_numerics(const Case& c, const Choice& choice, const Model& model, const Appraisal& a) {
    print_line("grid", fmt::format("{} x {} sites of {}, {} in all", choice.nx, choice.ny,
                                   rounded_text(choice.dx), with_spaces(a.sites)));
    print_walls(c, choice);
    print_feeds(c, model, a);
    if (a.cells > 0)
        print_line(
            "cells",
            fmt::format(
                "{}, radius {:.3g} sites, {} nodes each, {:.2f} sites apart; hematocrit {:.1f} %, "
                "viscosity ratio {:.3g}",
                a.cells, a.radius_sites, a.nodes / a.cells, a.node_distance, 100.0 * a.hematocrit,
                a.viscosity_ratio));
    else
        print_line("cells", "none");
    print_kinds(a);
    print_membrane_viscosity(a);
    if (a.cells > 0) print_line("resolution", resolution_text(a));
    if (a.cells > 0) print_line("start", start_text(c, choice, a));
    for (const Case& one : cases_by_kind(c))
        if (a.cells > 0 && one.cells.outline())
            print_line("outline", description(*one.cells.outline()));
    const bool chosen = !c.numerics.dt && !c.numerics.density_scale;
    print_line("time step", fmt::format("{}, {} steps to {}; {}", rounded_text(choice.dt),
                                        with_spaces(a.steps), to_text(c.time.end),
                                        chosen ? "set by " + step_setters(choice) : "as given"));
    if (const double change = choice.expected_change(); change > 0.0)
        print_line("what it changes",
                   fmt::format("D, strain, lambda_C and mu_rel by less than {} % (measured in "
                               "studies/time-step); numerics.step_tolerance is {:.3g} %",
                               plain(100.0 * change), 100.0 * c.numerics.step_tolerance));
    const bool tau_chosen =
        !c.numerics.relaxation_time && !(c.numerics.dt && c.numerics.density_scale);
    const bool trt = std::holds_alternative<Trt>(c.numerics.collision);
    print_line("relaxation time",
               fmt::format("{:.4g} in plasma{}{}", a.tau_plasma,
                           a.tau_cytoplasm > a.tau_plasma
                               ? fmt::format(", {:.4g} where it is most viscous ({})",
                                             a.tau_cytoplasm, trt ? "TRT" : "BGK")
                               : "",
                           tau_chosen ? "; it allows the longest step" : ""));
    print_line("equilibrium", equilibrium_text(choice.equilibrium));
    print_line("precision", precision_text(c, choice));
    if (a.cells > 0) print_line("kernel", std::string(word_of(choice.delta)));
    print_line("density scale",
               choice.density_scale < 1.0 - 1e-9
                   ? fmt::format("{:.3g} times the density and the Reynolds number: less inertia "
                                 "than there is, as the step must be so short",
                                 choice.density_scale)
               : choice.density_scale < 1.0 + 1e-9
                   ? std::string("1: the physical Reynolds number")
                   : fmt::format("{:.4g} times the density and the Reynolds number, and as much "
                                 "longer steps",
                                 choice.density_scale));
}

void print_flow(const Case& c, const Choice& choice, const Appraisal& a) {
    if (std::holds_alternative<NoDrive>(c.flow.drive) && !c.network()) {
        print_line("flow", "none: the fluid is at rest");
        return;
    }
    const bool shear = c.flow.shear() != nullptr;
    std::string text =
        fmt::format("{} {}, largest speed {}", shear ? "shear rate" : "pseudo-shear rate",
                    rounded_text(choice.shear_rate), rounded_text(choice.largest_speed));
    if (a.cells > 0) text += fmt::format(", G = {}", plain(a.shear_number, 3));
    if (a.cells > 0 && !c.network())
        text += shear ? fmt::format("; k t = {:.3g} at the end", a.strained_time)
                      : fmt::format("; {} transits of the box", plain(a.transits, 3));
    print_line("flow", text);
    if (a.cells > 0)
        print_line("Reynolds number",
                   fmt::format("of a cell {}, as run {}; of the channel {}", plain(a.cell_reynolds),
                               plain(a.cell_reynolds_run), plain(a.channel_reynolds)));
    else
        print_line("Reynolds number",
                   fmt::format("of the channel {}, as run {}", plain(a.channel_reynolds),
                               plain(choice.density_scale * a.channel_reynolds)));
}

void print_limits(const Choice& choice, const Appraisal& a) {
    fmt::print("\n  what limits the time step\n");
    for (const StepLimit& limit : choice.limits)
        fmt::print("    {:<17} {:<12} {}\n", limit.name, rounded_text(limit.step, 3),
                   wrapped(limit.reason, 79, 35));
    fmt::print("\n  stability              is     limit  margin\n");
    for (const Bound& b : a.bounds)
        fmt::print("    {:<17} {:<9.2g} {:<5.3g} {:>6}   {}\n", b.name, b.value, b.limit,
                   b.margin() > 1000.0 ? ">1000" : fmt::format("{:.1f}", b.margin()), b.definition);
}

double seconds_to_finish(const Appraisal& a, const Probe& p) {
    return static_cast<double>(a.steps) / p.steps_per_second;
}

void print_cost(const Appraisal& a, const Probe& p, const ThreadChoice& threads) {
    fmt::print("\n");
    print_line("threads", fmt::format("{}, {}", threads.threads, threads.reason));
    print_line("disk", fmt::format("{}, with {} frames of {}",
                                   bytes_text(static_cast<double>(a.disk_bytes)), a.frames,
                                   bytes_text(static_cast<double>(a.frame_bytes))));
    if (p.steps_per_second == 0.0) return;
    print_line("memory", bytes_text(p.memory_bytes));
    print_line("time to finish",
               fmt::format("{} on {} thread{}: {} steps/s, {:.0f} million site updates/s",
                           duration_text(seconds_to_finish(a, p)), p.threads,
                           p.threads == 1 ? "" : "s", with_spaces(std::llround(p.steps_per_second)),
                           1e-6 * p.steps_per_second * static_cast<double>(a.sites)));
}

void print_verdict(const Appraisal& a) {
    fmt::print("\n");
    for (const Advice& x : a.advice)
        fmt::print("  {} {}\n", x.weight == Advice::Weight::refuse ? "!" : "*",
                   wrapped(x.text, 79, 4));
    fmt::print("{}{}\n", a.advice.empty() ? "" : "\n",
               a.refused()        ? "This case will not run stably: change what is marked with !."
               : a.advice.empty() ? "Nothing to change. Ready to run."
                                  : "Ready to run; consider what is marked with *.");
}

/// Steps that are made to tell their pace show more than the short try.
void advise_on_probe(const Probe& p, const Case& c, const Model& model, Appraisal& a) {
    if (p.instability && p.instability->step <= a.steps)  // timing goes on beyond a short run
        a.advice.push_back(refusal_after(*p.instability, c, model, initial_state(c, model)));
    else if (p.steps_per_second > 0.0 && takes_long(seconds_to_finish(a, p)))
        a.advice.push_back({Advice::Weight::consider, remark_on_length(seconds_to_finish(a, p))});
}

/// What is chosen. A case that cannot be put on a grid is drawn before that is told.
Choice chosen(const CheckOptions& options, const Case& c) {
    try {
        return choose(c);
    } catch (const CaseError&) {
        if (options.picture.wanted()) tell_user("drawn to {}\n", draw_picture(options.picture, c));
        throw;
    }
}

int check(const CheckOptions& options) {
    expect_drawable(options.picture);
    const Case c = read_given_case(options.given).c;
    const Choice choice = chosen(options, c);
    expect_memory(c, choice);
    Model model = discretise(c, choice);
    const ThreadChoice threads = choose_threads(options.given.threads, c, choice);
    model.threads = threads.threads;
    State initial = initial_state(c, model, layout_progress(ProgressMode::automatic));
    if (options.picture.wanted())
        tell_user("drawn to {}\n", draw_picture(options.picture, c, &choice, &model, &initial));
    Appraisal a = appraise_with_trial(c, choice, model, initial);
    const Probe p = a.refused() ? Probe{} : probe(model, std::move(initial));
    advise_on_probe(p, c, model, a);
    if (options.json) {
        fmt::print("{}\n", to_json(c, choice, a, p).dump(2));
    } else {
        fmt::print("{}  ({})\n\n", c.name, options.given.path);
        print_numerics(c, choice, model, a);
        print_flow(c, choice, a);
        print_limits(choice, a);
        print_cost(a, p, threads);
        print_verdict(a);
    }
    return a.refused() ? exit_code::bad_input : exit_code::done;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* verb = app.add_subcommand("check", "judge a case: which dx, dt and tau, and why");
    add_case_options(*verb, options->given);
    verb->add_flag("--json", options->json, "as JSON");
    add_picture_option(*verb, options->picture);
    verb->footer(
        "Tells grid, time step, relaxation times, Reynolds, Mach and shear numbers, each\n"
        "stability limit with its margin, memory, disk and the time to finish, and which\n"
        "key to change. Nothing is written but a picture: walls, ports and cells at the\n"
        "start. Exit code 2 if the case cannot run.\n\n"
        "  tanktread check channel.toml --set flow.pseudo_shear_rate=\"150 /s\"\n"
        "  tanktread check fork.toml --picture fork.png");
    verb->callback([options, &action] { action = [options] { return check(*options); }; });
}

}  // namespace tt
