#include "coupling/stencil.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/four.hpp"
#include "base/isa.hpp"
#include "base/parallel.hpp"

namespace tt {
namespace {

constexpr int width = Stencils<>::width;
/// How many nodes ahead the sites of a node are fetched: the fluid pass has driven them out of the
/// near caches, and the way around an outline is none that the processor foresees. Sets cost only.
constexpr int ahead = 12;

/// What a thread adds to or clears: rows [begin, end) of one field pair.
template <class Real>
struct Rows {
    int begin;
    int end;
    Real* x;  ///< at site (0, 0)
    Real* y;
    std::ptrdiff_t pitch;
};

template <class Real>
Rows<Real> rows_of(VectorField<Real>& field) {
    const Lattice& lattice = field.x.lattice();
    const auto [begin, end] = own_rows_with_halo(lattice);
    return {begin, end, field.x.row(0), field.y.row(0), lattice.pitch()};
}

/// A node's force and dipole: on a site of weights w and slopes s the force is F wₓ wᵧ + D·(sₓ wᵧ,
/// wₓ sᵧ).
template <Order order, class Real>
TT_CLONES void spread_nodes(const Stencils<Real>& stencils, const Suspension& cells,
                            const Rows<Real>& rows) {
    const int count = cells.node_count();
    for (int n = 0; n < count; ++n) {
        const int j0 = stencils.j[n];
        const int first = std::max(rows.begin - j0, 0);
        const int last = std::min(rows.end - j0, stencils.points);
        if (first >= last) continue;
        const Four<Real> wx = load_four(&stencils.wx[width * n]);
        const Four<Real> sx = load_four(&stencils.sx[width * n]);
        const Real* const wy = &stencils.wy[width * n];
        const Real* const sy = &stencils.sy[width * n];
        // What goes along a row with its weight and, of the dipole, with its slope.
        Four<Real> weighted_x = Real(cells.fx[n]) * wx, weighted_y = Real(cells.fy[n]) * wx;
        Four<Real> sloped_x{}, sloped_y{};
        if constexpr (order == Order::first) {
            const Real xx = Real(cells.dipole_xx[n]), xy = Real(cells.dipole_xy[n]);
            weighted_x += xx * sx;
            weighted_y += xy * sx;
            sloped_x = xy * wx;
            sloped_y = -xx * wx;
        }
        Real* x = rows.x + (j0 + first) * rows.pitch + stencils.i[n];
        Real* y = rows.y + (j0 + first) * rows.pitch + stencils.i[n];
        for (int l = first; l < last; ++l, x += rows.pitch, y += rows.pitch) {
            Four<Real> given_x = wy[l] * weighted_x, given_y = wy[l] * weighted_y;
            if constexpr (order == Order::first) {
                given_x += sy[l] * sloped_x;
                given_y += sy[l] * sloped_y;
            }
            store_four(x, load_four(x) + given_x);
            store_four(y, load_four(y) + given_y);
        }
    }
}

template <Order order, class Real>
TT_CLONES void interpolate_nodes(const Stencils<Real>& stencils, const VectorField<Real>& velocity,
                                 Suspension& cells, int begin, int end) {
    const Real* const x = velocity.x.row(0);
    const Real* const y = velocity.y.row(0);
    const std::ptrdiff_t pitch = velocity.x.lattice().pitch();
    const auto fetch = [&](int n) TT_INLINE_LAMBDA {
        const std::ptrdiff_t corner = stencils.j[n] * pitch + stencils.i[n];
        for (int l = 0; l < stencils.points; ++l) {
            __builtin_prefetch(x + corner + l * pitch);
            __builtin_prefetch(y + corner + l * pitch);
        }
    };
    for (int n = begin; n < end; ++n) {
        fetch(std::min(n + ahead, cells.node_count() - 1));
        const Real* const wy = &stencils.wy[width * n];
        const Real* const sy = &stencils.sy[width * n];
        const std::ptrdiff_t corner = stencils.j[n] * pitch + stencils.i[n];
        // Sums along y for each column of the block, of u_x and u_y side by side: values and, for
        // the shear rate, slopes.
        Eight<Real> values{}, slopes{};
        for (int l = 0; l < stencils.points; ++l) {
            const Eight<Real> row =
                both(load_four(x + corner + l * pitch), load_four(y + corner + l * pitch));
            values += wy[l] * row;
            if constexpr (order == Order::first) slopes += sy[l] * row;
        }
        const Four<Real> wx = load_four(&stencils.wx[width * n]);
        Eight<Real> rates{};  // ∂ₓuₓ − ∂ᵧuᵧ and ∂ₓuᵧ + ∂ᵧuₓ
        if constexpr (order == Order::first) {
            const Four<Real> sx = load_four(&stencils.sx[width * n]);
            rates = values * both(sx, sx) + swapped(slopes) * both(-wx, wx);
        }
        const Four<Real> sums = sums_of(values * both(wx, wx), rates);
        cells.ux[n] = sums[0];
        cells.uy[n] = sums[2];
        if constexpr (order == Order::first) {
            cells.rate_xx[n] = sums[1];
            cells.rate_xy[n] = sums[3];
        }
    }
}

}  // namespace

template <class Real>
void spread(Order order, const Stencils<Real>& stencils, const Suspension& cells,
            VectorField<Real>& force) {
    team_barrier();  // all nodes have their stencils and forces
    const Rows<Real> rows = rows_of(force);
    if (order == Order::zeroth)
        spread_nodes<Order::zeroth>(stencils, cells, rows);
    else
        spread_nodes<Order::first>(stencils, cells, rows);
}

template <class Real>
void clear(VectorField<Real>& force) {
    const auto [begin, end] = own_rows_with_halo(force.x.lattice());
    const int width = force.x.lattice().nx + 2 * Lattice::halo;
    for (int j = begin; j < end; ++j) {
        std::fill_n(force.x.row(j) - Lattice::halo, width, Real{0});
        std::fill_n(force.y.row(j) - Lattice::halo, width, Real{0});
    }
}

template <class Real>
void interpolate(Order order, const Stencils<Real>& stencils, const VectorField<Real>& velocity,
                 Suspension& cells, int cell) {
    const int begin = cells.first[cell], end = cells.first[cell + 1];
    if (order == Order::zeroth)
        interpolate_nodes<Order::zeroth>(stencils, velocity, cells, begin, end);
    else
        interpolate_nodes<Order::first>(stencils, velocity, cells, begin, end);
}

template void spread(Order, const Stencils<double>&, const Suspension&, VectorField<double>&);
template void clear(VectorField<double>&);
template void interpolate(Order, const Stencils<double>&, const VectorField<double>&, Suspension&,
                          int);
template void spread(Order, const Stencils<float>&, const Suspension&, VectorField<float>&);
template void clear(VectorField<float>&);
template void interpolate(Order, const Stencils<float>&, const VectorField<float>&, Suspension&,
                          int);

}  // namespace tt
