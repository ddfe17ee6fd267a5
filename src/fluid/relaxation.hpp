#pragma once

#include <array>

#include "fluid/collision/collision.hpp"
#include "grid/field.hpp"
#include "grid/site_blocks.hpp"

namespace tt {

/// Relaxation rates per site: `even` = 1/τ⁺ relaxes the symmetric part of the populations and sets
/// the viscosity, `odd` = 1/τ⁻ the antisymmetric part. BGK is the case odd = even, TRT ties them by
/// (τ⁺ − ½)(τ⁻ − ½) = Λ. Stored, not derived in the kernel, because two divisions a site would cost
/// as much as the rest of the collision.
template <class Real = double>
struct Relaxation {
    Field<Real> even;
    Field<Real> odd;

    /// Most sites have one of few viscosities. `kind` marks the blocks of eight sites whose rates
    /// are all `rates_of_kind[kind]`, so that the pass need not load them; 0: any rates.
    static constexpr int kinds = 4;
    SiteBlocks kind;
    std::array<Rates, kinds> rates_of_kind{};

    Relaxation() = default;
    explicit Relaxation(const Lattice& lattice)
        : even(lattice, 1), odd(lattice, 1), kind(lattice) {}
};

}  // namespace tt
