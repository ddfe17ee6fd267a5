#include "case/trial.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "case/cures.hpp"
#include "case/kinds.hpp"
#include "exchange/periodic.hpp"
#include "simulation/derive.hpp"
#include "simulation/health.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

/// Of a suspension that rests on what presses it together.
constexpr double dense = 0.8, much_stretched = 0.05;

/// Steps of a try: some seconds at most on one processor of today.
std::int64_t trial_steps(const Appraisal& a) {
    constexpr std::int64_t most = 1000, fewest = 20, site_updates = 50'000'000;
    return std::min(a.steps, std::clamp(site_updates / a.sites, fewest, most));
}

/// Numerics far from what `auto` takes.
bool is_unusual(const NumericsCase& n, const Choice& choice) {
    const bool long_step =
        n.dt && !choice.limits.empty() && choice.dt.si > 2.0 * choice.limits.front().step.si;
    const bool odd_time =
        choice.relaxation_time < 0.55 || (n.relaxation_time && choice.relaxation_time > 4.0);
    const bool heavy = n.density_scale && *n.density_scale > 100.0;
    const bool odd_nodes = n.node_spacing && *n.node_spacing < 0.5;
    return long_step || odd_time || heavy || odd_nodes || n.step_tolerance > 0.05;
}

bool is_crowded(const Case& c, const Appraisal& a) {
    const std::vector<Case> kinds = cases_by_kind(c);
    const bool drawn_out = std::any_of(kinds.begin(), kinds.end(), [](const Case& one) {
        return one.cells.initial_stretch.has_value();
    });
    const bool pressed = a.start_stretch > much_stretched && !drawn_out;
    return a.hematocrit >= dense || pressed;
}

/// Fewer cells, where nothing else helps those that are pressed together.
std::string more_room(const Case& c, const Appraisal& a) {
    const double share = 0.75 * std::min(1.0, dense / a.hematocrit);
    if (c.cells.hematocrit)
        return fmt::format("hematocrit = \"{:.0f} %\"", 100.0 * share * a.hematocrit);
    return fmt::format("count = {}", std::max(1, static_cast<int>(share * a.cells)));
}

std::string cure_of(const Instability& what, const Case& c, const Model& model,
                    const State& initial) {
    Periodic exchange;
    const Suggestion tried =
        tried_suggestion(cures(c, model.threads), {model, initial, what}, HealthLimits{}, exchange);
    const Appraisal a = appraise(c, choose(c), model, initial);
    if (!tried.settings.empty() || !is_crowded(c, a)) return tried.text();
    return more_room(c, a) + ", as membranes start pressed together and no other numerics helped";
}

}  // namespace

bool is_unusual(const Case& c, const Choice& choice, const Appraisal& a) {
    return is_unusual(c.numerics, choice) || is_crowded(c, a);
}

std::optional<Instability> instability_within(std::int64_t steps, const Model& model,
                                              const State& state) {
    State tried;
    copy_saved(state, tried);
    derive(model, tried);
    Periodic exchange;
    Health health(HealthLimits{}, tried);
    if (auto fault = health.examine(model, tried)) return fault;
    try {  // all is examined after every step, as a run does where it writes
        const std::int64_t end = tried.step + steps;
        while (tried.step < end) {
            if (stop_requested())
                throw StoppedEarly(
                    "stopped in a short try, before the first step; nothing was written, the same "
                    "command begins again");
            run_steps(model, tried, exchange, health, tried.step + 1, Clock::time_point::max());
        }
    } catch (const SimulationError& error) {
        return error.instability();
    }
    return std::nullopt;
}

Advice refusal_after(const Instability& what, const Case& c, const Model& model,
                     const State& initial) {
    return {
        Advice::Weight::refuse,
        fmt::format("A short try blew up at step {}: {} is {:.3g}, and {:.3g} is the limit; {}. "
                    "Write {}.",
                    what.step, what.quantity, what.value, what.limit, what.cause,
                    cure_of(what, c, model, initial))};
}

Appraisal appraise_with_trial(const Case& c, const Choice& choice, const Model& model,
                              const State& initial) {
    Appraisal a = appraise(c, choice, model, initial);
    if (a.refused() || !is_unusual(c, choice, a)) return a;
    if (const auto what = instability_within(trial_steps(a), model, initial))
        a.advice.push_back(refusal_after(*what, c, model, initial));
    return a;
}

void expect_stable(const Case& c, const Choice& choice, const Model& model, const State& initial) {
    std::vector<Fault> faults;
    for (const Advice& advice : appraise_with_trial(c, choice, model, initial).advice)
        if (advice.weight == Advice::Weight::refuse) faults.push_back({"", 0, 0, advice.text});
    if (!faults.empty()) throw CaseError(std::move(faults));
}

}  // namespace tt
