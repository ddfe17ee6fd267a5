#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/sweep_plan.hpp"

namespace CLI {
class App;
}

namespace tt {

/// What stands after `tanktread sweep`.
struct SweepOptions {
    std::string path;
    std::vector<std::string> over, set;
    std::optional<std::string> directory;
    std::optional<std::string> max_time;
    int jobs = 0;
    std::string progress = "auto";
    bool list = false, gather = false, parallel = false, slurm = false;  // in place of running
    bool retry = false, fresh = false;
};

/// Adds them to the verb, with its help.
void add_sweep_options(CLI::App& verb, SweepOptions& options);

/// The plan from the file of a sweep, the directory of one, which then is where it goes, or a case
/// and axes. Throws as `read_sweep` does, and CommandError.
SweepPlan read_plan(SweepOptions& options);

}  // namespace tt
