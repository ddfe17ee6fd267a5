#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "fluid/moments.hpp"
#include "simulation/advance.hpp"
#include "small_run.hpp"

namespace tt {
namespace {

/// Stripes u_y = amplitude (−1)^y in a fluid at rest.
void add_stripes(const Lattice& lattice, double amplitude, Populations<>& populations) {
    for (int k = 0; k < d2q9::count; ++k) {
        for (int j = 0; j < lattice.ny; ++j) {
            const double u = j % 2 == 0 ? amplitude : -amplitude;
            for (int i = 0; i < lattice.nx; ++i) {
                const double f = populations.slot(k, i, j);
                populations.set_slot(k, i, j, f + 3.0 * d2q9::weight[k] * d2q9::cy[k] * u);
            }
        }
    }
}

/// Largest velocities that nodes sample, and with which they move, in steps 2 to 9 of a resting box
/// with stripes.
struct Largest {
    double sampled = 0.0, moved = 0.0;
};

Largest largest_velocities(const Delta& delta, double amplitude) {
    Model model = small_model();
    model.lattice.walls = false;  // which would damp the stripes
    model.boundaries = {};
    model.shear_rate = 0.0;
    model.delta = delta;
    model.kinds[0].jump =
        jump_correction(model.delta, model.viscosity.plasma, model.viscosity.cytoplasm[0]);
    State state = small_state(model);
    add_stripes(model.lattice, amplitude, std::get<Sites<double>>(state.sites).populations);
    Periodic exchange;
    Largest largest;
    with_team(1, [&] {
        for (int step = 0; step < 10; ++step) {
            advance(model, state, exchange);
            if (step < 2) continue;
            for (const double u : state.cells.uy_sampled)
                largest.sampled = std::max(largest.sampled, std::abs(u));
            for (const double u : state.cells.uy)
                largest.moved = std::max(largest.moved, std::abs(u));
        }
    });
    return largest;
}

/// A lattice Boltzmann fluid conserves (−1)^{y+t} u_y beside its momentum, so that the stripes
/// stay; kernels of fewer than four points sample them (roma3: up to a third), and what they do to
/// the membranes would feed them.
TEST(StaggeredMode, does_not_move_nodes) {
    constexpr double amplitude = 1e-4;
    for (const Delta& delta : {Delta{Roma3{}}, Delta{Peskin4{}}, Delta{Cosine4{}}})
        EXPECT_LT(largest_velocities(delta, amplitude).moved, 0.02 * amplitude);
    EXPECT_GT(largest_velocities(Roma3{}, amplitude).sampled, 0.2 * amplitude);
}

}  // namespace
}  // namespace tt
