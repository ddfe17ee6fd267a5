#include <algorithm>
#include <cmath>
#include <variant>

#include "base/contracts.hpp"
#include "base/four.hpp"
#include "base/isa.hpp"
#include "base/lesser.hpp"
#include "base/parallel.hpp"
#include "coupling/stencil.hpp"

namespace tt {
namespace {

constexpr int width = Stencils<>::width;

/// One axis of the stencils: positions in, block starts and weights out. Site k stands at k + ½.
template <class Real>
struct Axis {
    const double* position;
    int sites;
    double period;  ///< wraps the block start into the box; 0: no wrap
    std::int32_t* start;
    Real* weights;
    Real* slopes;
};

/// Nodes are weighed a block at a time, side by side, and then laid out node by node: scattered
/// stores would cost more than the arithmetic.
template <class Kernel, class Real>
TT_CLONES void weigh(const Axis<Real>& axis, int begin, int end) {
    constexpr int size = 64;
    double w0[size], w1[size], w2[size], w3[size], s0[size], s1[size], s2[size], s3[size];
    const double period = axis.period;
    const double inverse = period > 0.0 ? 1.0 / period : 0.0;
    for (int at = begin; at < end; at += size) {
        const int count = end - at < size ? end - at : size;
        const double* const __restrict position = axis.position + at;
        std::int32_t* const __restrict start = axis.start + at;
#pragma omp simd
        for (int n = 0; n < count; ++n) {
            const double wrapped = position[n] - period * std::floor(position[n] * inverse);
            // On the far end of the box, y = ny or x rounded up to nx, the last block serves.
            const double first =
                lesser(std::floor(wrapped - 0.5 * (Kernel::points - 1)), axis.sites - 2.0);
            double w[width], slopes[width];
            Kernel::weights(wrapped - 0.5 - first, w, slopes);
            start[n] = static_cast<std::int32_t>(first);
            w0[n] = w[0], w1[n] = w[1], w2[n] = w[2], w3[n] = w[3];
            s0[n] = slopes[0], s1[n] = slopes[1], s2[n] = slopes[2], s3[n] = slopes[3];
        }
        const auto four = [](double a, double b, double c, double d) TT_INLINE_LAMBDA {
            return Four<Real>{Real(a), Real(b), Real(c), Real(d)};
        };
        Real* const __restrict weights = axis.weights + width * at;
        Real* const __restrict slopes = axis.slopes + width * at;
        for (int n = 0; n < count; ++n) {
            store_four(weights + width * n, four(w0[n], w1[n], w2[n], w3[n]));
            store_four(slopes + width * n, four(s0[n], s1[n], s2[n], s3[n]));
        }
    }
}

/// Linear extrapolation from the two rows nearest to a wall, for a node so near that fewer than two
/// carry weight.
void extrapolate(double y, int start, int ny, double* w) {
    const int nearest = y < 0.5 * ny ? 0 : ny - 2;
    for (int k = 0; k < width; ++k) w[k] = 0.0;
    const double along = y - (nearest + 0.5);
    w[nearest - start] = 1.0 - along;
    w[nearest - start + 1] = along;
}

/// Makes the y weights of a node one-sided where its block sticks out of 0 ≤ j < ny: drops those
/// outside and multiplies the rest by a + b r (r = site − node) such that Σ w = 1 and Σ w r = 0.
/// Force and torque are then conserved up to the wall, and a linear velocity is interpolated
/// exactly.
void make_one_sided(double y, int start, int ny, double* w) {
    double m0 = 0.0, m1 = 0.0, m2 = 0.0;
    for (int k = 0; k < width; ++k) {
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
    for (int k = 0; k < width; ++k) w[k] *= (m2 - m1 * (start + k + 0.5 - y)) / determinant;
}

/// Slopes of one-sided weights: w r / Σ w r², exact for a linear field; 0 where only one row has
/// weight.
void slope_one_sided(double y, int start, const double* w, double* slopes) {
    double second_moment = 0.0;
    for (int k = 0; k < width; ++k) {
        const double r = start + k + 0.5 - y;
        second_moment += w[k] * r * r;
    }
    for (int k = 0; k < width; ++k) {
        const double r = start + k + 0.5 - y;
        slopes[k] = std::fabs(second_moment) > 1e-12 ? w[k] * r / second_moment : 0.0;
    }
}

/// Both, for a node whose block sticks out.
template <class Real>
void weigh_one_sided(double y, int start, int ny, Real* weights, Real* slopes) {
    double w[width], s[width];
    std::copy_n(weights, width, w);
    make_one_sided(y, start, ny, w);
    slope_one_sided(y, start, w, s);
    for (int k = 0; k < width; ++k) {
        weights[k] = static_cast<Real>(w[k]);
        slopes[k] = static_cast<Real>(s[k]);
    }
}

}  // namespace

template <class Real>
void locate(const Delta& delta, const Lattice& lattice, const Suspension& cells,
            Stencils<Real>& stencils) {
    TT_EXPECTS(static_cast<int>(stencils.i.size()) == cells.node_count());
    const auto [begin, end] = own_nodes(cells);
    const int points = std::visit([](const auto& kernel) { return kernel.points; }, delta);
    if (team_rank() == 0) stencils.points = points;
    const double y_period = lattice.walls ? 0.0 : lattice.ny;
    const Axis<Real> along_x{cells.x.data(),    lattice.nx,         double(lattice.nx),
                             stencils.i.data(), stencils.wx.data(), stencils.sx.data()};
    const Axis<Real> along_y{cells.y.data(),    lattice.ny,         y_period,
                             stencils.j.data(), stencils.wy.data(), stencils.sy.data()};
    std::visit(
        [&, begin = begin, end = end]<class Kernel>(Kernel) {
            weigh<Kernel>(along_x, begin, end);
            weigh<Kernel>(along_y, begin, end);
        },
        delta);
    if (!lattice.walls) return;
    for (int n = begin; n < end; ++n) {
        const int j = stencils.j[n];
        if (j >= 0 && j + points <= lattice.ny) continue;
        weigh_one_sided(cells.y[n], j, lattice.ny, &stencils.wy[width * n],
                        &stencils.sy[width * n]);
    }
}

template void locate(const Delta&, const Lattice&, const Suspension&, Stencils<double>&);
template void locate(const Delta&, const Lattice&, const Suspension&, Stencils<float>&);

}  // namespace tt
