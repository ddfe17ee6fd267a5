#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"

namespace tt {
namespace {

TEST(FlowKept, a_run_that_keeps_the_flow_near_membranes_ends_with_all_of_it_and_the_same_bits) {
    Model model = small_model();
    State plain = small_state(model);
    State run = small_state(model);
    Periodic exchange;
    for (int k = 0; k < 117; ++k) advance(model, plain, exchange);
    Health health({}, run);
    model.threads = 2;
    run_steps(model, run, exchange, health, 117, Clock::time_point::max());
    EXPECT_EQ(state_hash(run), state_hash(plain));
    int different = 0;
    for (int j = 0; j < model.lattice.ny; ++j) {
        for (int i = 0; i < model.lattice.nx; ++i)
            different += run.velocity.x(i, j) != plain.velocity.x(i, j) ||
                                 run.velocity.y(i, j) != plain.velocity.y(i, j)
                             ? 1
                             : 0;
    }
    EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace tt
