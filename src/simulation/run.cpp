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
    bool done = false, last = false;
    FlowKept kept = FlowKept::everywhere;
    const auto look_ahead = [&] {
        const std::int64_t next = state.step + 1;
        last = next >= until || stop_requested() || Clock::now() >= wake;
        kept = last || health.looks_at_flow(next) ? FlowKept::everywhere : FlowKept::near_membranes;
    };
    look_ahead();
    with_team(model.threads, [&] {
        // `done`, `kept` and `last` change only between the two barriers of on_one_thread and
        // advance, so all threads read the same.
        while (!done) {
            advance(model, state, exchange, kept, times);
            on_one_thread([&] {
                fault = health.after_step(model, state);
                done = fault || last;
                look_ahead();
            });
        }
    });
    if (fault) throw SimulationError(*fault);
}

}  // namespace tt
