#include "app/probe.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>

#include "exchange/periodic.hpp"
#include "simulation/health.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"

namespace tt {
namespace {

double most_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Sets the steps a second of the fastest batch, as far as it comes.
void measure_pace(const Model& model, State& state, double& best) {
    constexpr double patience = 0.3;  // s
    Periodic exchange;
    Health health(HealthLimits{}, state);
    int steps = 2;
    for (double total = 0.0; total < patience;) {
        const auto begin = Clock::now();
        run_steps(model, state, exchange, health, state.step + steps, Clock::time_point::max());
        const double seconds =
            std::max(std::chrono::duration<double>(Clock::now() - begin).count(), 1e-9);
        best = std::max(best, steps / seconds);
        total += seconds;
        if (seconds < 0.05) steps *= 2;
    }
}

}  // namespace

Probe probe(const Model& model, State state) {
    Probe result;
    result.threads = model.threads;
    try {
        measure_pace(model, state, result.steps_per_second);
    } catch (const SimulationError& error) {
        result.instability = error.instability();
    }
    State kept;  // as a run keeps its last good state (LastGood)
    copy_saved(state, kept);
    result.memory_bytes = most_memory();
    return result;
}

}  // namespace tt
