#include "simulation/run.hpp"

#include <optional>

#include "base/contracts.hpp"
#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/stop.hpp"

namespace tt {

void run_steps(const Model& model, State& state, Exchange& exchange, Health& health,
               std::int64_t until, Clock::time_point wake, StepTimes* times) {
    TT_EXPECTS(state.step < until);
    std::optional<Instability> fault;
    bool last = false;
    FlowKept kept = FlowKept::everywhere;
    // Changes only between the barriers at the ends of advance and after_step, so that all threads
    // read the same.
    const auto look_ahead = [&] {
        const std::int64_t next = state.step + 1;
        last = next >= until || stop_requested() || Clock::now() >= wake;
        kept = last || health.looks_at_flow(next) ? FlowKept::everywhere : FlowKept::near_membranes;
    };
    look_ahead();
    with_team(model.threads, [&] {
        for (bool done = false; !done;) {
            const bool was_last = last;
            advance(model, state, exchange, kept, times);
            if (team_rank() == 0) look_ahead();
            const auto found = health.after_step(model, state);
            if (found && team_rank() == 0) fault = found;
            done = found || was_last;
        }
    });
    if (fault) throw SimulationError(*fault);
}

}  // namespace tt
