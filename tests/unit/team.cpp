#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "base/parallel.hpp"
#include "base/random.hpp"

namespace {

using namespace tt;

TEST(Team, no_barrier_is_passed_before_all_have_come_and_none_sleeps_for_ever) {
    // Threads late in turn by up to twice as long as others look before they sleep: some waits end
    // while others look, some while they fall asleep, some while they sleep. A wake-up that is lost
    // stops this test, and stopped a run of hours (see Team::wait).
    constexpr int barriers = 3'000;
    for (int threads : {2, 3}) {
        int come = 0;  // by the late one of each round: no atomic, so a sanitizer sees a race
        int seen_too_early = 0;
        with_team(threads, [&] {
            Random random(team_rank());
            for (int k = 0; k < barriers; ++k) {
                if (k % threads == team_rank()) {
                    using Clock = std::chrono::steady_clock;
                    const auto until =
                        Clock::now() +
                        std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(random.uniform(0.0, 2.5e-4)));
                    while (Clock::now() < until) {
                    }
                    ++come;
                }
                team_barrier();
                if (team_rank() == 0 && come != k + 1) ++seen_too_early;
                team_barrier();
            }
        });
        EXPECT_EQ(come, barriers);
        EXPECT_EQ(seen_too_early, 0);
    }
}

TEST(Team, shares_cover_everything_once_in_order) {
    for (int threads : {1, 2, 3, 7}) {
        for (int count : {0, 1, 5, 100}) {
            std::vector<int> owner(count, -1);
            with_team(threads, [&] {
                const auto [begin, end] = team_share(count);
                for (int k = begin; k < end; ++k) owner[k] = team_rank();
            });
            for (int k = 0; k < count; ++k) {
                EXPECT_GE(owner[k], 0);
                if (k > 0) EXPECT_GE(owner[k], owner[k - 1]);
            }
        }
    }
}

}  // namespace
