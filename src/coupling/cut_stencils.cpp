#include "coupling/cut_stencils.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace tt {
namespace {

/// One node's sites in double, before they are kept.
struct Block {
    int count = 0;
    std::array<double, 16> weight{}, x{}, y{};  ///< x, y: from the node

    double sum(auto&& term) const {
        double total = 0.0;
        for (int k = 0; k < count; ++k) total += weight[k] * term(k);
        return total;
    }
};

/// Solves the symmetric 2 × 2 system; false if it is singular against `scale`.
bool solve(double xx, double xy, double yy, double bx, double by, double scale, double& x,
           double& y) {
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-3 * scale * scale)) return false;
    x = (bx * yy - by * xy) / determinant;
    y = (by * xx - bx * xy) / determinant;
    return true;
}

/// Σ w = 1 and, if the sites span the plane, Σ w r = 0.
void make_one_sided(Block& b) {
    const double all = b.sum([](int) { return 1.0; });
    if (!(all > 1e-6)) {
        b.weight.fill(0.0);
        return;
    }
    for (double& w : b.weight) w /= all;
    const double mx = b.sum([&](int k) { return b.x[k]; });
    const double my = b.sum([&](int k) { return b.y[k]; });
    // With the moments about the mean of the sites the factor is 1 − m·C⁻¹ (r − m).
    const auto about = [&](const auto& p, double mp, const auto& q, double mq) {
        return b.sum([&](int k) { return (p[k] - mp) * (q[k] - mq); });
    };
    double sx = 0.0, sy = 0.0;
    if (!solve(about(b.x, mx, b.x, mx), about(b.x, mx, b.y, my), about(b.y, my, b.y, my), mx, my,
               0.1, sx, sy))
        return;
    for (int k = 0; k < b.count; ++k) b.weight[k] *= 1.0 - sx * (b.x[k] - mx) - sy * (b.y[k] - my);
}

template <class Real>
void set_slopes(const Block& b, CutStencil<Real>& cut) {
    const double xx = b.sum([&](int k) { return b.x[k] * b.x[k]; });
    const double xy = b.sum([&](int k) { return b.x[k] * b.y[k]; });
    const double yy = b.sum([&](int k) { return b.y[k] * b.y[k]; });
    const double determinant = xx * yy - xy * xy;
    const bool spans = std::fabs(determinant) > 1e-6;
    for (int k = 0; k < b.count; ++k) {
        const double x = spans ? (b.x[k] * yy - b.y[k] * xy) / determinant : 0.0;
        const double y = spans ? (b.y[k] * xx - b.x[k] * xy) / determinant : 0.0;
        cut.slope_x[k] = static_cast<Real>(b.weight[k] * x);
        cut.slope_y[k] = static_cast<Real>(b.weight[k] * y);
    }
}

template <class Real>
bool is_cut(const Walls& walls, const Stencils<Real>& stencils, int node) {
    for (int l = 0; l < stencils.points; ++l)
        for (int k = 0; k < stencils.points; ++k)
            if (!walls.open(stencils.i[node] + k, stencils.j[node] + l) &&
                stencils.wy[stencils.width * node + l] != 0)
                return true;
    return false;
}

template <class Real>
CutStencil<Real> cut_stencil(const Walls& walls, const Stencils<Real>& stencils, Vec2 place,
                             int node) {
    const int i = stencils.i[node], j = stencils.j[node], points = stencils.points;
    // The node as it lies in its block, whichever image it is.
    const double nx = walls.lattice.nx, ny = walls.lattice.ny;
    double x = place.x - i, y = place.y - j;
    x -= nx * std::floor((x + 1.0) / nx);
    if (!walls.lattice.walls) y -= ny * std::floor((y + 1.0) / ny);
    Block block;
    block.count = points * points;
    for (int n = 0; n < block.count; ++n) {
        const int k = n % points, l = n / points;
        block.x[n] = k + 0.5 - x;
        block.y[n] = l + 0.5 - y;
        if (walls.open(i + k, j + l))
            block.weight[n] = double{stencils.wx[stencils.width * node + k]} *
                              double{stencils.wy[stencils.width * node + l]};
    }
    CutStencil<Real> cut{node, i, j, {}, {}, {}, 1.0, {}};
    cut.whole = std::clamp(2.0 * block.sum([](int) { return 1.0; }) - 1.0, 0.0, 1.0);
    make_one_sided(block);
    for (int n = 0; n < block.count; ++n) cut.weight[n] = static_cast<Real>(block.weight[n]);
    set_slopes(block, cut);
    return cut;
}

}  // namespace

template <class Real>
void cut_at_walls(const Walls& walls, const Suspension& cells, Stencils<Real>& stencils,
                  CutStencils<Real>& cut) {
    if (team_rank() == 0) cut.points = stencils.points;
    const auto [begin, end] = own_cells(cells);
    for (int cell = begin; cell < end; ++cell) {
        auto& list = cut.of_cell[cell];
        list.clear();
        for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
            if (!is_cut(walls, stencils, n)) continue;
            list.push_back(cut_stencil(walls, stencils, cells.position(n), n));
            std::fill_n(&stencils.wx[stencils.width * n], stencils.width, Real{0});
            std::fill_n(&stencils.sx[stencils.width * n], stencils.width, Real{0});
        }
    }
}

template <class Real>
void spread_cut(Order order, const CutStencils<Real>& cut, const Suspension& cells,
                VectorField<Real>& force) {
    const auto [begin, end] = own_rows_with_halo(force.x.lattice());
    for (const auto& list : cut.of_cell) {
        for (const CutStencil<Real>& c : list) {
            const int n = c.node;
            const Real fx = Real(cells.fx[n]), fy = Real(cells.fy[n]);
            const bool first = order == Order::first;
            const Real xx = first ? Real(cells.dipole_xx[n]) : Real{0};
            const Real xy = first ? Real(cells.dipole_xy[n]) : Real{0};
            for (int l = 0; l < cut.points; ++l) {
                if (c.j + l < begin || c.j + l >= end) continue;
                Real* const x = force.x.row(c.j + l) + c.i;
                Real* const y = force.y.row(c.j + l) + c.i;
                for (int k = 0; k < cut.points; ++k) {
                    const int s = l * cut.points + k;
                    x[k] += c.weight[s] * fx + c.slope_x[s] * xx + c.slope_y[s] * xy;
                    y[k] += c.weight[s] * fy + c.slope_x[s] * xy - c.slope_y[s] * xx;
                }
            }
        }
    }
}

template <class Real>
void interpolate_cut(Order order, CutStencils<Real>& cut, const VectorField<Real>& velocity,
                     Suspension& cells, int cell) {
    for (CutStencil<Real>& c : cut.of_cell[cell]) {
        double ux = 0.0, uy = 0.0, xx = 0.0, xy = 0.0;
        for (int l = 0; l < cut.points; ++l) {
            const Real* const x = velocity.x.row(c.j + l) + c.i;
            const Real* const y = velocity.y.row(c.j + l) + c.i;
            for (int k = 0; k < cut.points; ++k) {
                const int s = l * cut.points + k;
                const double vx = x[k], vy = y[k];
                ux += c.weight[s] * vx;
                uy += c.weight[s] * vy;
                xx += c.slope_x[s] * vx - c.slope_y[s] * vy;
                xy += c.slope_x[s] * vy + c.slope_y[s] * vx;
            }
        }
        c.sampled = {ux, uy};
        cells.ux[c.node] = ux;
        cells.uy[c.node] = uy;
        if (order == Order::zeroth) continue;
        cells.rate_xx[c.node] = xx;
        cells.rate_xy[c.node] = xy;
    }
}

template <class Real>
void weaken_dipoles(const CutStencils<Real>& cut, Suspension& cells) {
    const auto [begin, end] = own_cells(cells);
    for (int cell = begin; cell < end; ++cell)
        for (const CutStencil<Real>& c : cut.of_cell[cell]) {
            cells.dipole_xx[c.node] *= c.whole;
            cells.dipole_xy[c.node] *= c.whole;
        }
}

template <class Real>
void weaken_corrections(const CutStencils<Real>& cut, Suspension& cells, int cell) {
    for (const CutStencil<Real>& c : cut.of_cell[cell]) {
        cells.ux[c.node] = c.sampled.x + c.whole * (cells.ux[c.node] - c.sampled.x);
        cells.uy[c.node] = c.sampled.y + c.whole * (cells.uy[c.node] - c.sampled.y);
    }
}

template void cut_at_walls(const Walls&, const Suspension&, Stencils<double>&,
                           CutStencils<double>&);
template void cut_at_walls(const Walls&, const Suspension&, Stencils<float>&, CutStencils<float>&);
template void spread_cut(Order, const CutStencils<double>&, const Suspension&,
                         VectorField<double>&);
template void spread_cut(Order, const CutStencils<float>&, const Suspension&, VectorField<float>&);
template void interpolate_cut(Order, CutStencils<double>&, const VectorField<double>&, Suspension&,
                              int);
template void interpolate_cut(Order, CutStencils<float>&, const VectorField<float>&, Suspension&,
                              int);

template void weaken_dipoles(const CutStencils<double>&, Suspension&);
template void weaken_dipoles(const CutStencils<float>&, Suspension&);
template void weaken_corrections(const CutStencils<double>&, Suspension&, int);
template void weaken_corrections(const CutStencils<float>&, Suspension&, int);

}  // namespace tt
