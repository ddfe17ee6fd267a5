#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"

namespace tt {
namespace {

class FlowKeptBy : public testing::TestWithParam<bool> {
protected:
    FlowKeptBy() { model.drive = {1e-5, GetParam(), 0.004}; }

    Model model = small_model();
    Periodic exchange;
};

int sites_that_differ(const VectorField<>& a, const VectorField<>& b) {
    int different = 0;
    const Lattice& lattice = a.x.lattice();
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i)
            different += a.x(i, j) != b.x(i, j) || a.y(i, j) != b.y(i, j) ? 1 : 0;
    }
    return different;
}

TEST_P(FlowKeptBy, a_run_that_keeps_it_near_membranes_ends_with_all_of_it_and_the_same_bits) {
    State plain = small_state(model);
    State run = small_state(model);
    for (int k = 0; k < 117; ++k) advance(model, plain, exchange);
    Health health({}, run);
    model.threads = 2;
    run_steps(model, run, exchange, health, 117, Clock::time_point::max());
    EXPECT_EQ(state_hash(run), state_hash(plain));
    EXPECT_EQ(sites_that_differ(in_double(run).velocity, in_double(plain).velocity), 0);
}

TEST_P(FlowKeptBy, only_a_controller_of_the_mean_velocity_needs_all_of_it_meanwhile) {
    State state = small_state(model);
    const VectorField<> before = in_double(state).velocity;
    for (int k = 0; k < 25; ++k) advance(model, state, exchange, FlowKept::near_membranes);
    const bool controller = GetParam();
    EXPECT_EQ(sites_that_differ(in_double(state).velocity, before) > 0, controller);
    EXPECT_EQ(state.drive.integral != 0.0, controller);
}

INSTANTIATE_TEST_SUITE_P(Drive, FlowKeptBy, testing::Values(false, true), [](const auto& kind) {
    return kind.param ? "mean_velocity_held" : "drive_constant";
});

}  // namespace
}  // namespace tt
