#include "membrane/forces.hpp"

#include <cmath>
#include <variant>

#include "base/exp.hpp"
#include "base/isa.hpp"
#include "base/parallel.hpp"

// Each pass runs over the nodes of all cells of a thread in one straight loop that becomes vector
// code, and then once more for the one segment or node of each cell whose neighbour lies at the
// other end of the cell's memory.

namespace tt {
namespace {

/// Bare pointers into a Suspension: what vector loops need to see.
struct Nodes {
    const double *x, *y;
    const double *rest_length, *rest_curvature;
    double *edge_x, *edge_y, *length, *stretch;
    double *alpha, *tension, *moment;
    double *fx, *fy;
};

Nodes nodes_of(Suspension& s) {
    return {s.x.data(),         s.y.data(),       s.rest_length.data(), s.rest_curvature.data(),
            s.edge_x.data(),    s.edge_y.data(),  s.length.data(),      s.stretch.data(),
            s.hardening.data(), s.tension.data(), s.moment.data(),      s.fx.data(),
            s.fy.data()};
}

/// Segment vector, length and stretch of the segment from node k to node `next`.
TT_INLINE void measure_segment(const Nodes& m, int k, int next) {
    const double dx = m.x[next] - m.x[k];
    const double dy = m.y[next] - m.y[k];
    m.edge_x[k] = dx;
    m.edge_y[k] = dy;
    m.length[k] = std::sqrt(dx * dx + dy * dy);
    m.stretch[k] = m.length[k] / m.rest_length[k];
}

/// m = E_b (κ − κ₀) α (Eq. 13) at node k, between segments `before` and k; turning angle by 2
/// tan(θ/2).
template <class Law>
TT_INLINE void bend_node(const Law& law, bool hardened, const Nodes& m, int before, int k) {
    const double crossing = m.edge_x[before] * m.edge_y[k] - m.edge_y[before] * m.edge_x[k];
    const double along = m.edge_x[before] * m.edge_x[k] + m.edge_y[before] * m.edge_y[k];
    const double turning = 2.0 * crossing / (m.length[before] * m.length[k] + along);
    const double alpha = hardened ? 0.5 * (m.alpha[before] + m.alpha[k]) : 1.0;
    m.moment[k] =
        alpha * law.moment(turning, 0.5 * (m.length[before] + m.length[k]),
                           0.5 * (m.rest_length[before] + m.rest_length[k]), m.rest_curvature[k]);
}

/// Turns segment k's edge into its stress resultant T t + q n, with the transverse shear q =
/// (m_next − m_k)/l.
TT_INLINE void load_segment(const Nodes& m, int k, int next) {
    const double inverse = 1.0 / m.length[k];
    const double tx = m.edge_x[k] * inverse;
    const double ty = m.edge_y[k] * inverse;
    const double shear = (m.moment[next] - m.moment[k]) * inverse;
    m.edge_x[k] = m.tension[k] * tx + shear * ty;
    m.edge_y[k] = m.tension[k] * ty - shear * tx;
}

/// Node force: d/ds (T t + q n) ds plus the area pressure p along the outward normal (Eqs. 13, 14);
/// exact gradient of the polygon's energies.
TT_INLINE void load_node(const Nodes& m, double pressure, int before, int k, int next) {
    m.fx[k] = m.edge_x[k] - m.edge_x[before] + 0.5 * pressure * (m.y[next] - m.y[before]);
    m.fy[k] = m.edge_y[k] - m.edge_y[before] - 0.5 * pressure * (m.x[next] - m.x[before]);
}

TT_CLONES void measure_segments(const Nodes& m, int begin, int end) {
    const Nodes p = m;
#pragma omp simd
    for (int k = begin; k < end; ++k) measure_segment(p, k, k + 1);
}

TT_CLONES void harden_exponentially(const Nodes& m, double D, double beta, double fold,
                                    double floor, int begin, int end) {
    const Nodes p = m;
#pragma omp simd
    for (int k = begin; k < end; ++k) {
        const double extension = p.stretch[k] - 1.0;
        const double folded = fold * extension;
        const double compressed = folded > floor ? folded : floor;
        p.alpha[k] =
            1.0 + D * (vector_exp(beta * (extension < 0.0 ? compressed : extension)) - 1.0);
    }
}

template <class Law>
TT_INLINE void pull(const Nodes& m, const Law& law, bool hardened, int begin, int end) {
    const Nodes p = m;
#pragma omp simd
    for (int k = begin; k < end; ++k)
        p.tension[k] = law.tension(p.stretch[k]) * (hardened ? p.alpha[k] : 1.0);
}

template <class Law>
TT_INLINE void bend(const Nodes& m, const Law& law, bool hardened, int begin, int end) {
    const Nodes p = m;
#pragma omp simd
    for (int k = begin; k < end; ++k) bend_node(law, hardened, p, k - 1, k);
}

// A function that the loader picks by processor cannot be a template: one line per law.
TT_CLONES void pull_all(const Nodes& m, const NeoHookean& law, bool h, int b, int e) {
    pull(m, law, h, b, e);
}
TT_CLONES void pull_all(const Nodes& m, const Hookean& law, bool h, int b, int e) {
    pull(m, law, h, b, e);
}
TT_CLONES void pull_all(const Nodes& m, const Skalak& law, bool h, int b, int e) {
    pull(m, law, h, b, e);
}
TT_CLONES void pull_all(const Nodes& m, const SurfaceTension& law, bool h, int b, int e) {
    pull(m, law, h, b, e);
}
TT_CLONES void bend_all(const Nodes& m, const CurrentCurvature& law, bool h, int b, int e) {
    bend(m, law, h, b, e);
}
TT_CLONES void bend_all(const Nodes& m, const ReferenceCurvature& law, bool h, int b, int e) {
    bend(m, law, h, b, e);
}

TT_CLONES void load_segments(const Nodes& m, int begin, int end) {
    const Nodes p = m;
#pragma omp simd
    for (int k = begin; k < end; ++k) load_segment(p, k, k + 1);
}

TT_CLONES void load_nodes(const Nodes& m, double pressure, int begin, int end) {
    const Nodes p = m;
#pragma omp simd
    for (int k = begin; k < end; ++k) load_node(p, pressure, k - 1, k, k + 1);
}

/// α(λ) of the segments [begin, end) (Eq. 12).
void harden(const Hardening& hardening, const Nodes& m, int begin, int end) {
    using Compression = Hardening::Compression;
    if (hardening.form == Hardening::Form::exponential) {
        const double fold = hardening.compression == Compression::symmetric ? -1.0 : 1.0;
        const double floor = hardening.compression == Compression::as_printed ? -1.0 : 0.0;
        harden_exponentially(m, hardening.D, hardening.beta, fold, floor, begin, end);
    } else {
        for (int k = begin; k < end; ++k) m.alpha[k] = hardening(m.stretch[k]);
    }
}

/// Area (Eq. 15 as corrected, relative to the first node, so that it does not lose digits far
/// downstream) and perimeter. Four partial sums in a fixed pattern: short chains, the same bits
/// everywhere.
void measure_cell(Suspension& cells, int cell) {
    const int first = cells.first[cell], count = cells.node_count(cell);
    const double* const x = &cells.x[first];
    const double* const y = &cells.y[first];
    double doubled_area[4] = {}, perimeter[4] = {};
    for (int k = 0; k < count; ++k) {
        doubled_area[k % 4] +=
            (x[k] - x[0]) * cells.edge_y[first + k] - (y[k] - y[0]) * cells.edge_x[first + k];
        perimeter[k % 4] += cells.length[first + k];
    }
    cells.area[cell] =
        0.5 * ((doubled_area[0] + doubled_area[1]) + (doubled_area[2] + doubled_area[3]));
    cells.perimeter[cell] = (perimeter[0] + perimeter[1]) + (perimeter[2] + perimeter[3]);
}

/// p_int = k_p (1 − A/A_ref) α(λ_C) (Eq. 14), and α(λ_C) kept for the contact forces.
double area_pressure(const Membrane& membrane, Suspension& cells, int cell) {
    cells.alpha[cell] = membrane.hardening(cells.perimeter[cell] / cells.reference_perimeter[cell]);
    const double scale = membrane.hardening.area ? cells.alpha[cell] : 1.0;
    return membrane.area_stiffness * (1.0 - cells.area[cell] / cells.reference_area[cell]) * scale;
}

}  // namespace

void set_membrane_forces(const Membrane& membrane, Suspension& cells) {
    const auto [first_cell, last_cell] = team_share(cells.cell_count());
    const int begin = cells.first[first_cell], end = cells.first[last_cell];
    const Nodes m = nodes_of(cells);
    const Hardening& hardening = membrane.hardening;
    if (begin < end) {
        // The straight loops run across the borders of cells; the closing segment or node is then
        // set right.
        const auto close = [&, first = first_cell, last = last_cell](auto&& set) {
            for (int c = first; c < last; ++c) set(cells.first[c], cells.first[c + 1] - 1);
        };
        measure_segments(m, begin, end - 1);
        close([&](int head, int tail) { measure_segment(m, tail, head); });
        if (hardening.shear || hardening.bending) harden(hardening, m, begin, end);
        std::visit([&](const auto& law) { pull_all(m, law, hardening.shear, begin, end); },
                   membrane.in_plane);
        std::visit(
            [&](const auto& law) {
                bend_all(m, law, hardening.bending, begin + 1, end);
                close(
                    [&](int head, int tail) { bend_node(law, hardening.bending, m, tail, head); });
            },
            membrane.bending);
        for (int c = first_cell; c < last_cell; ++c) measure_cell(cells, c);
        load_segments(m, begin, end - 1);
        close([&](int head, int tail) {
            // The straight loop has used the next cell's first node: measure the closing segment
            // again.
            measure_segment(m, tail, head);
            load_segment(m, tail, head);
        });
        for (int c = first_cell; c < last_cell; ++c) {
            const int head = cells.first[c], tail = cells.first[c + 1] - 1;
            const double pressure = area_pressure(membrane, cells, c);
            load_nodes(m, pressure, head + 1, tail);
            load_node(m, pressure, tail, head, head + 1);
            load_node(m, pressure, tail - 1, tail, head);
        }
    }
    team_barrier();
}

}  // namespace tt
