#include "coupling/site_viscosity.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "base/isa.hpp"
#include "base/lesser.hpp"

namespace tt {
namespace {

/// Viscosity without cells in row j. The row that the edge of the layer cuts has the harmonic mean
/// of both, exact for shear along the layer.
double plain_viscosity(const ViscosityModel& model, int j) {
    const double share = std::clamp(model.layer_thickness - j, 0.0, 1.0);
    return HarmonicMean{}(model.plasma, model.layer_viscosity, share);
}

/// One row of what depends on the cytoplasm.
template <class Real>
struct CytoplasmRow {
    int nx;
    double plain;  ///< viscosity without cells
    CytoplasmWeight cell;
    double* __restrict cytoplasm;
    Real* __restrict even;
    Real* __restrict odd;
};

/// Sets what follows from the cytoplasm of the sites [begin, end) of a row.
template <class Mean, class Rule, class Real>
TT_INLINE void set_rates(const Mean& mean, const Rule& collision, const CytoplasmRow<Real>& row,
                         int begin, int end) {
    const CytoplasmRow<Real> to = row;
    for (int i = begin; i < end; ++i) {
        const double f = lesser(1.0, greater(to.cell.lowest, to.cytoplasm[i]));
        const Rates rates = collision.rates(mean(to.plain, to.cell.viscosity, f));
        to.even[i] = static_cast<Real>(rates.even);
        to.odd[i] = static_cast<Real>(rates.odd);
    }
}

/// Do `count` numbers differ in any bit?
TT_INLINE bool differ(const double* a, const double* b, int count) {
    std::uint64_t bits = 0;
    for (int k = 0; k < count; ++k)
        bits |= std::bit_cast<std::uint64_t>(a[k]) ^ std::bit_cast<std::uint64_t>(b[k]);
    return bits != 0;
}

/// Adds w (now − before) to the cytoplasm of `count` sites of a row from `column` on, and sets what
/// follows where that changes it. Most of a row is far from the membrane and unchanged, so it is
/// taken in blocks.
template <class Mean, class Rule, class Real>
TT_CLONES void change_run(const Mean& mean, const Rule& collision, const CytoplasmRow<Real>& row,
                          int column, const double* __restrict now, const double* __restrict before,
                          int count) {
    constexpr int block = Patch::lanes;
    const auto changed = [&](int k) {
        return k + block <= count ? differ(now + k, before + k, block)
                                  : differ(now + k, before + k, count - k);
    };
    double* const __restrict cytoplasm = row.cytoplasm + column;
    const double weight = row.cell.weight;
    for (int k = 0; k < count; k += block) {
        if (!changed(k)) continue;
        const int first = k;
        do k += block;
        while (k < count && changed(k));
        const int last = std::min(k, count);
        for (int n = first; n < last; ++n)
            cytoplasm[n] += quantised(weight * now[n]) - quantised(weight * before[n]);
        set_rates(mean, collision, row, column + first, column + last);
    }
}

/// Where changed patches go: the fields, and the model's choices resolved.
template <class Mean, class Rule, class Real>
struct Target {
    const ViscosityModel& model;
    const Mean& mean;
    const Rule& collision;
    CytoplasmWeight cell;
    Field<>& cytoplasm;
    Relaxation<Real>& relaxation;

    /// Row `j` of the box, columns `column` … unwrapped.
    void change_row(int j, int column, int count, const double* now, const double* before) const {
        const CytoplasmRow<Real> to = row(j);
        for (int done = 0; done < count;) {
            const int i = wrapped(column + done, to.nx);
            const int run = std::min(count - done, to.nx - i);
            change_run(mean, collision, to, i, now + done, before + done, run);
            done += run;
        }
    }

    CytoplasmRow<Real> row(int j) const {
        return {cytoplasm.lattice().nx, plain_viscosity(model, j), cell,
                cytoplasm.row(j),       relaxation.even.row(j),    relaxation.odd.row(j)};
    }
};

/// The `count` values of row `j` (unwrapped) of a patch from `column` on, 0 outside the patch.
void copy_columns(const Patch& patch, int j, int column, int count, double* to) {
    std::fill_n(to, count, 0.0);
    const int r = j - patch.j;
    if (r < 0 || r >= patch.height) return;
    const int begin = std::max(column, patch.i);
    const int end = std::min(column + count, patch.i + patch.width);
    if (begin < end)
        std::copy_n(patch.row(r) + (begin - patch.i), end - begin, to + (begin - column));
}

/// Changes one unwrapped row from `before` to `now` where the two patches differ in place.
template <class T>
void change_moved_row(const T& target, const Patch& now, const Patch& before, int row, int j) {
    constexpr int chunk = 64;
    double value_now[chunk];
    double value_before[chunk];
    const int begin = before.height == 0 ? now.i : std::min(now.i, before.i);
    const int end =
        std::max(now.i + now.width, before.height == 0 ? now.i : before.i + before.width);
    for (int column = begin; column < end; column += chunk) {
        const int count = std::min(chunk, end - column);
        copy_columns(now, row, column, count, value_now);
        copy_columns(before, row, column, count, value_before);
        target.change_row(j, column, count, value_now, value_before);
    }
}

template <class T>
void change_rows(const T& target, const Patch& now, const Patch& before, std::pair<int, int> rows) {
    const Lattice& lattice = target.cytoplasm.lattice();
    const bool still = now.same_place(before);
    const int begin = before.height == 0 ? now.j : std::min(now.j, before.j);
    const int end =
        std::max(now.j + now.height, before.height == 0 ? now.j : before.j + before.height);
    for (int row = begin; row < end; ++row) {
        const int j = lattice.row_in_box(row);
        if (j < rows.first || j >= rows.second) continue;
        if (still)
            target.change_row(j, now.i, now.width, now.row(row - now.j), before.row(row - now.j));
        else
            change_moved_row(target, now, before, row, j);
    }
}

/// Calls `f(target)` with the model's mean and collision operator resolved, for cells of a kind.
template <class Real, class F>
void with_target(const ViscosityModel& model, int kind, Field<>& cytoplasm,
                 Relaxation<Real>& relaxation, F&& f) {
    const CytoplasmWeight weight = cytoplasm_weight(model, kind);
    std::visit(
        [&]<class Mean, class Rule>(const Mean& mean, const Rule& rule) {
            f(Target<Mean, Rule, Real>{model, mean, rule, weight, cytoplasm, relaxation});
        },
        model.mean, model.collision);
}

}  // namespace

template <class Real>
void set_all_rates(const ViscosityModel& model, Field<>& cytoplasm, Relaxation<Real>& relaxation) {
    const Lattice& lattice = cytoplasm.lattice();
    with_target(model, 0, cytoplasm, relaxation, [&](const auto& target) {
        for (int j = 0; j < lattice.ny; ++j)
            set_rates(target.mean, target.collision, target.row(j), 0, lattice.nx);
    });
}

template <class Real>
void change_patch(const ViscosityModel& model, int kind, const Patch& now, const Patch& before,
                  std::pair<int, int> rows, Field<>& cytoplasm, Relaxation<Real>& relaxation) {
    with_target(model, kind, cytoplasm, relaxation,
                [&](const auto& target) { change_rows(target, now, before, rows); });
}

template void set_all_rates(const ViscosityModel&, Field<>&, Relaxation<double>&);
template void change_patch(const ViscosityModel&, int, const Patch&, const Patch&,
                           std::pair<int, int>, Field<>&, Relaxation<double>&);
template void set_all_rates(const ViscosityModel&, Field<>&, Relaxation<float>&);
template void change_patch(const ViscosityModel&, int, const Patch&, const Patch&,
                           std::pair<int, int>, Field<>&, Relaxation<float>&);

}  // namespace tt
