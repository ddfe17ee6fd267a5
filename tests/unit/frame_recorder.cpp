#include "observe/frame_recorder.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fluid/moments.hpp"
#include "simulation/advance.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

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
        const std::vector<double> deviation = density_deviations(in_double(state).populations, j);
        for (int i = 0; i < model.lattice.nx; ++i) {
            const std::size_t site = static_cast<std::size_t>(j) * model.lattice.nx + i;
            close(frame.velocity[2 * site], state.velocity(i, j).x * dx / dt);
            close(frame.velocity[2 * site + 1], state.velocity(i, j).y * dx / dt);
            close(frame.pressure[site], deviation[i] / 3.0 * density * dx * dx / (dt * dt));
            close(frame.cytoplasm[site], state.interior.cytoplasm.row(j)[i]);
        }
    }
    EXPECT_GT(std::abs(frame.velocity[0]), 0.0f);
}

/// Frames every 25 steps of 200.
std::vector<int> frames_with_fields(const std::filesystem::path& directory, double interval) {
    RunRequest request = small_request(directory, 200);
    request.fields = Time{interval * small_model().scales.time};
    run_small(request);
    const FramesReader reader(directory / "frames.h5");
    EXPECT_EQ(reader.count(), 9);
    std::vector<int> with;
    for (int k = 0; k < reader.count(); ++k)
        if (reader.has_fields(k)) with.push_back(k);
    return with;
}

using FrameFields = TemporaryDirectory;

TEST_F(FrameFields, come_in_each_frame_seldom_or_never) {
    const double never = std::numeric_limits<double>::infinity();
    EXPECT_EQ(frames_with_fields(path("each"), 0.0).size(), 9u);
    EXPECT_EQ(frames_with_fields(path("seldom"), 100.0), (std::vector<int>{0, 4, 8}));
    EXPECT_EQ(frames_with_fields(path("odd"), 60.0), (std::vector<int>{0, 3, 5, 8}));
    EXPECT_TRUE(frames_with_fields(path("never"), never).empty());
}

}  // namespace
}  // namespace tt
