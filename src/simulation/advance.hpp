#pragma once

#include "exchange/exchange.hpp"
#include "simulation/health.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/step_times.hpp"

namespace tt {

/// One time step, in the order of the paper: a team function. A function of Model and State alone;
/// the same bits for any number of threads. Adds to `times`, if given, what each pass took; lets
/// `health`, if given, watch the nodes where they have gone. Waits at its end.
void advance(const Model& model, State& state, Exchange& exchange, StepTimes* times = nullptr,
             Health* health = nullptr);

}  // namespace tt
