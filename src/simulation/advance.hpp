#pragma once

#include "exchange/exchange.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// One time step, in the order of the paper. A function of Model and State alone; same bits for any number of threads.
void advance(const Model& model, State& state, Exchange& exchange);

}  // namespace tt
