#include "membrane/viscosity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/vec2.hpp"
#include "membrane/node_mobility.hpp"

namespace tt {
namespace {

/// One cell laid out: [k] for −1 ≤ k ≤ count. Of segments at their first node, but for x, y, u, arc
/// and the moment, which are of nodes.
struct Ring {
    int count;
    double *x, *y, *ux, *uy;
    double *tangent_x, *tangent_y, *length;
    double* arc;                                    ///< mean length of the two segments at a node
    double* spin;                                   ///< ω
    double *upper, *lower, *right, *work, *change;  ///< of the linear system

    void close(double* numbers) const {
        numbers[-1] = numbers[count - 1];
        numbers[count] = numbers[0];
    }
};

Ring lay_out(const Suspension& cells, int cell, std::vector<double>& room) {
    constexpr int arrays = 14, halo = 1;
    const int first = cells.first[cell], count = cells.node_count(cell);
    const int pitch = count + 2 * halo;
    if (room.size() < static_cast<std::size_t>(arrays * pitch)) room.resize(arrays * pitch);
    double* rest = room.data() + halo;
    const auto next = [&] { return std::exchange(rest, rest + pitch); };
    Ring m{count,  next(), next(), next(), next(), next(), next(), next(),
           next(), next(), next(), next(), next(), next(), next()};
    std::copy_n(&cells.x[first], count, m.x);
    std::copy_n(&cells.y[first], count, m.y);
    std::copy_n(&cells.ux[first], count, m.ux);
    std::copy_n(&cells.uy[first], count, m.uy);
    for (double* array : {m.x, m.y, m.ux, m.uy}) m.close(array);
    for (int k = 0; k < count; ++k) {
        const double dx = m.x[k + 1] - m.x[k], dy = m.y[k + 1] - m.y[k];
        m.length[k] = std::sqrt(dx * dx + dy * dy);
        m.tangent_x[k] = dx / m.length[k];
        m.tangent_y[k] = dy / m.length[k];
    }
    for (double* array : {m.tangent_x, m.tangent_y, m.length}) m.close(array);
    for (int k = 0; k <= count; ++k) m.arc[k] = 0.5 * (m.length[k - 1] + m.length[k]);
    return m;
}

/// Solves a cyclic tridiagonal system in place: diagonal `middle`, with `lower` and `upper` beside
/// it, the first and last of which couple the ends (Sherman and Morrison). Diagonally dominant.
/// `right` becomes the solution.
void solve_cyclic(int count, const double* lower, double* middle, const double* upper,
                  double* right, double* work) {
    const double corner_low = lower[0], corner_high = upper[count - 1];
    const double gamma = -middle[0];
    middle[0] -= gamma;
    middle[count - 1] -= corner_low * corner_high / gamma;
    // Both right-hand sides at once: the system's own, and (γ, 0, …, 0, corner_high).
    for (int k = 0; k < count; ++k) work[k] = 0.0;
    work[0] = gamma;
    work[count - 1] = corner_high;
    for (int k = 1; k < count; ++k) {
        const double factor = lower[k] / middle[k - 1];
        middle[k] -= factor * upper[k - 1];
        right[k] -= factor * right[k - 1];
        work[k] -= factor * work[k - 1];
    }
    right[count - 1] /= middle[count - 1];
    work[count - 1] /= middle[count - 1];
    for (int k = count - 2; k >= 0; --k) {
        right[k] = (right[k] - upper[k] * right[k + 1]) / middle[k];
        work[k] = (work[k] - upper[k] * work[k + 1]) / middle[k];
    }
    const double share = (right[0] + corner_low * right[count - 1] / gamma) /
                         (1.0 + work[0] + corner_low * work[count - 1] / gamma);
    for (int k = 0; k < count; ++k) right[k] -= share * work[k];
}

/// dT, into `change`.
void change_tension(const Ring& m, double viscosity, double mobility, const double* tension) {
    for (int k = 0; k < m.count; ++k) {
        const double rate =
            (m.tangent_x[k] * (m.ux[k + 1] - m.ux[k]) + m.tangent_y[k] * (m.uy[k + 1] - m.uy[k])) /
            m.length[k];
        m.change[k] = viscosity * rate - tension[k];
        const double unit = viscosity * mobility / m.length[k];
        const auto bend = [&](int a, int b) {
            return m.tangent_x[a] * m.tangent_x[b] + m.tangent_y[a] * m.tangent_y[b];
        };
        m.right[k] = 1.0 + unit * (1.0 / m.arc[k] + 1.0 / m.arc[k + 1]);
        m.lower[k] = -unit / m.arc[k] * bend(k, k - 1);
        m.upper[k] = -unit / m.arc[k + 1] * bend(k, k + 1);
    }
    solve_cyclic(m.count, m.lower, m.right, m.upper, m.change, m.work);
}

/// Of one (1 − a Δ), at the nodes.
void smooth_moment(const Ring& m, double a) {
    for (int k = 0; k < m.count; ++k) {
        const double before = a / (m.arc[k] * m.length[k - 1]),
                     after = a / (m.arc[k] * m.length[k]);
        m.lower[k] = -before;
        m.upper[k] = -after;
        m.right[k] = 1.0 + before + after;
    }
    solve_cyclic(m.count, m.lower, m.right, m.upper, m.change, m.work);
}

/// dm, into `change`.
void change_moment(const Ring& m, double viscosity, double mobility, const double* moment) {
    for (int k = 0; k < m.count; ++k)
        m.spin[k] =
            (m.tangent_x[k] * (m.uy[k + 1] - m.uy[k]) - m.tangent_y[k] * (m.ux[k + 1] - m.ux[k])) /
            m.length[k];
    m.close(m.spin);
    for (int k = 0; k < m.count; ++k)
        m.change[k] = viscosity * (m.spin[k] - m.spin[k - 1]) / m.arc[k] - moment[k];
    const double a = std::sqrt(viscosity * mobility);
    smooth_moment(m, a);
    smooth_moment(m, a);
}

}  // namespace

void add_viscous_forces(const MembraneViscosity& viscosity, double plasma, Suspension& cells,
                        int cell) {
    thread_local std::vector<double> room;
    const Ring m = lay_out(cells, cell, room);
    const double mobility = node_mobility(plasma);
    const int first = cells.first[cell];
    double* const tension = &cells.viscous_tension[first];
    double* const moment = &cells.viscous_moment[first];
    if (viscosity.stretching > 0.0) {
        change_tension(m, viscosity.stretching, mobility, tension);
        for (int k = 0; k < m.count; ++k) tension[k] += m.change[k];
    }
    if (viscosity.bending > 0.0) {
        change_moment(m, viscosity.bending, mobility, moment);
        for (int k = 0; k < m.count; ++k) moment[k] += m.change[k];
    }
    const auto next = [&](int k) { return k + 1 < m.count ? k + 1 : 0; };
    for (int k = 0; k < m.count; ++k) {  // T t + q n, as of the elastic ones
        const double shear = (moment[next(k)] - moment[k]) / m.length[k];
        const double x = tension[k] * m.tangent_x[k] + shear * m.tangent_y[k];
        const double y = tension[k] * m.tangent_y[k] - shear * m.tangent_x[k];
        cells.fx[first + k] += x;
        cells.fy[first + k] += y;
        cells.fx[first + next(k)] -= x;
        cells.fy[first + next(k)] -= y;
    }
}

double viscous_dissipation(const MembraneViscosity& viscosity, const Suspension& cells, int cell) {
    double power = 0.0;
    const Outline shape = outline(cells, cell);
    for (int k = 0; k < shape.size(); ++k) {
        const int n = cells.first[cell] + k;
        const double tension = cells.viscous_tension[n], moment = cells.viscous_moment[n];
        const Vec2 here = shape[k], next = shape[k + 1 < shape.size() ? k + 1 : 0],
                   before = shape[k > 0 ? k - 1 : shape.size() - 1];
        const double length = norm(next - here);
        const double arc = 0.5 * (length + norm(here - before));
        if (viscosity.stretching > 0.0) power += tension * tension / viscosity.stretching * length;
        if (viscosity.bending > 0.0) power += moment * moment / viscosity.bending * arc;
    }
    return power;
}

}  // namespace tt
