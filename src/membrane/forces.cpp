#include "membrane/forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "base/exp.hpp"
#include "base/isa.hpp"
#include "base/lesser.hpp"

// Each cell in turn is laid out in a few arrays, small enough for the nearest cache, with its last
// node once more before the first and its first once more behind the last, as a lattice has its
// halo: every pass is then one plain loop, which becomes vector code.

namespace tt {
namespace {

constexpr int lanes = 8;  ///< loops run over a multiple of it, so that they leave no remainder

/// One cell laid out: [k] for −1 ≤ k ≤ count. Per segment, at its first node, but for x, y,
/// curvature and moment, which are per node.
struct Ring {
    int count;
    double *x, *y;
    double *rest_length, *rest_curvature;
    double *edge_x, *edge_y;  ///< from the node to its successor
    double *length, *stretch, *alpha, *alpha_slope, *tension, *stiffness, *moment;
    double *load_x, *load_y;  ///< stress resultant

    int padded() const { return (count + lanes - 1) / lanes * lanes; }
    void close(double* numbers) const {
        numbers[-1] = numbers[count - 1];
        numbers[count] = numbers[0];
    }
};

/// Lays a cell out in `room`, which grows if it must.
Ring lay_out(const Suspension& cells, int cell, std::vector<double>& room) {
    constexpr int arrays = 15;
    const int first = cells.first[cell], count = cells.node_count(cell);
    const int pitch = (count / lanes + 1) * lanes + lanes;  // a halo on either side
    const auto size = static_cast<std::size_t>(arrays * pitch);
    if (room.size() < size) room.resize(size, 1.0);
    double* rest = room.data() + lanes;
    const auto next = [&] { return std::exchange(rest, rest + pitch); };
    const Ring ring{count,  next(), next(), next(), next(), next(), next(), next(),
                    next(), next(), next(), next(), next(), next(), next(), next()};
    std::copy_n(&cells.x[first], count, ring.x);
    std::copy_n(&cells.y[first], count, ring.y);
    std::copy_n(&cells.rest_length[first], count, ring.rest_length);
    std::copy_n(&cells.rest_curvature[first], count, ring.rest_curvature);
    for (double* array : {ring.x, ring.y, ring.rest_length}) ring.close(array);
    return ring;
}

/// Segment vectors, lengths and stretches.
TT_CLONES void measure(const Ring& ring) {
    const Ring m = ring;
    const int end = m.padded();
#pragma omp simd
    for (int k = 0; k < end; ++k) {
        const double dx = m.x[k + 1] - m.x[k];
        const double dy = m.y[k + 1] - m.y[k];
        m.edge_x[k] = dx;
        m.edge_y[k] = dy;
        m.length[k] = std::sqrt(dx * dx + dy * dy);
        m.stretch[k] = m.length[k] / m.rest_length[k];
    }
}

/// α and its slope.
TT_CLONES void harden_exponentially(const Ring& ring, double D, double beta, double fold,
                                    double floor) {
    const Ring m = ring;
    const int end = m.padded();
#pragma omp simd
    for (int k = 0; k < end; ++k) {
        const double extension = m.stretch[k] - 1.0;
        const double folded = fold * extension;
        const double compressed = folded > floor ? folded : floor;
        const double e = vector_exp(beta * (extension < 0.0 ? compressed : extension));
        const double inner = folded > floor ? fold : 0.0;
        m.alpha[k] = 1.0 + D * (e - 1.0);
        m.alpha_slope[k] = (extension < 0.0 ? inner : 1.0) * (D * beta * e);
    }
}

/// α(λ) of all segments (Eq. 12), and dα/dλ.
void harden(const Hardening& hardening, const Ring& m) {
    using Compression = Hardening::Compression;
    if (hardening.form == Hardening::Form::exponential) {
        const double fold = hardening.compression == Compression::symmetric ? -1.0 : 1.0;
        const double floor = hardening.compression == Compression::as_printed ? -1.0 : 0.0;
        harden_exponentially(m, hardening.D, hardening.beta, fold, floor);
    } else {
        for (int k = 0; k < m.count; ++k) {
            m.alpha[k] = hardening(m.stretch[k]);
            m.alpha_slope[k] = hardening.slope(m.stretch[k]);
        }
    }
}

/// T(λ) α (Eqs. 10, 12) of all segments, and by how much it grows with their length.
template <class Law>
TT_CLONES void pull(const Law& law, bool hardened, const Ring& ring) {
    const Ring m = ring;
    const int end = m.padded();
#pragma omp simd
    for (int k = 0; k < end; ++k) {
        const double plain = law.tension(m.stretch[k]), slope = law.slope(m.stretch[k]);
        const double hard = slope * m.alpha[k] + plain * m.alpha_slope[k];
        m.tension[k] = hardened ? plain * m.alpha[k] : plain;
        m.stiffness[k] = greater(0.0, hardened ? hard : slope) / m.rest_length[k];
    }
}

/// m = E_b (κ − κ₀) α (Eq. 13) at each node, between two segments; turning angle by 2 tan(θ/2).
template <class Law>
TT_CLONES void bend(const Law& law, bool hardened, const Ring& ring) {
    const Ring m = ring;
    const int end = m.padded();
#pragma omp simd
    for (int k = 0; k < end; ++k) {
        const int before = k - 1;
        const double crossing = m.edge_x[before] * m.edge_y[k] - m.edge_y[before] * m.edge_x[k];
        const double along = m.edge_x[before] * m.edge_x[k] + m.edge_y[before] * m.edge_y[k];
        const double turning = 2.0 * crossing / (m.length[before] * m.length[k] + along);
        const double alpha = hardened ? 0.5 * (m.alpha[before] + m.alpha[k]) : 1.0;
        const double moment =
            law.moment(turning, 0.5 * (m.length[before] + m.length[k]),
                       0.5 * (m.rest_length[before] + m.rest_length[k]), m.rest_curvature[k]);
        m.moment[k] = alpha * moment;
    }
}

/// Stress resultants T t + q n of all segments, with the transverse shear q = (m_next − m_k)/l.
TT_CLONES void load_segments(const Ring& ring) {
    const Ring m = ring;
    const int end = m.padded();
#pragma omp simd
    for (int k = 0; k < end; ++k) {
        const double inverse = 1.0 / m.length[k];
        const double tx = m.edge_x[k] * inverse;
        const double ty = m.edge_y[k] * inverse;
        const double shear = (m.moment[k + 1] - m.moment[k]) * inverse;
        m.load_x[k] = m.tension[k] * tx + shear * ty;
        m.load_y[k] = m.tension[k] * ty - shear * tx;
    }
}

/// Node forces: d/ds (T t + q n) ds plus the area pressure p along the outward normal (Eqs. 13,
/// 14); exact gradient of the polygon's energies.
TT_CLONES void load_nodes(const Ring& ring, double pressure, double* fx, double* fy) {
    const Ring m = ring;
#pragma omp simd
    for (int k = 0; k < m.count; ++k) {
        fx[k] = m.load_x[k] - m.load_x[k - 1] + 0.5 * pressure * (m.y[k + 1] - m.y[k - 1]);
        fy[k] = m.load_y[k] - m.load_y[k - 1] - 0.5 * pressure * (m.x[k + 1] - m.x[k - 1]);
    }
}

/// Area (Eq. 15 as corrected, relative to the first node, so that it does not lose digits far
/// downstream) and perimeter. Four partial sums in a fixed pattern: short chains, the same bits
/// everywhere.
void measure_cell(const Ring& m, double& area, double& whole_perimeter) {
    double doubled_area[4] = {}, perimeter[4] = {};
    for (int k = 0; k < m.count; ++k) {
        doubled_area[k % 4] += (m.x[k] - m.x[0]) * m.edge_y[k] - (m.y[k] - m.y[0]) * m.edge_x[k];
        perimeter[k % 4] += m.length[k];
    }
    area = 0.5 * ((doubled_area[0] + doubled_area[1]) + (doubled_area[2] + doubled_area[3]));
    whole_perimeter = (perimeter[0] + perimeter[1]) + (perimeter[2] + perimeter[3]);
}

/// p_int = k_p (1 − A/A_ref) α(λ_C) (Eq. 14), and α(λ_C) kept for the contact forces.
double area_pressure(const Membrane& membrane, Suspension& cells, int cell) {
    cells.alpha[cell] = membrane.hardening(cells.perimeter[cell] / cells.reference_perimeter[cell]);
    const double scale = membrane.hardening.area ? cells.alpha[cell] : 1.0;
    return membrane.area_stiffness * (1.0 - cells.area[cell] / cells.reference_area[cell]) * scale;
}

}  // namespace

void set_membrane_forces(const Membrane& membrane, Suspension& cells, int cell) {
    thread_local std::vector<double> room;
    const Hardening& hardening = membrane.hardening;
    const Ring ring = lay_out(cells, cell, room);
    measure(ring);
    for (double* array : {ring.edge_x, ring.edge_y, ring.length}) ring.close(array);
    measure_cell(ring, cells.area[cell], cells.perimeter[cell]);
    if (hardening.shear || hardening.bending) harden(hardening, ring);
    ring.close(ring.alpha);
    std::visit([&](const auto& law) { pull(law, hardening.shear, ring); }, membrane.in_plane);
    std::visit([&](const auto& law) { bend(law, hardening.bending, ring); }, membrane.bending);
    ring.close(ring.moment);
    load_segments(ring);
    for (double* array : {ring.load_x, ring.load_y}) ring.close(array);
    const int first = cells.first[cell];
    std::copy_n(ring.stiffness, ring.count, &cells.stiffness[first]);
    load_nodes(ring, area_pressure(membrane, cells, cell), &cells.fx[first], &cells.fy[first]);
}

}  // namespace tt
