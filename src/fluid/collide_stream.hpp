#pragma once

#include "base/vec2.hpp"
#include "fluid/boundaries.hpp"
#include "fluid/equilibrium.hpp"
#include "fluid/populations.hpp"
#include "fluid/relaxation.hpp"
#include "grid/field.hpp"

namespace tt {

/// One fused collision and streaming pass (Eqs. 1–4), in place; see Populations for the layout.
///   in:  force (per site, membrane), body_force (uniform), relaxation, populations (halo filled in phase odd)
///   out: populations of the next phase (halo to be folded after an odd pass), velocity u = Σ f c + ½ F at the old time
/// Guo's forcing (Eq. 3 as corrected) split into its even and odd part, each with its own rate. Team function.
/// The caller flips `populations.phase` once all threads are done (`advance` does).
void collide_and_stream(const Equilibrium& equilibrium, Vec2 body_force, const VectorField& force,
                        const Relaxation& relaxation, Populations& populations, VectorField& velocity);

/// The same pass written plainly, out of place and site by site: the oracle of the fast one. Serial; flips the phase,
/// handles periodic ends and walls itself. Slow and readable.
void collide_and_stream_reference(const Equilibrium& equilibrium, const Boundaries& boundaries, Vec2 body_force,
                                  const VectorField& force, const Relaxation& relaxation, Populations& populations,
                                  VectorField& velocity);

/// Half-way bounce-back at resting or moving walls, as halo rows j = −1 and j = ny, in phase odd only:
/// `fill_walls` before the pass, `fold_walls` after it. Team functions. No effect on a lattice without walls.
void fill_walls(const Boundaries& boundaries, Populations& populations);
void fold_walls(const Boundaries& boundaries, Populations& populations);

/// Pressure drop between the periodic ends: what crosses an end gains or loses w_i Δρ. After Exchange::fill and
/// before Exchange::fold respectively, phase odd. Team functions.
void fill_pressure_ends(const Boundaries& boundaries, Populations& populations);
void fold_pressure_ends(const Boundaries& boundaries, Populations& populations);

/// Density deviation, momentum Σ f c (without ½F) and the second moment Σ f c c of one site.
struct Moments {
    double density_deviation = 0.0;
    Vec2 momentum;
    double xx = 0.0, xy = 0.0, yy = 0.0;  ///< Σ (f − w) c c
};
Moments moments(const Populations& populations, int i, int j);

/// Populations at rest with uniform density 1, or at equilibrium with the velocity field given.
void set_equilibrium(const Equilibrium& equilibrium, const VectorField& velocity, Populations& populations);

}  // namespace tt
