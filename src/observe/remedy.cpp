#include "observe/remedy.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "simulation/derive.hpp"
#include "simulation/rescale.hpp"
#include "simulation/run.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

constexpr std::chrono::seconds patience(60);

/// The good state as `model` counts.
State converted(const BlowUp& blow_up, const Model& model) {
    State state = blow_up.good;
    const double ratio = model.scales.time / blow_up.model.scales.time;
    if (ratio != 1.0) change_time_step(model, ratio, state);
    derive(model, state);
    return state;
}

/// The time [s] that a run must come to: six times as far from the good state as the failure, and
/// 2000 steps.
double goal(const BlowUp& blow_up) {
    const double dt = blow_up.model.scales.time;
    const double good = dt * static_cast<double>(blow_up.good.step);
    return std::max(good + 6.0 * (blow_up.what.time - good), blow_up.what.time + 2000.0 * dt);
}

enum class Ending { helped, failed, cut_off };

Ending ending_with(const Remedy& remedy, const BlowUp& blow_up, const HealthLimits& limits,
                   Exchange& exchange, Clock::time_point deadline) {
    State state = converted(blow_up, remedy.model);
    Health health(limits, state);
    const auto until = static_cast<std::int64_t>(goal(blow_up) / remedy.model.scales.time) + 1;
    try {
        while (state.step < until && Clock::now() < deadline && !stop_requested())
            run_steps(remedy.model, state, exchange, health, until, deadline);
    } catch (const SimulationError&) {
        return Ending::failed;
    }
    return state.step >= until ? Ending::helped : Ending::cut_off;
}

}  // namespace

Suggestion tried_suggestion(const std::vector<Remedy>& remedies, const BlowUp& blow_up,
                            const HealthLimits& limits, Exchange& exchange) {
    const Clock::time_point deadline = Clock::now() + patience;
    std::string failed;
    for (const Remedy& remedy : remedies) {
        const Ending ending = ending_with(remedy, blow_up, limits, exchange, deadline);
        if (ending == Ending::helped)
            return {
                remedy.settings,
                fmt::format("tried: from step {} it runs well past the failure, to t = {:.4g} ms",
                            blow_up.good.step, 1e3 * goal(blow_up))};
        if (ending == Ending::cut_off)
            return {remedy.settings, "there was no time to try it to the end"};
        failed += (failed.empty() ? "" : "; ") + remedy.settings;
    }
    return {"", fmt::format("{}. Tried from step {} without success: {}", blow_up.what.cure,
                            blow_up.good.step, failed)};
}

}  // namespace tt
