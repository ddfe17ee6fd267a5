#pragma once

#include "grid/field.hpp"

namespace tt {

/// Relaxation rates per site: `even` = 1/τ⁺ relaxes the symmetric part of the populations and sets
/// the viscosity, `odd` = 1/τ⁻ the antisymmetric part. BGK is the case odd = even, TRT ties them by
/// (τ⁺ − ½)(τ⁻ − ½) = Λ. Stored, not derived in the kernel, because two divisions a site would cost
/// as much as the rest of the collision.
template <class Real = double>
struct Relaxation {
    Field<Real> even;
    Field<Real> odd;

    Relaxation() = default;
    explicit Relaxation(const Lattice& lattice) : even(lattice, 1), odd(lattice, 1) {}
};

}  // namespace tt
