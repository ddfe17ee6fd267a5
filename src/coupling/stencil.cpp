#include "coupling/stencil.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/contracts.hpp"
#include "base/isa.hpp"
#include "base/parallel.hpp"

namespace tt {
namespace {

constexpr int reach = Stencils::reach;

/// One axis of the stencils: positions in, block starts and weights out. Site k stands at k + ½.
struct Axis {
    const double* position;
    double period;  ///< wraps the block start into the box; 0: no wrap
    std::int32_t* start;
    double* weights;
};

template <class Kernel>
TT_INLINE void weigh(const Axis& axis, int begin, int end) {
    const double* const position = axis.position;
    const double period = axis.period;
    const double inverse = period > 0.0 ? 1.0 / period : 0.0;
    std::int32_t* const start = axis.start;
    double* const weights = axis.weights;
#pragma omp simd
    for (int n = begin; n < end; ++n) {
        const double wrapped = position[n] - period * std::floor(position[n] * inverse);
        const double second = std::floor(wrapped - 0.5);
        double w[reach];
        Kernel::weights(wrapped - 0.5 - second, w);
        start[n] = static_cast<std::int32_t>(second) - 1;
        for (int k = 0; k < reach; ++k) weights[reach * n + k] = w[k];
    }
}

using Weigh = void (*)(const Axis&, int, int);

// A function that the loader picks by processor cannot be a template: one line per kernel.
TT_CLONES void weigh_cosine4(const Axis& axis, int begin, int end) { weigh<Cosine4>(axis, begin, end); }
TT_CLONES void weigh_hat2(const Axis& axis, int begin, int end) { weigh<Hat2>(axis, begin, end); }
TT_CLONES void weigh_roma3(const Axis& axis, int begin, int end) { weigh<Roma3>(axis, begin, end); }
TT_CLONES void weigh_peskin4(const Axis& axis, int begin, int end) { weigh<Peskin4>(axis, begin, end); }

struct WeighOf {
    Weigh operator()(Cosine4) const { return weigh_cosine4; }
    Weigh operator()(Hat2) const { return weigh_hat2; }
    Weigh operator()(Roma3) const { return weigh_roma3; }
    Weigh operator()(Peskin4) const { return weigh_peskin4; }
};

/// Linear extrapolation from the two rows nearest to a wall, for a node so near that fewer than two carry weight.
void extrapolate(double y, int start, int ny, double* w) {
    const int nearest = y < 0.5 * ny ? 0 : ny - 2;
    for (int k = 0; k < reach; ++k) w[k] = 0.0;
    const double along = y - (nearest + 0.5);
    w[nearest - start] = 1.0 - along;
    w[nearest - start + 1] = along;
}

/// Makes the y weights of a node one-sided where its block sticks out of 0 ≤ j < ny: drops those outside and
/// multiplies the rest by a + b r (r = site − node) such that Σ w = 1 and Σ w r = 0. Force and torque are then
/// conserved up to the wall, and a linear velocity is interpolated exactly.
void make_one_sided(double y, int start, int ny, double* w) {
    double m0 = 0.0, m1 = 0.0, m2 = 0.0;
    for (int k = 0; k < reach; ++k) {
        if (start + k < 0 || start + k >= ny) w[k] = 0.0;
        const double r = start + k + 0.5 - y;
        m0 += w[k];
        m1 += w[k] * r;
        m2 += w[k] * r * r;
    }
    const double determinant = m0 * m2 - m1 * m1;
    if (determinant < 1e-9) {
        extrapolate(y, start, ny, w);
        return;
    }
    for (int k = 0; k < reach; ++k) w[k] *= (m2 - m1 * (start + k + 0.5 - y)) / determinant;
}

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

TT_CLONES void spread_rows(const Stencils& stencils, const Suspension& cells, const Rows& rows) {
    const int count = cells.node_count();
    for (int n = 0; n < count; ++n) {
        const int j0 = stencils.j[n];
        const int first = std::max(rows.begin - j0, 0);
        const int last = std::min(rows.end - j0, reach);
        const double* const wx = &stencils.wx[reach * n];
        const double* const wy = &stencils.wy[reach * n];
        for (int l = first; l < last; ++l) {
            const std::ptrdiff_t at = (j0 + l) * rows.pitch + stencils.i[n];
            const double fx = cells.fx[n] * wy[l];
            const double fy = cells.fy[n] * wy[l];
            for (int k = 0; k < reach; ++k) rows.x[at + k] += fx * wx[k];
            for (int k = 0; k < reach; ++k) rows.y[at + k] += fy * wx[k];
        }
    }
}

TT_CLONES void interpolate_nodes(const Stencils& stencils, const double* x, const double* y, std::ptrdiff_t pitch,
                                 double* ux, double* uy, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        const double* const wx = &stencils.wx[reach * n];
        const double* const wy = &stencils.wy[reach * n];
        double sum_x[reach] = {}, sum_y[reach] = {};
        for (int l = 0; l < reach; ++l) {
            const std::ptrdiff_t at = (stencils.j[n] + l) * pitch + stencils.i[n];
            for (int k = 0; k < reach; ++k) sum_x[k] += wy[l] * x[at + k];
            for (int k = 0; k < reach; ++k) sum_y[k] += wy[l] * y[at + k];
        }
        ux[n] = (sum_x[0] * wx[0] + sum_x[1] * wx[1]) + (sum_x[2] * wx[2] + sum_x[3] * wx[3]);
        uy[n] = (sum_y[0] * wx[0] + sum_y[1] * wx[1]) + (sum_y[2] * wx[2] + sum_y[3] * wx[3]);
    }
}

}  // namespace

void locate(const Delta& delta, const Lattice& lattice, const Suspension& cells, Stencils& stencils) {
    TT_EXPECTS(static_cast<int>(stencils.i.size()) == cells.node_count());
    const auto [begin, end] = team_share(cells.node_count());
    const Weigh weigh_axis = std::visit(WeighOf{}, delta);
    const double y_period = lattice.walls ? 0.0 : lattice.ny;
    weigh_axis({cells.x.data(), static_cast<double>(lattice.nx), stencils.i.data(), stencils.wx.data()}, begin, end);
    weigh_axis({cells.y.data(), y_period, stencils.j.data(), stencils.wy.data()}, begin, end);
    if (lattice.walls) {
        for (int n = begin; n < end; ++n) {
            const int j = stencils.j[n];
            if (j < 0 || j + reach > lattice.ny) make_one_sided(cells.y[n], j, lattice.ny, &stencils.wy[reach * n]);
        }
    }
    team_barrier();
}

void spread(const Stencils& stencils, const Suspension& cells, VectorField& force) {
    spread_rows(stencils, cells, own_rows(force));
    team_barrier();
}

void unspread(const Stencils& stencils, VectorField& force) {
    const Lattice& lattice = force.x.lattice();
    const Rows rows = own_rows(force);
    const auto clear = [&](int i, int j) {
        const std::ptrdiff_t at = j * rows.pitch + i;
        for (int k = 0; k < reach; ++k) rows.x[at + k] = rows.y[at + k] = 0.0;
    };
    const int count = static_cast<int>(stencils.i.size());
    for (int n = 0; n < count; ++n) {
        const int i = stencils.i[n];
        for (int l = 0; l < reach; ++l) {
            const int j = stencils.j[n] + l;
            // What hung over an edge was folded to the other side: clear it there as well.
            const int across_j = j < 0 ? j + lattice.ny : j - lattice.ny;
            for (const int row : {j, across_j}) {
                if (row < rows.begin || row >= rows.end) continue;
                clear(i, row);
                if (i < 0) clear(i + lattice.nx, row);
                if (i + reach > lattice.nx) clear(i - lattice.nx, row);
            }
        }
    }
    team_barrier();
}

void interpolate(const Stencils& stencils, const VectorField& velocity, Suspension& cells) {
    const auto [begin, end] = team_share(cells.node_count());
    interpolate_nodes(stencils, velocity.x.row(0), velocity.y.row(0), velocity.x.lattice().pitch(),
                      cells.ux.data(), cells.uy.data(), begin, end);
    team_barrier();
}

}  // namespace tt
