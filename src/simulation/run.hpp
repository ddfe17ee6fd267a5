#pragma once

#include <chrono>
#include <cstdint>

#include "exchange/exchange.hpp"
#include "simulation/health.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/step_times.hpp"

namespace tt {

using Clock = std::chrono::steady_clock;

/// Advances to step `until`, or stops after fewer steps, at least one, once the clock passes `wake`
/// or a stop is requested. `health` has then examined the state. One team of `model.threads`
/// threads lives through all steps. Precondition: state.step < until. Throws SimulationError when
/// `health` finds something wrong; the state is then the faulty one. Adds to `times`, if given,
/// what each pass of the steps took.
void run_steps(const Model& model, State& state, Exchange& exchange, Health& health,
               std::int64_t until, Clock::time_point wake, StepTimes* times = nullptr);

}  // namespace tt
