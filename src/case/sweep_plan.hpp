#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/sweep_axis.hpp"
#include "observe/provenance.hpp"

namespace tt {

/// One run of a sweep.
struct PlannedRun {
    std::string name;                   ///< of its directory: "shear_number=0.1_seed=2"
    std::vector<std::string> settings;  ///< "flow.shear_number=0.1", as after --set: all of them
    std::vector<std::string> values;    ///< of the swept keys, as people write them
    Case c;
};

/// What `sweep` is asked for.
struct SweepPlan {
    std::string name;
    std::string text;  ///< sweep.toml
    std::filesystem::path case_file;
    std::vector<SweepAxis> axes;
    std::vector<std::string> keys;  ///< swept, in the order of the axes
    std::vector<PlannedRun> runs;   ///< every place of the first axis with every place of the next
    std::vector<InputFile> inputs;  ///< the case and what it names, as the directory keeps them
};

/// At most so many runs.
inline constexpr std::size_t most_runs = 10'000;

/// Reads the file of a sweep (docs/guide/sweeps.md): a case, what is set for every run, and a table
/// [[over]] an axis. `set` comes after what the file sets. A case that is not where the file says
/// is looked for in inputs/ beside it. Throws CaseError with every fault of the file, of the axes
/// and of the cases that they make; IoError if a file cannot be read.
SweepPlan read_sweep(const std::filesystem::path& path, const std::vector<std::string>& set);

/// The same from the command line: a case file and axes as after --over.
SweepPlan sweep_over(const std::filesystem::path& case_file, const std::vector<std::string>& set,
                     const std::vector<std::string>& over);

/// Is it the file of a sweep, and not that of a case?
bool is_sweep_file(const std::string& text);

}  // namespace tt
