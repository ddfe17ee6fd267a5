#include "app/probe.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/parallel.hpp"
#include "exchange/periodic.hpp"
#include "simulation/advance.hpp"
#include "simulation/state_archive.hpp"

namespace tt {
namespace {

/// No node moved by half a site or more; written so that a NaN fails it.
bool is_calm(const Suspension& cells) {
    for (int n = 0; n < cells.node_count(); ++n)
        if (!(std::abs(cells.ux[n]) < 0.5 && std::abs(cells.uy[n]) < 0.5)) return false;
    return true;
}

/// Makes `steps` steps, or fewer if the state gets out of hand: a faulty position must never become
/// an index. Returns whether all were made.
bool advance_calmly(const Model& model, State& state, Exchange& exchange, int steps) {
    bool calm = true;
    with_team(model.threads, [&] {
        for (int n = 0; n < steps && calm; ++n) {
            if (!model.exits.empty()) on_one_thread([&] { release_cells(model, state); });
            advance(model, state, exchange);
            on_one_thread([&] { calm = is_calm(state.cells); });
        }
    });
    return calm;
}

}  // namespace

Probe probe(const Model& model, State state) {
    using Clock = std::chrono::steady_clock;
    constexpr double patience = 0.3;  // s
    Probe result;
    result.threads = model.threads;
    Periodic exchange;
    int steps = 2;
    double total = 0.0;
    while (total < patience && result.unstable_step == 0) {
        const auto begin = Clock::now();
        const bool calm = advance_calmly(model, state, exchange, steps);
        const double seconds =
            std::max(std::chrono::duration<double>(Clock::now() - begin).count(), 1e-9);
        if (!calm) result.unstable_step = std::max<std::int64_t>(state.step, 1);
        result.steps_per_second = std::max(result.steps_per_second, steps / seconds);
        total += seconds;
        if (seconds < 0.05) steps *= 2;
    }
    State kept;  // as a run keeps its last good state (LastGood)
    copy_saved(state, kept);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    result.memory_bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
    return result;
}

}  // namespace tt
