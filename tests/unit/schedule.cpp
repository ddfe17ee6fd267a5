#include "simulation/schedule.hpp"

#include <gtest/gtest.h>

namespace tt {
namespace {

TEST(Schedule, is_due_once_an_interval_and_never_drifts) {
    const Schedule schedule(1e-4, 3e-7);  // 333.33 steps
    int count = 0;
    for (std::int64_t step = 0; step <= 1'000'000; ++step) count += schedule.due(step) ? 1 : 0;
    EXPECT_EQ(count, 3001);
    EXPECT_TRUE(schedule.due(1'000'000));  // 3000 intervals are a million steps
}

TEST(Schedule, the_next_due_step_does_not_depend_on_where_one_asks) {
    for (const double interval : {0.3, 1.0, 1.5, 7.0, 333.3333}) {
        const Schedule schedule(interval, 1.0);
        for (std::int64_t step = 0; step < 2000; ++step) {
            const std::int64_t next = schedule.next_after(step);
            ASSERT_GT(next, step);
            ASSERT_TRUE(schedule.due(next)) << interval << ' ' << step;
            for (std::int64_t between = step + 1; between < next; ++between)
                ASSERT_FALSE(schedule.due(between));
        }
    }
}

TEST(Schedule, an_interval_that_no_run_reaches_is_never_due_again) {
    for (const double interval : {1e9, 1e13, 1e19, 1e300}) {
        const Schedule schedule(interval, 1e-7);
        EXPECT_TRUE(schedule.due(0));
        EXPECT_FALSE(schedule.due(1));
        EXPECT_GT(schedule.next_after(0), 1'000'000'000'000) << interval;
        EXPECT_GT(schedule.next_after(1'000'000), 1'000'000'000'000) << interval;
    }
    EXPECT_EQ(Schedule(1e-300, 1e-7).next_after(41), 42);
}

TEST(Schedule, an_end_that_is_a_whole_number_of_steps_is_met_exactly) {
    EXPECT_EQ(steps_until(0.08, 1e-6), 80000);
    EXPECT_EQ(steps_until(0.1, 0.1 / 3), 3);
    EXPECT_EQ(steps_until(1.0, 0.3), 3);
    EXPECT_EQ(steps_until(1e-9, 1.0), 1);
}

/// Else the last row is doubled: once where it is due, and one step later, at the end.
TEST(Schedule, an_interval_that_divides_the_end_is_due_at_the_end) {
    for (int k = 0; k < 20000; ++k) {
        const double dt = 1e-7 * (1.0 + 1e-4 * k), end = 2e-3;
        for (const int parts : {1, 2, 3, 7, 50, 500})
            ASSERT_TRUE(Schedule(end / parts, dt).due(steps_until(end, dt))) << dt << ' ' << parts;
    }
}

TEST(Schedule, an_interval_beyond_all_time_is_due_at_the_start_alone) {
    for (const double interval : {1e6, 1e13, 1e300}) {
        const Schedule schedule(interval, 1e-7);
        EXPECT_TRUE(schedule.due(0));
        EXPECT_GT(schedule.next_after(0), std::int64_t{1} << 40);
        EXPECT_FALSE(schedule.due(1'000'000));
    }
}

}  // namespace
}  // namespace tt
