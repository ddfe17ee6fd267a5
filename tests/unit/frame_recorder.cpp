#include "observe/frame_recorder.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fluid/moments.hpp"
#include "simulation/advance.hpp"
#include "small_run.hpp"

namespace tt {
namespace {

/// The units are written out here: dx, dt and density as the model has them.
TEST(FrameOf, holds_the_state_in_SI) {
    const Model model = small_model();
    State state = small_state(model);
    Periodic exchange;
    for (int step = 0; step < 40; ++step) advance(model, state, exchange);
    const Frame frame = frame_of(Snapshot(model, state));
    const double dx = model.scales.length, dt = model.scales.time;
    const double density = model.scales.mass / (dx * dx * dx);
    const auto close = [](double a, double b) { EXPECT_NEAR(a, b, 1e-6 * std::abs(b)); };
    EXPECT_EQ(frame.step, 40);
    close(frame.time, 40 * dt);
    ASSERT_EQ(frame.nodes.size(), 2 * state.cells.x.size());
    for (std::size_t n = 0; n < state.cells.x.size(); ++n) {
        close(frame.nodes[2 * n], state.cells.x[n] * dx);
        close(frame.nodes[2 * n + 1], state.cells.y[n] * dx);
        close(frame.node_velocity[2 * n], state.cells.ux[n] * dx / dt);
        close(frame.node_velocity[2 * n + 1], state.cells.uy[n] * dx / dt);
        // [force per depth] = ρ dx³ / dt² / … : mass / dt² in units of N/m
        close(frame.node_force[2 * n], state.cells.fx[n] * density * dx * dx * dx / (dt * dt));
    }
    for (int j = 0; j < model.lattice.ny; ++j) {
        const std::vector<double> deviation = density_deviations(state.populations, j);
        for (int i = 0; i < model.lattice.nx; ++i) {
            const std::size_t site = static_cast<std::size_t>(j) * model.lattice.nx + i;
            close(frame.velocity[2 * site], state.velocity.x.row(j)[i] * dx / dt);
            close(frame.velocity[2 * site + 1], state.velocity.y.row(j)[i] * dx / dt);
            close(frame.pressure[site], deviation[i] / 3.0 * density * dx * dx / (dt * dt));
            close(frame.cytoplasm[site], state.interior.fraction.row(j)[i]);
        }
    }
    EXPECT_GT(std::abs(frame.velocity[0]), 0.0f);
}

}  // namespace
}  // namespace tt
