#pragma once

#include <string_view>

#include "base/isa.hpp"

namespace tt {

/// The surface of a drop: T = γ whatever the stretch, energy γ per length, W = γ (λ − 1) per rest
/// length. Constant tension has no force along the surface, so nothing holds the nodes where they
/// are on it: they are carried like tracers. On a drop of viscosity ratio r in shear each goes
/// round and round at a speed ∝ 1 − sin 2θ/(1 + r) (small deformation), so that evenly laid nodes
/// spread and gather by up to ((2 + r)/r)² and no more: 9 at r = 1, 2 at r = 5. A bubble's nodes
/// would run together.
struct SurfaceTension {
    static constexpr std::string_view name = "surface-tension";
    double shear_modulus = 0.0;  ///< γ, in the place of E_s: G (Eq. 19) is the capillary number

    TT_INLINE double tension(double /*stretch*/) const { return shear_modulus; }
    TT_INLINE double slope(double /*stretch*/) const { return 0.0; }
    double energy(double stretch) const { return shear_modulus * (stretch - 1.0); }
    friend bool operator==(const SurfaceTension&, const SurfaceTension&) = default;
};

}  // namespace tt
