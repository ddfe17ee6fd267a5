#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// The deviation of density at the start of a flow at rest: it falls evenly along x by that of the
/// pressure drop, 0 in the middle. With the drop between the ends all in one place a wave of
/// pressure would run through the channel.
Field<> density_of_drop(const Model& model);

/// Lays out the sites in the model's precision, in the equilibrium of velocity and density.
void start_flow(const Model& model, const VectorField<>& velocity, const Field<>& density,
                State& state);

/// Sizes and fills all of a State that follows from its populations and cells: after building one,
/// and after loading one. Precondition: populations are on the model's lattice.
void derive(const Model& model, State& state);
/// The same, but the cytoplasm stays where it was last laid: as after reading a checkpoint.
void derive_kept(const Model& model, State& state);

/// After cells came or went: what is derived is made anew, to the bits that a checkpoint would
/// give.
void derive_changed(const Model& model, State& state);

}  // namespace tt
