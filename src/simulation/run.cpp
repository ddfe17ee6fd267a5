#include "simulation/run.hpp"

#include <optional>

#include "base/contracts.hpp"
#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/derive.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

/// Cells leave and come.
void let_pass(const Model& model, State& state, Health& health) {
    const bool left = release_cells(model, state), came = admit_cells(model, state);
    if (!left && !came) return;
    derive_changed(model, state);
    health.forget(state);
}

}  // namespace

void run_steps(const Model& model, State& state, Exchange& exchange, Health& health,
               std::int64_t until, Clock::time_point wake, StepTimes* times) {
    TT_EXPECTS(state.step < until);
    std::optional<Instability> fault;
    // Whether the step that leads to an odd or an even number is the last one. One thread decides
    // while the step before is under way, so that all read the same after it.
    bool last[2] = {};
    const auto decide = [&](std::int64_t next) {
        last[next % 2] = next >= until || stop_requested() || Clock::now() >= wake;
    };
    decide(state.step + 1);
    with_team(model.threads, [&] {
        for (std::int64_t next = state.step + 1;; ++next) {
            const bool done = last[next % 2];
            if (team_rank() == 0) decide(next + 1);
            if (!model.exits.empty()) on_one_thread([&] { let_pass(model, state, health); });
            advance(model, state, exchange, times, &health);
            if (!model.sections.empty()) watch_sections(model, state);
            const auto found = health.after_step(model, state, done || health.due(next));
            if (found && team_rank() == 0) fault = found;
            if (found || done) break;
        }
    });
    if (fault) throw SimulationError(*fault);
}

}  // namespace tt
