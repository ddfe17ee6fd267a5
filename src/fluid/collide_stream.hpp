#pragma once

#include "base/vec2.hpp"
#include "fluid/boundaries.hpp"
#include "fluid/equilibrium.hpp"
#include "fluid/moments.hpp"
#include "fluid/populations.hpp"
#include "fluid/relaxation.hpp"
#include "grid/field.hpp"

namespace tt {

/// One fused collision and streaming pass (Eqs. 1–4), in place, walls and pressure ends included.
///   in:  force (per site, membrane), body_force (uniform), relaxation,
///        populations (halo filled in phase odd)
///   out: what departs, in the layout of the next phase;
///        velocity u = Σ f c + ½F (÷ ρ in the full equilibrium) at the old time, halo untouched
/// `velocity` may be `force`, whose values it then replaces. Guo's forcing (Eq. 3 as corrected)
/// split into its even and odd part, each with its own rate. Team function. `settle` (exchange.hpp)
/// then flips the phase and brings the halo in line.
template <class Real>
void collide_and_stream(const Equilibrium& equilibrium, const Boundaries& boundaries,
                        Vec2 body_force, const VectorField<Real>& force,
                        const Relaxation<Real>& relaxation, Populations<Real>& populations,
                        VectorField<Real>& velocity);

/// The same pass written plainly, out of place and site by site: the oracle of the fast one. Serial
/// and slow; takes either phase, needs no halo (it wraps x, and y where there are no walls), and
/// leaves phase even.
template <class Real>
void collide_and_stream_reference(const Equilibrium& equilibrium, const Boundaries& boundaries,
                                  Vec2 body_force, const VectorField<Real>& force,
                                  const Relaxation<Real>& relaxation,
                                  Populations<Real>& populations, VectorField<Real>& velocity);

}  // namespace tt
