#pragma once

#include "exchange/exchange.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// One time step, in the order of the paper: a team function. A function of Model and State alone; the same bits for any
/// number of threads.
void advance(const Model& model, State& state, Exchange& exchange);

}  // namespace tt
