#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace tt {

/// How many processors this process may use at once: those of its affinity (taskset, Slurm,
/// containers), and no more than the smallest quota of its control groups allows, rounded up. At
/// least 1. The machine may have more: std::thread::hardware_concurrency().
int usable_processors();

/// How many of `usable` processors a step of so many sites and membrane nodes can use: each thread
/// gets at least as much to do as pays for waiting for the others: 10 000 sites or 200 nodes,
/// measured on two cores (docs/performance.md). At least 1.
int threads_for(std::int64_t sites, std::int64_t nodes, int usable);

/// The smallest quota of processors, rounded up, of the control groups in `membership` (the text of
/// /proc/self/cgroup) and those above them, under `mount` (/sys/fs/cgroup). Version 2 keeps it in
/// cpu.max, version 1 in cpu.cfs_quota_us and cpu.cfs_period_us. 0: no quota.
int processors_by_quota(const std::filesystem::path& mount, std::string_view membership);

}  // namespace tt
