#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "io/archive.hpp"
#include "simulation/advance.hpp"
#include "simulation/rescale.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

/// The small model with a time step `ratio` times as long, at the same relaxation time: the density
/// scale goes with it.
Model with_step(double ratio, Equilibrium equilibrium) {
    Model model = small_model();
    model.equilibrium = equilibrium;
    model.scales = {model.scales.length, ratio * model.scales.time, ratio * model.scales.mass};
    model.boundaries.top_speed *= ratio;
    model.boundaries.bottom_speed *= ratio;
    model.kinds[0].membrane.in_plane = NeoHookean{ratio * 2e-3};
    model.kinds[0].membrane.area_stiffness *= ratio;
    model.shear_rate *= ratio;
    return model;
}

void step(const Model& model, State& state, int steps) {
    Periodic exchange;
    for (int n = 0; n < steps; ++n) advance(model, state, exchange);
}

/// Largest difference of the fluid's velocities in SI, over the largest velocity.
double difference(const Model& m, const State& a, const Model& n, const State& b) {
    double largest = 0.0, fastest = 0.0;
    const double unit_a = m.scales.unit(Velocity::dimension);
    const double unit_b = n.scales.unit(Velocity::dimension);
    for (int j = 0; j < m.lattice.ny; ++j) {
        for (int i = 0; i < m.lattice.nx; ++i) {
            const double in_a = unit_a * a.velocity(i, j).x, in_b = unit_b * b.velocity(i, j).x;
            largest = std::max(largest, std::abs(in_a - in_b));
            fastest = std::max(fastest, std::abs(in_a));
        }
    }
    return largest / fastest;
}

class TimeStepChange : public testing::TestWithParam<Equilibrium> {};

/// The flow has settled, so that the density scale, which goes with the step, matters little.
TEST_P(TimeStepChange, leaves_flow_and_cells_as_they_would_have_been) {
    const Model old_model = with_step(1.0, GetParam());
    State settled = small_state(old_model);
    step(old_model, settled, 401);
    for (const double ratio : {0.5, 2.0}) {
        const Model new_model = with_step(ratio, GetParam());
        State straight = settled;
        State changed = straight;
        change_time_step(new_model, ratio, changed);
        derive(new_model, changed);
        EXPECT_LT(difference(old_model, straight, new_model, changed), 0.01)
            << "at once; the last step's velocity knows the membranes' force, this one not";
        step(old_model, straight, 8);
        step(new_model, changed, static_cast<int>(8 / ratio));
        EXPECT_LT(difference(old_model, straight, new_model, changed), 4e-3) << "soon";
        step(old_model, straight, 100);
        step(new_model, changed, static_cast<int>(100 / ratio));
        EXPECT_LT(difference(old_model, straight, new_model, changed), 5e-3) << "and later";
        for (int n = 0; n < straight.cells.node_count(); ++n) {
            EXPECT_NEAR(straight.cells.x[n], changed.cells.x[n], 0.01);
            EXPECT_NEAR(straight.cells.y[n], changed.cells.y[n], 0.01);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Equilibria, TimeStepChange,
                         testing::Values(Equilibrium{LinearEquilibrium{}},
                                         Equilibrium{IncompressibleEquilibrium{}},
                                         Equilibrium{FullEquilibrium{}}));

/// Odd and even numbers of steps: the populations lie differently.
TEST(TimeStepChanges, are_one_factor_where_there_is_no_advection) {
    const Model model = with_step(1.0, LinearEquilibrium{});
    State state = small_state(model);
    for (const int steps : {20, 21}) {
        step(model, state, steps);
        State changed = state;
        change_time_step(with_step(0.3, LinearEquilibrium{}), 0.3, changed);
        const Populations<>&before = in_double(state).populations,
              &after = in_double(changed).populations;
        for (int k = 0; k < d2q9::count; ++k) {
            for (int j = 0; j < model.lattice.ny; ++j) {
                for (int i = 0; i < model.lattice.nx; ++i)
                    EXPECT_NEAR(after.arriving(k, i, j), 0.3 * before.arriving(k, i, j), 1e-16);
            }
        }
        EXPECT_EQ(changed.cells.ux_sampled[7], 0.3 * state.cells.ux_sampled[7]);
        EXPECT_EQ(changed.cells.pair_fx[7], 0.3 * state.cells.pair_fx[7]);
        EXPECT_EQ(changed.cells.x, state.cells.x);
    }
}

TEST(TimeStepChanges, keep_the_time) {
    State state = small_state(small_model());
    state.step = 1001;
    change_time_step(with_step(0.5, LinearEquilibrium{}), 0.5, state);
    EXPECT_EQ(state.step, 2002);
    change_time_step(with_step(0.3, LinearEquilibrium{}), 0.6, state);
    EXPECT_EQ(state.step, 3337);
}

/// A force along y counts as one along x does: with x and y changed over, so is the result.
TEST(TimeStepOfForce, changes_the_same_along_both_axes) {
    const auto over = [](int direction) {
        for (int k = 0; k < d2q9::count; ++k)
            if (d2q9::cx[k] == d2q9::cy[direction] && d2q9::cy[k] == d2q9::cx[direction]) return k;
        return 0;
    };
    const auto changed = [&](bool turned) {
        Model model;
        model.lattice = {5, 5, false};
        model.equilibrium = IncompressibleEquilibrium{};
        model.drive.direction = turned ? Vec2{0.3, 1.0} : Vec2{1.0, 0.3};
        State state;
        state.drive.body_force = 0.05;
        state.sites = sites_at_rest(model.lattice, Precision::fp64);
        auto& populations = std::get<Sites<double>>(state.sites).populations;
        Random random(7);
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 5; ++i)
                for (int k = 0; k < d2q9::count; ++k)
                    populations.set_slot(turned ? over(k) : k, turned ? j : i, turned ? i : j,
                                         0.01 * random.uniform());
        change_time_step(model, 0.5, state);
        return std::get<Sites<double>>(state.sites).populations;
    };
    const auto one = changed(false), other = changed(true);
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i)
            for (int k = 0; k < d2q9::count; ++k)
                EXPECT_NEAR(one.slot(k, i, j), other.slot(over(k), j, i), 1e-15);
}

}  // namespace
}  // namespace tt
