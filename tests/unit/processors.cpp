#include "base/processors.hpp"

#include <sched.h>

#include <fstream>

#include <gtest/gtest.h>

#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

class Processors : public TemporaryDirectory {
protected:
    void put(const std::string& file, const std::string& text) {
        fs::create_directories(path(file).parent_path());
        std::ofstream(path(file)) << text << '\n';
    }
    int quota(const std::string& membership) { return processors_by_quota(path(""), membership); }
};

TEST_F(Processors, the_smallest_quota_on_the_way_counts_rounded_up) {
    put("jobs/cpu.max", "350000 100000");
    put("jobs/mine/cpu.max", "max 100000");
    EXPECT_EQ(quota("0::/jobs/mine\n"), 4);
    put("jobs/mine/cpu.max", "150000 100000");
    EXPECT_EQ(quota("0::/jobs/mine\n"), 2);
    put("jobs/cpu.max", "20000 100000");
    EXPECT_EQ(quota("0::/jobs/mine\n"), 1);
}

TEST_F(Processors, version_1_keeps_quota_and_period_apart) {
    put("cpu,cpuacct/slurm/cpu.cfs_quota_us", "250000");
    put("cpu,cpuacct/slurm/cpu.cfs_period_us", "100000");
    put("cpu,cpuacct/cpu.cfs_quota_us", "-1");
    put("cpu,cpuacct/cpu.cfs_period_us", "100000");
    EXPECT_EQ(quota("9:memory:/slurm\n4:cpu,cpuacct:/slurm\n0::/\n"), 3);
}

TEST_F(Processors, without_a_quota_there_is_no_limit) {
    EXPECT_EQ(quota(""), 0);
    EXPECT_EQ(quota("0::/\n"), 0);
    put("jobs/cpu.max", "max 100000");
    EXPECT_EQ(quota("0::/jobs\nnonsense\n"), 0);
}

TEST_F(Processors, those_of_the_affinity_are_usable) {
    cpu_set_t before;
    ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
    EXPECT_LE(usable_processors(), CPU_COUNT(&before));
    cpu_set_t one;
    CPU_ZERO(&one);
    int first = 0;
    while (!CPU_ISSET(first, &before)) ++first;
    CPU_SET(first, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(usable_processors(), 1);
    sched_setaffinity(0, sizeof before, &before);
}

/// The sizes of docs/performance.md, on two cores.
TEST(ThreadsFor, small_steps_are_not_shared_and_large_ones_are) {
    EXPECT_EQ(threads_for(960, 34, 2), 1);
    EXPECT_EQ(threads_for(5000, 192, 2), 1);  // 4 cells
    EXPECT_EQ(threads_for(5000, 576, 2), 2);  // 12 cells
    EXPECT_EQ(threads_for(10'000, 256, 2), 2);
    EXPECT_EQ(threads_for(40'000, 1512, 2), 2);
    EXPECT_EQ(threads_for(40'000, 1512, 1), 1);
    EXPECT_EQ(threads_for(100, 0, 64), 1);
    EXPECT_EQ(threads_for(4'000'000'000, 0, 64), 64);
}

}  // namespace
}  // namespace tt
