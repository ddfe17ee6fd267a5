#include "base/processors.hpp"

#include <sched.h>

#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/case_options.hpp"
#include "base/control_groups.hpp"
#include "base/memory.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

class ControlGroups : public TemporaryDirectory {
protected:
    void put(const std::string& file, const std::string& text) {
        fs::create_directories(path(file).parent_path());
        std::ofstream(path(file)) << text << '\n';
    }
    int quota(const std::string& membership) {
        return processors_by_quota(control_groups(path(""), membership, "cpu"));
    }
    double memory(const std::string& membership) {
        return memory_by_limit(control_groups(path(""), membership, "memory"));
    }
};

TEST_F(ControlGroups, the_smallest_quota_on_the_way_counts_rounded_up) {
    put("jobs/cpu.max", "350000 100000");
    put("jobs/mine/cpu.max", "max 100000");
    EXPECT_EQ(quota("0::/jobs/mine\n"), 4);
    put("jobs/mine/cpu.max", "150000 100000");
    EXPECT_EQ(quota("0::/jobs/mine\n"), 2);
    put("jobs/cpu.max", "20000 100000");
    EXPECT_EQ(quota("0::/jobs/mine\n"), 1);
}

TEST_F(ControlGroups, version_1_keeps_quota_and_period_apart) {
    put("cpu,cpuacct/slurm/cpu.cfs_quota_us", "250000");
    put("cpu,cpuacct/slurm/cpu.cfs_period_us", "100000");
    put("cpu,cpuacct/cpu.cfs_quota_us", "-1");
    put("cpu,cpuacct/cpu.cfs_period_us", "100000");
    EXPECT_EQ(quota("9:memory:/slurm\n4:cpu,cpuacct:/slurm\n0::/\n"), 3);
}

TEST_F(ControlGroups, without_a_quota_there_is_no_limit) {
    EXPECT_EQ(quota(""), 0);
    EXPECT_EQ(quota("0::/\n"), 0);
    put("jobs/cpu.max", "max 100000");
    EXPECT_EQ(quota("0::/jobs\nnonsense\n"), 0);
}

TEST_F(ControlGroups, the_smallest_limit_of_memory_on_the_way_counts) {
    EXPECT_TRUE(std::isinf(memory("0::/jobs/mine\n")));
    put("jobs/memory.max", "3000000000");
    put("jobs/mine/memory.max", "max");
    EXPECT_EQ(memory("0::/jobs/mine\n"), 3e9);
    put("jobs/mine/memory.max", "2000000000");
    EXPECT_EQ(memory("0::/jobs/mine\n"), 2e9);
    put("memory/memory.limit_in_bytes", "9223372036854771712");
    put("memory/slurm/memory.limit_in_bytes", "1000000000");
    EXPECT_EQ(memory("9:memory:/slurm\n4:cpu,cpuacct:/slurm\n0::/\n"), 1e9);
    EXPECT_LE(usable_memory(), memory_by_limit(control_groups("memory")));
}

TEST(Processors, those_of_the_affinity_are_usable) {
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
    EXPECT_EQ(threads_for(960, 43, 2), 1);
    EXPECT_EQ(threads_for(2400, 86, 2), 2);
    EXPECT_EQ(threads_for(5000, 172, 2), 2);  // 4 cells
    EXPECT_EQ(threads_for(10'000, 516, 2), 2);
    EXPECT_EQ(threads_for(40'000, 1512, 2), 2);
    EXPECT_EQ(threads_for(40'000, 1512, 1), 1);
    EXPECT_EQ(threads_for(100, 0, 64), 1);
    EXPECT_EQ(threads_for(4'000'000'000, 0, 64), 64);
}

/// However the cells are asked for: by their number, their share, or one by one.
TEST(ThreadsFor, every_layout_counts) {
    const auto nodes = [](const std::string& cells) {
        const Case c = parse_case(
            "format = 1\ndomain = { length = \"60 um\", width = \"20 um\" }\n"
            "flow = { drive = \"pressure\", pseudo_shear_rate = \"200 /s\" }\n"
            "numerics = { dx = \"0.4 um\" }\ntime = { end = \"1 ms\" }\n"
            "cells = { radius = \"2.7 um\", " +
                cells + " }\n",
            "x.toml", {}, ".");
        const Choice choice = choose(c);
        const auto expected = static_cast<double>(expected_nodes(c, choice));
        const State state = initial_state(c, discretise(c, choice));
        EXPECT_NEAR(expected, state.cells.node_count(), 0.05 * expected) << cells;
        return expected;
    };
    std::string places;
    for (int k = 0; k < 8; ++k) places += fmt::format("[\"{} um\", \"10 um\"], ", 4.0 + 7.0 * k);
    const double by_count = nodes("layout = \"random\", count = 8");
    EXPECT_GT(by_count, 200.0);
    EXPECT_EQ(nodes("layout = \"explicit\", positions = [" + places + "]"), by_count);
    EXPECT_NEAR(nodes("layout = \"random\", hematocrit = 0.1527"), by_count, 0.01 * by_count);
}

}  // namespace
}  // namespace tt
