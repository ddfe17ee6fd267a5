#include "coupling/jump.hpp"

#include <cmath>
#include <variant>

#include "base/isa.hpp"

namespace tt {
namespace {

struct Nodes {
    const double *x, *y, *fx, *fy, *rate_xx, *rate_xy;
    double *ux, *uy, *dipole_xx, *dipole_xy;
};

Nodes nodes_of(Suspension& s) {
    return {s.x.data(),       s.y.data(),  s.fx.data(), s.fy.data(),        s.rate_xx.data(),
            s.rate_xy.data(), s.ux.data(), s.uy.data(), s.dipole_xx.data(), s.dipole_xy.data()};
}

/// Unit tangent and tangential load of a node between its neighbours.
struct Load {
    double tx, ty;
    double arc;         ///< Δs
    double tangential;  ///< f_t per length
};

TT_INLINE Load load_of(const Nodes& m, int before, int k, int next) {
    const double ex = m.x[next] - m.x[before];
    const double ey = m.y[next] - m.y[before];
    const double length = std::sqrt(ex * ex + ey * ey);
    const double inverse = 1.0 / length;
    const double tx = ex * inverse, ty = ey * inverse;
    return {tx, ty, 0.5 * length, (m.fx[k] * tx + m.fy[k] * ty) * (2.0 * inverse)};
}

/// d (t n + n t) Δs with n = (t_y, −t_x): slip s = f_t Δφ c_φ, d = −s/φ̄.
TT_INLINE void set_dipole(const JumpCorrection& jump, const Nodes& m, int before, int k, int next) {
    const Load load = load_of(m, before, k, next);
    const double slip = load.tangential * jump.fluidity_jump * jump.spread.slip(load.tx, load.ty);
    const double dipole = -slip * jump.mean_viscosity() * load.arc;
    m.dipole_xx[k] = 2.0 * dipole * load.tx * load.ty;
    m.dipole_xy[k] = dipole * (load.ty * load.ty - load.tx * load.tx);
}

TT_INLINE void correct_velocity(const JumpCorrection& jump, const Nodes& m, int before, int k,
                                int next) {
    const Load load = load_of(m, before, k, next);
    const double tx = load.tx, ty = load.ty;
    const double stress_jump = -load.tangential;
    const double product = stress_jump * jump.fluidity_jump;
    // t·(∇u + ∇uᵀ)·n as interpolated = σ̄ φ̄ + (share + square · c_φ) Δσ Δφ, the latter by the
    // dipole.
    const double length = jump.spread.slip(tx, ty);  // c_φ
    const double rate = 2.0 * tx * ty * m.rate_xx[k] + (ty * ty - tx * tx) * m.rate_xy[k];
    const double rate_share = jump.spread.share + jump.spread.square * length;
    const double mean_stress = (rate - rate_share * product) * jump.mean_viscosity();
    const double error = jump.spread.force * stress_jump * jump.mean_fluidity +
                         length * jump.fluidity_jump *
                             (mean_stress - jump.spread.share * product * jump.mean_viscosity());
    m.ux[k] -= error * tx;
    m.uy[k] -= error * ty;
}

TT_CLONES void set_dipoles_between(const JumpCorrection& jump, const Nodes& nodes, int begin,
                                   int end) {
    const JumpCorrection j = jump;
    const Nodes m = nodes;
#pragma omp simd
    for (int k = begin; k < end; ++k) set_dipole(j, m, k - 1, k, k + 1);
}

TT_CLONES void correct_between(const JumpCorrection& jump, const Nodes& nodes, int begin, int end) {
    const JumpCorrection j = jump;
    const Nodes m = nodes;
#pragma omp simd
    for (int k = begin; k < end; ++k) correct_velocity(j, m, k - 1, k, k + 1);
}

}  // namespace

JumpCorrection jump_correction(const Delta& delta, double plasma, double cytoplasm) {
    const double outside = 1.0 / plasma, inside = 1.0 / cytoplasm;
    const KernelSpread spread = std::visit([](const auto& kernel) { return kernel.spread; }, delta);
    return {true, 0.5 * (outside + inside), outside - inside, spread};
}

void set_dipoles(const JumpCorrection& jump, Suspension& cells, int cell) {
    const Nodes m = nodes_of(cells);
    const int head = cells.first[cell], tail = cells.first[cell + 1] - 1;
    set_dipoles_between(jump, m, head + 1, tail);
    set_dipole(jump, m, tail, head, head + 1);
    set_dipole(jump, m, tail - 1, tail, head);
}

void correct_velocities(const JumpCorrection& jump, Suspension& cells, int cell) {
    if (!jump.active) return;
    const Nodes m = nodes_of(cells);
    const int head = cells.first[cell], tail = cells.first[cell + 1] - 1;
    correct_between(jump, m, head + 1, tail);
    correct_velocity(jump, m, tail, head, head + 1);
    correct_velocity(jump, m, tail - 1, tail, head);
}

}  // namespace tt
