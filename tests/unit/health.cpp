#include "simulation/health.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "small_run.hpp"

namespace tt {
namespace {

const double not_a_number = std::nan("");

class HealthGuards : public testing::Test {
protected:
    Model model = small_model();
    State state = small_state(model);
    Health health{HealthLimits{}, state};

    std::optional<Instability> after_step() {
        health.watch_nodes(model, state.cells);
        team_barrier();
        return health.after_step(model, state, health.due(state.step));
    }
    std::string found_after_step() {
        const auto fault = after_step();
        return fault ? fault->quantity : "nothing";
    }
    std::string found() {
        const auto fault = health.examine(model, state);
        return fault ? fault->quantity : "nothing";
    }
};

TEST_F(HealthGuards, find_nothing_in_a_good_state) {
    EXPECT_EQ(found_after_step(), "nothing");
    EXPECT_EQ(found(), "nothing");
}

TEST_F(HealthGuards, see_a_node_that_is_not_a_number_at_once) {
    state.cells.y[40] = not_a_number;
    const auto fault = after_step();
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(fault->cell, 1);
    EXPECT_EQ(fault->node, 4);
    EXPECT_TRUE(std::isnan(fault->value));
    EXPECT_FALSE(fault->cause.empty());
    EXPECT_FALSE(fault->cure.empty());
}

TEST_F(HealthGuards, see_an_infinite_node_in_a_state_that_was_loaded) {
    state.cells.x[3] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(found(), "node x");
}

TEST_F(HealthGuards, see_a_node_jump_of_more_than_half_a_site) {
    state.cells.x[5] += 0.49;
    EXPECT_EQ(found_after_step(), "nothing");
    state.cells.x[5] += 0.51;
    EXPECT_EQ(found_after_step(), "way of a node in one step");
}

TEST_F(HealthGuards, see_a_node_beyond_a_wall) {
    state.cells.y[0] = -0.01;
    EXPECT_EQ(found(), "node y");
    model.lattice.walls = false;
    EXPECT_EQ(found(), "nothing") << "without walls y goes on counting like x";
}

TEST_F(HealthGuards, see_speed_and_nan_at_a_single_site) {
    in_double(state).velocity.y(32, 23) = 0.5 / std::sqrt(3.0) * 1.001;
    EXPECT_EQ(found(), "Mach number at site (32, 23)");
    in_double(state).velocity.y(32, 23) = not_a_number;
    EXPECT_EQ(found(), "Mach number at site (32, 23)");
}

TEST_F(HealthGuards, see_a_cell_that_lost_area_and_one_inside_out) {
    Suspension& cells = state.cells;
    for (int n = cells.first[1]; n < cells.first[2]; ++n)
        cells.y[n] = 12.0 + 0.94 * (cells.y[n] - 12.0);
    const auto fault = health.examine(model, state);
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(fault->cell, 1);
    EXPECT_NEAR(fault->value, -6.0, 1e-9);
    for (int n = cells.first[1]; n < cells.first[2]; ++n) cells.y[n] = 24.0 - cells.y[n];
    EXPECT_EQ(found(), "area error (the outline is inside out)");
}

TEST_F(HealthGuards, see_an_outline_that_crosses_itself) {
    std::swap(state.cells.x[10], state.cells.x[11]);
    std::swap(state.cells.y[10], state.cells.y[11]);
    const auto fault = health.examine(model, state);
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(fault->quantity, "crossings of segment 9 with segment 11 of the same cell");
    EXPECT_EQ(fault->cell, 0);
}

TEST_F(HealthGuards, tell_all_threads_of_a_team_the_same) {
    const double good = state.cells.x[40];
    std::array<std::string, 3> told;
    with_team(3, [&] {
        for (const double x : {not_a_number, good}) {
            if (team_rank() == 0) state.cells.x[40] = x;
            team_barrier();
            const std::string found = found_after_step();
            told[team_rank()] += found + " ";
        }
    });
    for (const std::string& words : told) EXPECT_EQ(words, "way of a node in one step nothing ");
}

TEST_F(HealthGuards, tell_all_threads_of_a_team_what_one_found_in_its_share) {
    const int top = model.lattice.ny - 1;
    std::array<std::string, 3> told;
    state.step = 200;
    with_team(3, [&] {
        for (const double speed : {0.5, 0.0}) {
            if (team_rank() == 0) in_double(state).velocity.x(7, top) = speed;
            team_barrier();
            told[team_rank()] += found_after_step() + ";";
        }
    });
    for (const std::string& words : told)
        EXPECT_EQ(words, "Mach number at site (7, " + std::to_string(top) + ");nothing;");
}

TEST_F(HealthGuards, costly_checks_are_due_every_hundred_steps) {
    in_double(state).velocity.x(1, 1) = 1.0;
    state.step = 199;
    EXPECT_EQ(found_after_step(), "nothing");
    state.step = 200;
    EXPECT_NE(found_after_step(), "nothing");
}

}  // namespace
}  // namespace tt
