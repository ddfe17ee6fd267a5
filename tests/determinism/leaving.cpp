#include "simulation/exits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "io/archive.hpp"
#include "simulation/health.hpp"
#include "simulation/rescale.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "source_dir.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

/// The fork with coarse cells: some leave within a thousand steps.
class Leaving : public TemporaryDirectory {
protected:
    Case c = read_case(
        TT_SOURCE_DIR "/cases/07-fork/case.toml",
        {"numerics.dx=0.5 um", "cells.hematocrit=10 %",
         R"(section.parent.from=["40 um", "-10 um"])", R"(section.parent.to=["40 um", "10 um"])",
         R"(section.upper_end.from=["140 um", "27 um"])",
         R"(section.upper_end.to=["140 um", "40 um"])"});
    Model model = discretise(c);
    State start = initial_state(c, model, {});

    void run(State& state, std::int64_t until, int threads = 1) {
        model.threads = threads;
        Periodic exchange;
        Health health({}, state);
        run_steps(model, state, exchange, health, until, Clock::time_point::max());
    }
    State run_to(std::int64_t until, int threads = 1) {
        State state = start;
        run(state, until, threads);
        return state;
    }
};

TEST_F(Leaving, every_cell_is_inside_or_has_left_and_keeps_its_number) {
    const State state = run_to(2000);
    const int count = start.cells.cell_count();
    ASSERT_GT(state.departed.size(), 1u);
    EXPECT_EQ(state.cells.cell_count() + static_cast<int>(state.departed.size()), count);
    std::set<std::int64_t> numbers(state.cells.id.begin(), state.cells.id.end());
    for (const Departed& d : state.departed) {
        numbers.insert(d.id);
        EXPECT_GT(d.exit, 0) << "the inlet lets none out";
        EXPECT_GT(d.speed, 0.0);
        EXPECT_GT(d.place, 0.0);
    }
    EXPECT_EQ(static_cast<int>(numbers.size()), count);
    double inside = 0.0;
    for (int cell = 0; cell < state.cells.cell_count(); ++cell) inside += state.cells.area[cell];
    double left = 0.0;
    for (const Departed& d : state.departed) left += d.area;
    double all = 0.0;
    for (const double area : start.cells.reference_area) all += area;
    EXPECT_NEAR((inside + left) / all, 1.0, 1e-4);
}

TEST_F(Leaving, is_the_same_on_any_threads_and_across_a_restart) {
    const State one = run_to(1500);
    ASSERT_FALSE(one.departed.empty());
    ASSERT_GT(one.sections[0].forward, 0);
    EXPECT_EQ(state_hash(one), state_hash(run_to(1500, 3)));

    // Before and after each departure, in both phases.
    std::set<std::int64_t> stops;
    for (const Departed& d : one.departed) {
        const auto left = static_cast<std::int64_t>(d.time);
        for (const std::int64_t step : {left - 1, left, left + 1}) stops.insert(step);
    }
    State state = start;
    for (const std::int64_t stop : stops) {
        if (stop <= state.step || stop >= 1500) continue;
        run(state, stop);
        ArchiveWriter archive(path("state"));
        save_state(archive, state);
        archive.commit({}, Durability::process);
        Periodic exchange;
        state = load_state(ArchiveReader(path("state")), model, exchange);
    }
    run(state, 1500);
    EXPECT_EQ(state_hash(one), state_hash(state));
    EXPECT_EQ(one.sections, state.sections);
}

TEST_F(Leaving, is_told_at_its_time_in_another_time_step) {
    State state = run_to(2000);
    ASSERT_FALSE(state.departed.empty());
    const Departed before = state.departed.front();
    const double inflow = state.ports[2].mean_inflow();
    Model shorter = model;
    const double ratio = 0.5;
    shorter.scales.time *= ratio;
    change_time_step(shorter, ratio, state);
    const Departed& after = state.departed.front();
    EXPECT_DOUBLE_EQ(after.time * shorter.scales.time, before.time * model.scales.time);
    EXPECT_DOUBLE_EQ(after.speed / shorter.scales.time, before.speed / model.scales.time);
    EXPECT_DOUBLE_EQ(state.ports[2].mean_inflow() / shorter.scales.time,
                     inflow / model.scales.time);
}

/// What goes wrong is told of the number that a cell has in all files.
TEST_F(Leaving, a_fault_after_it_names_the_right_cell) {
    State state = run_to(2000);
    ASSERT_FALSE(state.departed.empty());
    const int last = state.cells.cell_count() - 1;
    state.cells.x[state.cells.first[last]] = std::nan("");
    const auto found = Health({}, state).examine(model, state);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->cell, state.cells.id[last]);
    EXPECT_NE(found->cell, last);
    EXPECT_EQ(found->node, 0);
}

/// A cell that is gone at once kicks the flow; one that has faded does not.
TEST_F(Leaving, is_not_felt_by_the_flow) {
    const State before = run_to(1000);
    ASSERT_FALSE(run_to(1500).departed.empty());
    State state = before;
    double largest = 0.0;
    for (int n = 0; n < 500; ++n) {
        const double last = state.ports[2].mean_inflow();
        run(state, state.step + 1);
        largest = std::max(largest, std::abs(state.ports[2].mean_inflow() - last));
    }
    EXPECT_LT(largest / std::abs(before.ports[2].mean_inflow()), 2e-3);
}

}  // namespace
}  // namespace tt
