#include "simulation/run.hpp"

#include <optional>

#include "base/contracts.hpp"
#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/stop.hpp"

namespace tt {

void run_steps(const Model& model, State& state, Exchange& exchange, Health& health,
               std::int64_t until, Clock::time_point wake) {
    TT_EXPECTS(state.step < until);
    std::optional<Instability> fault;
    bool more = true;
    with_team(model.threads, [&] {
        // `more` changes only between the two barriers of on_one_thread and advance, so all threads
        // read the same.
        while (more) {
            advance(model, state, exchange);
            on_one_thread([&] {
                fault = health.after_step(model, state);
                more = !fault && state.step < until && !stop_requested() && Clock::now() < wake;
            });
        }
    });
    if (fault) throw SimulationError(*fault);
}

}  // namespace tt
