#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
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
                if (k > 0) {
                    EXPECT_GE(owner[k], owner[k - 1]);
                }
            }
        }
    }
}

/// Schedulers set limits of processes and of memory.
TEST(Team, is_of_the_threads_that_the_system_gives) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer needs memory of its own for each thread";
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    GTEST_SKIP() << "likewise";
#endif
#endif
    constexpr int asked = 200, count = 1000;
    const pid_t child = fork();
    if (child == 0) {
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        // Room for some stacks of 8 MB more.
        const rlim_t bytes = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + (100u << 20);
        const rlimit limit{bytes, bytes};
        setrlimit(RLIMIT_AS, &limit);
        std::vector<int> done(count, 0);
        int size = 0;
        with_team(asked, [&] {
            const auto [begin, end] = team_share(count);
            for (int k = begin; k < end; ++k) ++done[k];
            on_one_thread([&] { size = team_size(); });
        });
        const bool all = std::count(done.begin(), done.end(), 1) == count;
        _exit(all && size > 1 && size < asked ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

}  // namespace
