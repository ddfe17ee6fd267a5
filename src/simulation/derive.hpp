#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Sizes and fills all of a State that follows from its populations and cells: after building one,
/// and after loading one. Precondition: populations are on the model's lattice.
void derive(const Model& model, State& state);

}  // namespace tt
