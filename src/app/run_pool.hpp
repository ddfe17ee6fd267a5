#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace tt {

/// A run to make, on one thread, into a directory of its own.
struct Job {
    std::filesystem::path directory;
    Case c;
};

/// How a pool of runs stands.
struct PoolStanding {
    int done = 0, runs = 0;     ///< of the jobs given
    double seconds_left = 0.0;  ///< at the pace so far; NaN while there is none
};

/// What a run left in its directory.
enum class JobEnd { none, done, unstable };
JobEnd end_of(const std::filesystem::path& directory);

/// The first line of what a run said as it failed.
std::string failure_of(const std::filesystem::path& directory);

/// Makes the runs that have not ended yet, `at_once` side by side, each in a process of its own, so
/// that one that crashes takes none with it. A run that was stopped goes on where it was; one that
/// turns out unstable is an answer like another. Shows how it goes every `interval` seconds.
/// Returns exit_code::done once every run has ended, stopped_early if a signal asked to stop, or
/// the exit code of a run that went wrong otherwise; the others are stopped first, such that they
/// can go on.
int run_side_by_side(std::span<const Job> jobs, int at_once, const std::string& command_line,
                     double interval, const std::function<void(const PoolStanding&)>& show);

}  // namespace tt
