#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep_runs.hpp"

namespace tt {

/// Runs of a sweep as commands for engines of others, a line each: "tanktread run …". Each run is
/// that of the sweep, which finds it when it is finished, or goes on with it.
std::string commands_of(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                        const std::filesystem::path& directory);

/// Writes commands.txt and returns the line that GNU parallel is called with, `at_once` side by
/// side.
std::string write_parallel(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                           const std::filesystem::path& directory, int at_once);

/// Writes commands.txt and slurm.sh, a job array of which each task makes a run, or several of more
/// than a thousand, and slurm-report.sh, which makes table and page after it. A task is stopped two
/// minutes before its limit, is put into the queue again and goes on. `minutes`: of a task at most.
/// Returns the lines that hand them in.
std::string write_slurm(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                        const std::filesystem::path& directory, int minutes);

}  // namespace tt
