#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/parallel.hpp"
#include "fluid/moments.hpp"
#include "simulation/advance.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"

namespace tt {
namespace {

struct Ran {
    Model model = small_model();
    State state;

    Ran(Precision precision, int steps, int threads = 1) {
        model.precision = precision;
        state = small_state(model);
        Periodic exchange;
        with_team(threads, [&] {
            for (int k = 0; k < steps; ++k) advance(model, state, exchange);
        });
    }
    double mass() const {
        double sum = 0.0;
        for (int j = 0; j < model.lattice.ny; ++j) {
            for (int i = 0; i < model.lattice.nx; ++i) sum += state.moments(i, j).density_deviation;
        }
        return sum / (model.lattice.nx * model.lattice.ny);
    }
};

/// Rounded by 6e-8 of a deviation of some hundredths at each step, cells go the same way: after
/// a strain of seven, nodes stand apart by less than a thousandth of a site.
TEST(SinglePrecision, cells_in_shear_go_the_same_way) {
    constexpr int steps = 4000;
    const Ran exact(Precision::fp64, steps);
    const Ran rounded(Precision::fp32, steps);
    double apart = 0.0;
    for (int n = 0; n < exact.state.cells.node_count(); ++n)
        apart = std::max({apart, std::abs(exact.state.cells.x[n] - rounded.state.cells.x[n]),
                          std::abs(exact.state.cells.y[n] - rounded.state.cells.y[n])});
    std::printf("nodes apart by %.2g sites, mean density by %.2g\n", apart,
                rounded.mass() - exact.mass());
    EXPECT_GT(apart, 0.0);
    EXPECT_LT(apart, 1e-3);
    EXPECT_LT(std::abs(rounded.mass() - exact.mass()), 1e-6);
}

TEST(SinglePrecision, threads_change_no_bit) {
    const Ran alone(Precision::fp32, 50);
    const Ran team(Precision::fp32, 50, 3);
    EXPECT_EQ(state_hash(alone.state), state_hash(team.state));
    EXPECT_EQ(alone.state.cells.x, team.state.cells.x);
}

}  // namespace
}  // namespace tt
