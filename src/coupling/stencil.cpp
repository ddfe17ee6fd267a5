#include "coupling/stencil.hpp"

#include <algorithm>

#include "base/four.hpp"
#include "base/isa.hpp"
#include "base/parallel.hpp"

namespace tt {
namespace {

constexpr int width = Stencils::width;
/// How many nodes ahead the sites of a node are fetched: the fluid pass has driven them out of the
/// near caches, and the way around an outline is none that the processor foresees. Sets cost only.
constexpr int ahead = 12;

/// What a thread adds to or clears: rows [begin, end) of one field pair.
struct Rows {
    int begin;
    int end;
    double* x;  ///< at site (0, 0)
    double* y;
    std::ptrdiff_t pitch;
};

Rows own_rows(VectorField& field) {
    const Lattice& lattice = field.x.lattice();
    auto [begin, end] = team_share(lattice.ny);
    // The halo rows go with the outermost shares.
    if (begin == 0) begin -= Lattice::halo;
    if (end == lattice.ny) end += Lattice::halo;
    return {begin, end, field.x.row(0), field.y.row(0), lattice.pitch()};
}

/// A node's force and dipole: on a site of weights w and slopes s the force is F wₓ wᵧ + D·(sₓ wᵧ,
/// wₓ sᵧ).
template <Order order>
TT_INLINE void spread_nodes(const Stencils& stencils, const Suspension& cells, const Rows& rows) {
    const int count = cells.node_count();
    for (int n = 0; n < count; ++n) {
        const int j0 = stencils.j[n];
        const int first = std::max(rows.begin - j0, 0);
        const int last = std::min(rows.end - j0, stencils.points);
        const Four wx = load_four(&stencils.wx[width * n]);
        const Four sx = load_four(&stencils.sx[width * n]);
        const double* const wy = &stencils.wy[width * n];
        const double* const sy = &stencils.sy[width * n];
        const double fx = cells.fx[n], fy = cells.fy[n];
        const double xx = cells.dipole_xx[n], xy = cells.dipole_xy[n];
        double* x = rows.x + (j0 + first) * rows.pitch + stencils.i[n];
        double* y = rows.y + (j0 + first) * rows.pitch + stencils.i[n];
        for (int l = first; l < last; ++l, x += rows.pitch, y += rows.pitch) {
            if constexpr (order == Order::zeroth) {
                store_four(x, load_four(x) + (fx * wy[l]) * wx);
                store_four(y, load_four(y) + (fy * wy[l]) * wx);
            } else {
                store_four(x, load_four(x) + ((fx * wy[l] + xy * sy[l]) * wx + (xx * wy[l]) * sx));
                store_four(y, load_four(y) + ((fy * wy[l] - xx * sy[l]) * wx + (xy * wy[l]) * sx));
            }
        }
    }
}

/// Zeroes a row of both fields, halo included, but for the blocks that are not marked.
TT_CLONES void clear_row(double* x, double* y, int nx, const std::uint8_t* marks, int blocks) {
    constexpr int sites = SiteBlocks::width, halo = Lattice::halo;
    for (double* const row : {x, y}) {
        std::fill_n(row - halo, halo, 0.0);
        std::fill_n(row + nx, halo, 0.0);
    }
    for (int b = 0; b < blocks; ++b) {
        if (!marks[b]) continue;
        std::fill_n(x + b * sites, sites, 0.0);
        std::fill_n(y + b * sites, sites, 0.0);
    }
}

template <Order order>
TT_INLINE void interpolate_nodes(const Stencils& stencils, const VectorField& velocity,
                                 Suspension& cells, int begin, int end) {
    const double* const x = velocity.x.row(0);
    const double* const y = velocity.y.row(0);
    const std::ptrdiff_t pitch = velocity.x.lattice().pitch();
    const auto fetch = [&](int n) TT_INLINE_LAMBDA {
        const std::ptrdiff_t corner = stencils.j[n] * pitch + stencils.i[n];
        for (int l = 0; l < stencils.points; ++l) {
            __builtin_prefetch(x + corner + l * pitch);
            __builtin_prefetch(y + corner + l * pitch);
        }
    };
    for (int n = begin; n < end; ++n) {
        fetch(std::min(n + ahead, end - 1));
        const double* const wy = &stencils.wy[width * n];
        const double* const sy = &stencils.sy[width * n];
        const std::ptrdiff_t corner = stencils.j[n] * pitch + stencils.i[n];
        // Sums along y for each column of the block: values and, for the shear rate, slopes.
        Four ux{}, uy{}, slope_x{}, slope_y{};
        for (int l = 0; l < stencils.points; ++l) {
            const Four row_x = load_four(x + corner + l * pitch);
            const Four row_y = load_four(y + corner + l * pitch);
            ux += wy[l] * row_x;
            uy += wy[l] * row_y;
            if constexpr (order == Order::first) {
                slope_x += sy[l] * row_x;
                slope_y += sy[l] * row_y;
            }
        }
        const Four wx = load_four(&stencils.wx[width * n]);
        Four xx{}, xy{};
        if constexpr (order == Order::first) {
            const Four sx = load_four(&stencils.sx[width * n]);
            xx = ux * sx - slope_y * wx;
            xy = slope_x * wx + uy * sx;
        }
        const Four sums = sums_of(ux * wx, uy * wx, xx, xy);
        cells.ux[n] = sums[0];
        cells.uy[n] = sums[1];
        if constexpr (order == Order::first) {
            cells.rate_xx[n] = sums[2];
            cells.rate_xy[n] = sums[3];
        }
    }
}

// A function that the loader picks by processor cannot be a template: one line per order.
TT_CLONES void spread_forces(const Stencils& w, const Suspension& s, const Rows& r) {
    spread_nodes<Order::zeroth>(w, s, r);
}
TT_CLONES void spread_dipoles(const Stencils& w, const Suspension& s, const Rows& r) {
    spread_nodes<Order::first>(w, s, r);
}
TT_CLONES void interpolate_velocity(const Stencils& w, const VectorField& u, Suspension& s,
                                    int begin, int end) {
    interpolate_nodes<Order::zeroth>(w, u, s, begin, end);
}
TT_CLONES void interpolate_rate(const Stencils& w, const VectorField& u, Suspension& s, int begin,
                                int end) {
    interpolate_nodes<Order::first>(w, u, s, begin, end);
}

}  // namespace

void spread(Order order, const Stencils& stencils, const Suspension& cells, VectorField& force) {
    (order == Order::zeroth ? spread_forces : spread_dipoles)(stencils, cells, own_rows(force));
    team_barrier();
}

void unspread(const Stencils& stencils, VectorField& force) {
    const Rows rows = own_rows(force);
    const Lattice& lattice = force.x.lattice();
    const SiteBlocks& near = stencils.near_membranes;
    for (int j = rows.begin; j < rows.end; ++j) {
        double* const x = force.x.row(j);
        double* const y = force.y.row(j);
        if (j >= 0 && j < lattice.ny) {
            clear_row(x, y, lattice.nx, near.row(j), near.per_row());
        } else {
            std::fill(x - Lattice::halo, x + lattice.nx + Lattice::halo, 0.0);
            std::fill(y - Lattice::halo, y + lattice.nx + Lattice::halo, 0.0);
        }
    }
    team_barrier();
}

void interpolate(Order order, const Stencils& stencils, const VectorField& velocity,
                 Suspension& cells) {
    const auto [begin, end] = team_share(cells.node_count());
    (order == Order::zeroth ? interpolate_velocity : interpolate_rate)(stencils, velocity, cells,
                                                                       begin, end);
    team_barrier();
}

}  // namespace tt
