#include "coupling/viscosity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contracts.hpp"
#include "base/isa.hpp"
#include "base/lesser.hpp"
#include "coupling/site_viscosity.hpp"

namespace tt {
namespace {

TT_CLONES void quantise(std::vector<double>& values) {
    for (double& v : values) v = quantised(v);
}

/// Lays the outline given on the lattice as the new patch of a cell. False where it cannot be: the
/// old one stays.
bool lay_cell(const ViscosityModel& model, const Lattice& lattice, const Outline& outline,
              CellPatch& cell) {
    const double limit = 4.0 * std::max(lattice.nx, lattice.ny);
    return std::visit(
        [&](const auto& interface, const auto& interior) {
            if (!lay_patch(outline, interface.reach(), limit, cell.before, cell.local))
                return false;
            interface(interior, cell.local, cell.before);
            quantise(cell.before.value);
            std::swap(cell.now, cell.before);
            return true;
        },
        model.interface, model.interior);
}

/// Has a node moved by more than `distance`? Also true where a position is not finite.
TT_CLONES bool moved(const double* x, const double* y, const double* x0, const double* y0,
                     int count, double distance) {
    const double limit = distance * distance;
    int near = 0;
    for (int k = 0; k < count; ++k) {
        const double dx = x[k] - x0[k];
        const double dy = y[k] - y0[k];
        near += dx * dx + dy * dy <= limit ? 1 : 0;
    }
    return near < count;
}

Outline kept_outline(const Suspension& cells, const InteriorState& interior, int cell) {
    const auto first = static_cast<std::size_t>(cells.first[cell]);
    const auto count = static_cast<std::size_t>(cells.node_count(cell));
    return {{interior.x.data() + first, count}, {interior.y.data() + first, count}};
}

/// Keeps as positions of a cell those it will have half-way to when it must be laid again, so that
/// on average the cytoplasm neither lags nor leads: each node goes on with its velocity until the
/// fastest has gone (nearly) `distance`, for `horizon` steps at most.
void look_ahead(const Suspension& cells, int first, int count, double distance,
                InteriorState& interior) {
    constexpr double nearly = 0.95, horizon = 100.0;
    double fastest = 0.0;
    for (int k = first; k < first + count; ++k)
        fastest = greater(fastest, cells.ux[k] * cells.ux[k] + cells.uy[k] * cells.uy[k]);
    const double steps = lesser(horizon, nearly * distance / std::sqrt(fastest));
    for (int k = first; k < first + count; ++k) {
        interior.x[k] = cells.x[k] + steps * cells.ux[k];
        interior.y[k] = cells.y[k] + steps * cells.uy[k];
    }
}

/// Lays a cell anew if it has moved away from where it was laid.
void refresh_cell(const ViscosityModel& model, const Suspension& cells, InteriorState& interior,
                  int cell) {
    CellPatch& patch = interior.patches[cell];
    const int first = cells.first[cell];
    const int count = cells.node_count(cell);
    patch.refreshed =
        moved(cells.x.data() + first, cells.y.data() + first, interior.x.data() + first,
              interior.y.data() + first, count, model.refresh_distance);
    if (!patch.refreshed) return;
    look_ahead(cells, first, count, model.refresh_distance, interior);
    patch.refreshed =
        lay_cell(model, interior.cytoplasm.lattice(), kept_outline(cells, interior, cell), patch);
}

}  // namespace

CytoplasmWeight cytoplasm_weight(const ViscosityModel& model, int kind) {
    const auto excess = [&](double viscosity) {
        return std::visit([&](const auto& mean) { return mean.excess(model.plasma, viscosity); },
                          model.mean);
    };
    double whole = 0.0;
    CytoplasmWeight result{model.cytoplasm.front()};
    for (const double viscosity : model.cytoplasm) {
        if (!(std::abs(excess(viscosity)) > std::abs(whole))) continue;
        whole = excess(viscosity);
        result.viscosity = viscosity;
    }
    if (whole == 0.0) return result;
    result.weight = excess(model.cytoplasm[kind]) / whole;
    for (const double viscosity : model.cytoplasm)
        result.lowest = std::min(result.lowest, excess(viscosity) / whole);
    return result;
}

Field<> fraction_inside(const InteriorState& interior) {
    const Lattice& lattice = interior.cytoplasm.lattice();
    Field<> fraction(lattice);
    for (const CellPatch& cell : interior.patches)
        for (int r = 0; r < cell.now.height; ++r) {
            const int j = lattice.row_in_box(cell.now.j + r);
            if (j < 0 || j >= lattice.ny) continue;
            for (int c = 0; c < cell.now.width; ++c)
                fraction.row(j)[wrapped(cell.now.i + c, lattice.nx)] += cell.now.row(r)[c];
        }
    return fraction;
}

template <class Real>
void rebuild_viscosity(const ViscosityModel& model, const Suspension& cells,
                       InteriorState& interior, Relaxation<Real>& relaxation) {
    interior.x = cells.x;
    interior.y = cells.y;
    restore_viscosity(model, cells, interior, relaxation);
}

template <class Real>
void restore_viscosity(const ViscosityModel& model, const Suspension& cells,
                       InteriorState& interior, Relaxation<Real>& relaxation) {
    TT_EXPECTS(interior.x.size() == cells.x.size() && interior.y.size() == cells.y.size());
    const Lattice& lattice = relaxation.even.lattice();
    interior.cytoplasm = Field<>(lattice);
    interior.patches.assign(cells.cell_count(), {});
    set_all_rates(model, interior.cytoplasm, relaxation);
    for (int cell = 0; cell < cells.cell_count(); ++cell) {
        CellPatch& patch = interior.patches[cell];
        if (lay_cell(model, lattice, kept_outline(cells, interior, cell), patch))
            change_patch(model, cells.kind[cell], patch.now, patch.before, {0, lattice.ny},
                         interior.cytoplasm, relaxation);
    }
}

void lay_cytoplasm(const ViscosityModel& model, const Suspension& cells, InteriorState& interior) {
    TT_EXPECTS(static_cast<int>(interior.patches.size()) == cells.cell_count());
    const auto [begin, end] = own_cells(cells);
    for (int cell = begin; cell < end; ++cell) refresh_cell(model, cells, interior, cell);
}

template <class Real>
void update_viscosity(const ViscosityModel& model, const Suspension& cells, InteriorState& interior,
                      Relaxation<Real>& relaxation) {
    const auto rows = own_rows(interior.cytoplasm.lattice());
    for (int cell = 0; cell < cells.cell_count(); ++cell)
        if (const CellPatch& patch = interior.patches[cell]; patch.refreshed)
            change_patch(model, cells.kind[cell], patch.now, patch.before, rows, interior.cytoplasm,
                         relaxation);
}

template void rebuild_viscosity(const ViscosityModel&, const Suspension&, InteriorState&,
                                Relaxation<double>&);
template void restore_viscosity(const ViscosityModel&, const Suspension&, InteriorState&,
                                Relaxation<double>&);
template void update_viscosity(const ViscosityModel&, const Suspension&, InteriorState&,
                               Relaxation<double>&);
template void rebuild_viscosity(const ViscosityModel&, const Suspension&, InteriorState&,
                                Relaxation<float>&);
template void restore_viscosity(const ViscosityModel&, const Suspension&, InteriorState&,
                                Relaxation<float>&);
template void update_viscosity(const ViscosityModel&, const Suspension&, InteriorState&,
                               Relaxation<float>&);

}  // namespace tt
