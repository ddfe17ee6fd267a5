#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// The velocity that belongs to the populations and the uniform force, at all sites: what a step
/// would compute, but for the force of the membranes. `velocity` has the size.
void fill_velocity(const State& state, VectorField& velocity);

/// Sizes and fills all of a State that follows from its populations and cells: after building one,
/// and after loading one. Precondition: populations are on the model's lattice.
void derive(const Model& model, State& state);

}  // namespace tt
