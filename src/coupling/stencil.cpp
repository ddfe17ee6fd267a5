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

/// The marks of this thread's rows [begin, end) and of those below whose blocks may reach them.
struct Marks {
    SiteBlocks& near;
    std::uint8_t* below;
    int begin, end;
    int reach;  ///< rows that a block goes beyond the one in which it starts

    TT_INLINE std::uint8_t* row(int j) const {
        return j >= begin ? near.row(j) : below + (j - begin + reach) * near.pitch();
    }
};

/// Marks, in the row in which a block starts, the columns it covers, through the ends of the box if
/// it must: then the last and the first block of sites are marked as well.
template <class Real>
void mark_starts(const Lattice& lattice, const Stencils<Real>& stencils, const Marks& marks) {
    constexpr unsigned sites = SiteBlocks::width;
    const int count = static_cast<int>(stencils.i.size());
    for (const int shift : {0, -lattice.ny, lattice.ny}) {
        if (shift != 0 && lattice.walls) break;
        for (int n = 0; n < count; ++n) {
            const int j = stencils.j[n] + shift;
            if (j < marks.begin - marks.reach || j >= marks.end) continue;
            const int i = stencils.i[n], last = i + stencils.points - 1;
            const bool inside = i >= 0 && last < lattice.nx;
            std::uint8_t* const row = marks.row(j);
            row[inside ? i / sites : 0] = 1;
            row[inside ? last / sites : marks.near.per_row() - 1] = 1;
            if (!inside) row[(i < 0 ? i + lattice.nx : i) / sites] = 1;
        }
    }
}

/// From the top down, adds to each row the marks of those below from which blocks reach it.
TT_CLONES void extend_upwards(const Marks& marks) {
    const int pitch = marks.near.pitch();
    for (int j = marks.end - 1; j >= marks.begin; --j) {
        std::uint8_t* const __restrict row = marks.row(j);
        for (int below = 1; below <= marks.reach; ++below) {
            const std::uint8_t* const starts = marks.row(j - below);
            for (int b = 0; b < pitch; b += 64)
                for (int k = b; k < b + 64; ++k) row[k] |= starts[k];
        }
    }
}

/// Marks the sites near membranes in this thread's rows.
template <class Real>
void mark_near_membranes(const Lattice& lattice, Stencils<Real>& stencils) {
    thread_local std::vector<std::uint8_t> below;
    SiteBlocks& near = stencils.near_membranes;
    const auto [begin, end] = own_rows(lattice);
    const int reach = stencils.points - 1;
    below.assign(static_cast<std::size_t>(reach * near.pitch()), 0);
    std::fill(near.row(begin), near.row(end), std::uint8_t{0});
    const Marks marks{near, below.data(), begin, end, reach};
    mark_starts(lattice, stencils, marks);
    extend_upwards(marks);
}

/// A node's force and dipole: on a site of weights w and slopes s the force is F wₓ wᵧ + D·(sₓ wᵧ,
/// wₓ sᵧ).
template <Order order, class Real>
TT_INLINE void spread_nodes(const Stencils<Real>& stencils, const Suspension& cells,
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

/// Zeroes a row of both fields, halo included, but for the blocks that are not marked.
template <class Real>
TT_INLINE void clear_row(Real* x, Real* y, int nx, const std::uint8_t* marks, int blocks) {
    constexpr int sites = SiteBlocks::width, halo = Lattice::halo;
    for (Real* const row : {x, y}) {
        std::fill_n(row - halo, halo, Real{0});
        std::fill_n(row + nx, halo, Real{0});
    }
    for (int b = 0; b < blocks; ++b) {
        if (!marks[b]) continue;
        std::fill_n(x + b * sites, sites, Real{0});
        std::fill_n(y + b * sites, sites, Real{0});
    }
}

template <Order order, class Real>
TT_INLINE void interpolate_nodes(const Stencils<Real>& stencils, const VectorField<Real>& velocity,
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

// A function that the loader picks by processor cannot be a template: one line per order and Real.
TT_CLONES void clear_marked(double* x, double* y, int nx, const std::uint8_t* marks, int blocks) {
    clear_row(x, y, nx, marks, blocks);
}
TT_CLONES void spread_forces(const Stencils<double>& w, const Suspension& s,
                             const Rows<double>& r) {
    spread_nodes<Order::zeroth>(w, s, r);
}
TT_CLONES void spread_dipoles(const Stencils<double>& w, const Suspension& s,
                              const Rows<double>& r) {
    spread_nodes<Order::first>(w, s, r);
}
TT_CLONES void interpolate_velocity(const Stencils<double>& w, const VectorField<double>& u,
                                    Suspension& s, int begin, int end) {
    interpolate_nodes<Order::zeroth>(w, u, s, begin, end);
}
TT_CLONES void interpolate_rate(const Stencils<double>& w, const VectorField<double>& u,
                                Suspension& s, int begin, int end) {
    interpolate_nodes<Order::first>(w, u, s, begin, end);
}
TT_CLONES void clear_marked(float* x, float* y, int nx, const std::uint8_t* marks, int blocks) {
    clear_row(x, y, nx, marks, blocks);
}
TT_CLONES void spread_forces(const Stencils<float>& w, const Suspension& s, const Rows<float>& r) {
    spread_nodes<Order::zeroth>(w, s, r);
}
TT_CLONES void spread_dipoles(const Stencils<float>& w, const Suspension& s, const Rows<float>& r) {
    spread_nodes<Order::first>(w, s, r);
}
TT_CLONES void interpolate_velocity(const Stencils<float>& w, const VectorField<float>& u,
                                    Suspension& s, int begin, int end) {
    interpolate_nodes<Order::zeroth>(w, u, s, begin, end);
}
TT_CLONES void interpolate_rate(const Stencils<float>& w, const VectorField<float>& u,
                                Suspension& s, int begin, int end) {
    interpolate_nodes<Order::first>(w, u, s, begin, end);
}

}  // namespace

template <class Real>
void spread(Order order, Stencils<Real>& stencils, const Suspension& cells,
            VectorField<Real>& force) {
    team_barrier();  // all nodes have their stencils and forces
    mark_near_membranes(force.x.lattice(), stencils);
    const Rows<Real> rows = rows_of(force);
    if (order == Order::zeroth)
        spread_forces(stencils, cells, rows);
    else
        spread_dipoles(stencils, cells, rows);
}

template <class Real>
void unspread(const Stencils<Real>& stencils, VectorField<Real>& force) {
    const Rows<Real> rows = rows_of(force);
    const Lattice& lattice = force.x.lattice();
    const SiteBlocks& near = stencils.near_membranes;
    for (int j = rows.begin; j < rows.end; ++j) {
        Real* const x = force.x.row(j);
        Real* const y = force.y.row(j);
        if (j >= 0 && j < lattice.ny) {
            clear_marked(x, y, lattice.nx, near.row(j), near.per_row());
        } else {
            std::fill(x - Lattice::halo, x + lattice.nx + Lattice::halo, Real{0});
            std::fill(y - Lattice::halo, y + lattice.nx + Lattice::halo, Real{0});
        }
    }
}

template <class Real>
void interpolate(Order order, const Stencils<Real>& stencils, const VectorField<Real>& velocity,
                 Suspension& cells, int cell) {
    const int begin = cells.first[cell], end = cells.first[cell + 1];
    if (order == Order::zeroth)
        interpolate_velocity(stencils, velocity, cells, begin, end);
    else
        interpolate_rate(stencils, velocity, cells, begin, end);
}

template void spread(Order, Stencils<double>&, const Suspension&, VectorField<double>&);
template void unspread(const Stencils<double>&, VectorField<double>&);
template void interpolate(Order, const Stencils<double>&, const VectorField<double>&, Suspension&,
                          int);
template void spread(Order, Stencils<float>&, const Suspension&, VectorField<float>&);
template void unspread(const Stencils<float>&, VectorField<float>&);
template void interpolate(Order, const Stencils<float>&, const VectorField<float>&, Suspension&,
                          int);

}  // namespace tt
