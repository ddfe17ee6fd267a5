#include "membrane/implicit_tension.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "base/isa.hpp"

namespace tt {
namespace {

/// Sweeps of Jacobi: 24 give what 8 do. An even number, so that the last is in `answer`.
constexpr int sweeps = 8;

/// One cell's nodes and segments, 0 … count − 1, and in all but the first line also −1 and count.
struct Chain {
    int count;
    const double *x, *y, *stiffness;
    double *ux, *uy;
    double *tangent_x, *tangent_y;
    double* bend;          ///< cosine of the angle between a segment and the next
    double* elongation;    ///< e, of a segment, with the velocities as they come
    double* compliance;    ///< K/(1 + 2 K)
    double *answer, *old;  ///< K e', by which the velocities at both ends change

    void close(double* numbers) const {
        numbers[-1] = numbers[count - 1];
        numbers[count] = numbers[0];
    }
};

Chain chain_of(Suspension& cells, int cell, std::vector<double>& room) {
    constexpr int arrays = 7, halo = 8;
    const int first = cells.first[cell], count = cells.node_count(cell);
    const int pitch = count + 2 * halo;
    if (room.size() < static_cast<std::size_t>(arrays * pitch)) room.resize(arrays * pitch);
    double* rest = room.data() + halo;
    const auto next = [&] { return std::exchange(rest, rest + pitch); };
    return {count,
            &cells.x[first],
            &cells.y[first],
            &cells.stiffness[first],
            &cells.ux[first],
            &cells.uy[first],
            next(),
            next(),
            next(),
            next(),
            next(),
            next(),
            next()};
}

TT_INLINE void measure_segment(const Chain& m, double mobility, int k, int next) {
    const double dx = m.x[next] - m.x[k], dy = m.y[next] - m.y[k];
    const double inverse = 1.0 / std::sqrt(dx * dx + dy * dy);
    const double tx = dx * inverse, ty = dy * inverse;
    const double stiff = mobility * m.stiffness[k];
    m.tangent_x[k] = tx;
    m.tangent_y[k] = ty;
    m.elongation[k] = tx * (m.ux[next] - m.ux[k]) + ty * (m.uy[next] - m.uy[k]);
    m.compliance[k] = stiff / (1.0 + 2.0 * stiff);
    m.answer[k] = m.compliance[k] * m.elongation[k];
}

TT_CLONES void measure(const Chain& ring, double mobility) {
    const Chain m = ring;
#pragma omp simd
    for (int k = 0; k < m.count - 1; ++k) measure_segment(m, mobility, k, k + 1);
    measure_segment(m, mobility, m.count - 1, 0);
}

TT_CLONES void measure_bends(const Chain& ring) {
    const Chain m = ring;
#pragma omp simd
    for (int k = -1; k < m.count; ++k)
        m.bend[k] = m.tangent_x[k] * m.tangent_x[k + 1] + m.tangent_y[k] * m.tangent_y[k + 1];
}

/// A segment's elongation is what it was, less twice its own answer, plus those of its neighbours.
TT_CLONES void sweep(const Chain& ring) {
    const Chain m = ring;
#pragma omp simd
    for (int k = 0; k < m.count; ++k)
        m.answer[k] = m.compliance[k] *
                      (m.elongation[k] + (m.bend[k] * m.old[k + 1] + m.bend[k - 1] * m.old[k - 1]));
}

TT_CLONES void move_ends(const Chain& ring) {
    const Chain m = ring;
#pragma omp simd
    for (int k = 0; k < m.count; ++k) {
        m.ux[k] += m.answer[k] * m.tangent_x[k] - m.answer[k - 1] * m.tangent_x[k - 1];
        m.uy[k] += m.answer[k] * m.tangent_y[k] - m.answer[k - 1] * m.tangent_y[k - 1];
    }
}

}  // namespace

void answer_with_tension(double mobility, Suspension& cells, int cell) {
    thread_local std::vector<double> room;
    Chain ring = chain_of(cells, cell, room);
    measure(ring, mobility);
    for (double* array : {ring.tangent_x, ring.tangent_y, ring.answer}) ring.close(array);
    measure_bends(ring);
    for (int n = 0; n < sweeps; ++n) {
        std::swap(ring.answer, ring.old);
        sweep(ring);
        ring.close(ring.answer);
    }
    move_ends(ring);
}

}  // namespace tt
