#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/run_pool.hpp"
#include "case/sweep_plan.hpp"
#include "observe/sweep_record.hpp"

namespace tt {

/// A run of a sweep and where its results are, or will be.
struct SweepRun {
    const PlannedRun* plan = nullptr;
    Choice choice;
    std::string settings;             ///< by which a directory knows it, but for its name
    std::filesystem::path directory;  ///< below runs/, or where a run of the same case was found
};

/// Whether runs that others made count.
enum class Found { used, ignored };

/// The runs of a plan in the directory of a sweep. A run of the same case that is finished in
/// another directory beside that of the sweep, or in runs/ of one, is found. Throws CaseError for
/// cases that leave no choice of numerics or do not fit into memory, DirectoryInUse if a directory
/// holds results of another case. `watch` is told how many were looked at: with walls each takes a
/// second. StoppedEarly at a stop.
std::vector<SweepRun> locate_runs(const SweepPlan& plan, const std::filesystem::path& directory,
                                  Found found, const std::function<void(int)>& watch);

/// How it stands, from what is in its directory.
RunEnding ending_of(const SweepRun& run);

/// Throws CaseError with all that speaks against the runs that have not begun: cells that do not
/// fit, numerics that blow up. `watch` is told how many were judged. StoppedEarly at a stop.
void judge_new_runs(const std::vector<SweepRun>& runs, const std::function<void(int)>& watch);

/// As the sweep's directory keeps them.
SweepRecord record_of(const SweepPlan& plan, const std::vector<SweepRun>& runs,
                      const std::filesystem::path& directory);

}  // namespace tt
