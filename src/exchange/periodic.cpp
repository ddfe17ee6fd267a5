#include "exchange/periodic.hpp"

#include <algorithm>

namespace tt {
namespace {

/// Calls f(i, x, y, home_x, home_y, length) for each run of halo sites of slot i that an odd pass
/// uses: the neighbours along c_i, outside the box, of sites in it, and the sites they stand for.
/// Each thread its share.
template <class F>
void for_each_halo_run(const Lattice& lattice, F&& f) {
    const auto [begin, end] = own_rows(lattice);
    for (int i = 1; i < d2q9::count; ++i) {
        if (d2q9::cx[i] == 0) continue;
        const int x = d2q9::cx[i] > 0 ? lattice.nx : -1;
        for (int y = begin + d2q9::cy[i]; y < end + d2q9::cy[i]; ++y) {
            if (lattice.walls && (y < 0 || y >= lattice.ny)) continue;
            f(i, x, y, wrapped(x, lattice.nx), wrapped(y, lattice.ny), 1);
        }
    }
    if (lattice.walls || team_rank() != 0) return;
    for (int i = 1; i < d2q9::count; ++i) {
        if (d2q9::cy[i] == 0) continue;
        const int y = d2q9::cy[i] > 0 ? lattice.ny : -1;
        const int x = std::max(0, d2q9::cx[i]);
        const int length = lattice.nx - std::abs(d2q9::cx[i]);
        f(i, x, y, x, wrapped(y, lattice.ny), length);
    }
}

/// Most runs are of one site: too short for a call.
template <class Real>
void copy(const Real* from, int length, Real* to) {
    if (length == 1)
        *to = *from;
    else
        std::copy_n(from, length, to);
}

template <class F>
void for_each_own_row_with_halo(const Lattice& lattice, F&& f) {
    const auto [begin, end] = own_rows_with_halo(lattice);
    for (int j = begin; j < end; ++j) f(j);
}

bool outside(const Lattice& lattice, int j) { return j < 0 || j >= lattice.ny; }

template <class Real>
void fill_row(Field<Real>& field, int j) {
    const Lattice& lattice = field.lattice();
    const Real* const sites = field.row(wrapped(j, lattice.ny));
    Real* const row = field.row(j);
    if (outside(lattice, j)) std::copy(sites, sites + lattice.nx, row);
    for (int x = 1; x <= Lattice::halo; ++x) {
        row[-x] = sites[wrapped(-x, lattice.nx)];
        row[lattice.nx - 1 + x] = sites[wrapped(x - 1, lattice.nx)];
    }
}

/// Adds the ends of row j to the sites of row j and clears them.
template <class Real>
void fold_ends(Field<Real>& field, int j) {
    const Lattice& lattice = field.lattice();
    Real* const row = field.row(j);
    for (int x = 1; x <= Lattice::halo; ++x) {
        row[wrapped(-x, lattice.nx)] += row[-x];
        row[wrapped(x - 1, lattice.nx)] += row[lattice.nx - 1 + x];
        row[-x] = 0;
        row[lattice.nx - 1 + x] = 0;
    }
}

template <class Real>
void clear_row(Field<Real>& field, int j) {
    Real* const row = field.row(j);
    std::fill(row - Lattice::halo, row + field.lattice().nx + Lattice::halo, Real{0});
}

/// Adds the rows outside to the rows they stand for and clears them; a share of columns each.
template <class Real>
void fold_rows(Field<Real>& field) {
    const Lattice& lattice = field.lattice();
    const auto [begin, end] = team_share(lattice.nx);
    for (int j = -Lattice::halo; j < lattice.ny + Lattice::halo; ++j) {
        if (!outside(lattice, j)) continue;
        Real* const from = field.row(j);
        Real* const to = field.row(wrapped(j, lattice.ny));
        for (int x = begin; x < end; ++x) {
            to[x] += from[x];
            from[x] = 0;
        }
    }
}

template <class Real>
void fill_sites(Populations<Real>& populations) {
    Real* const f = populations.data();
    for_each_halo_run(
        populations.lattice(), [&](int i, int x, int y, int home_x, int home_y, int length) {
            copy(f + populations.row(i, home_y) + home_x, length, f + populations.row(i, y) + x);
        });
}

template <class Real>
void fold_sites(Populations<Real>& populations) {
    Real* const f = populations.data();
    for_each_halo_run(
        populations.lattice(), [&](int i, int x, int y, int home_x, int home_y, int length) {
            copy(f + populations.row(i, y) + x, length, f + populations.row(i, home_y) + home_x);
        });
}

template <class Real>
void fill_sites(VectorField<Real>& field) {
    const Lattice& lattice = field.x.lattice();
    if (!lattice.walls) team_barrier();  // rows of one end go to the other
    for_each_own_row_with_halo(lattice, [&](int j) {
        if (lattice.walls && outside(lattice, j)) return;
        fill_row(field.x, j);
        fill_row(field.y, j);
    });
}

template <class Real>
void fold_sites(VectorField<Real>& field) {
    const Lattice& lattice = field.x.lattice();
    for_each_own_row_with_halo(lattice, [&](int j) {
        for (Field<Real>* component : {&field.x, &field.y}) {
            if (lattice.walls && outside(lattice, j)) {
                clear_row(*component, j);
            } else {
                fold_ends(*component, j);
            }
        }
    });
    if (lattice.walls) return;
    team_barrier();
    fold_rows(field.x);
    fold_rows(field.y);
    team_barrier();
}

}  // namespace

// A virtual function cannot be a template: one line per Real.
void Periodic::fill(Populations<double>& populations) { fill_sites(populations); }
void Periodic::fill(Populations<float>& populations) { fill_sites(populations); }
void Periodic::fold(Populations<double>& populations) { fold_sites(populations); }
void Periodic::fold(Populations<float>& populations) { fold_sites(populations); }
void Periodic::fill(VectorField<double>& field) { fill_sites(field); }
void Periodic::fill(VectorField<float>& field) { fill_sites(field); }
void Periodic::fold(VectorField<double>& field) { fold_sites(field); }
void Periodic::fold(VectorField<float>& field) { fold_sites(field); }

}  // namespace tt
