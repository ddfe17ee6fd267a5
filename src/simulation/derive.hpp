#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Lays out the sites in the model's precision, in the equilibrium of `velocity` and of the
/// pressure drop (set_equilibrium).
void start_flow(const Model& model, const VectorField<>& velocity, State& state);

/// Sizes and fills all of a State that follows from its populations and cells: after building one,
/// and after loading one. Precondition: populations are on the model's lattice.
void derive(const Model& model, State& state);

}  // namespace tt
