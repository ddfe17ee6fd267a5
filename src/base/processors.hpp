#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tt {

/// How many processors this process may use at once: those of its affinity (taskset, Slurm,
/// containers), and no more than the smallest quota of its control groups allows, rounded up. At
/// least 1. The machine may have more: std::thread::hardware_concurrency().
int usable_processors();

/// How many of `usable` processors a step of so many sites and membrane nodes can use: each thread
/// gets at least as much to do as pays for waiting for the others: 3000 sites or 60 nodes,
/// measured on two cores (docs/performance.md). At least 1.
int threads_for(std::int64_t sites, std::int64_t nodes, int usable);

/// The smallest quota of processors, rounded up, among control groups of `cpu`. Version 2 keeps it
/// in cpu.max, version 1 in cpu.cfs_quota_us and cpu.cfs_period_us. 0: none has one.
int processors_by_quota(const std::vector<std::filesystem::path>& groups);

}  // namespace tt
