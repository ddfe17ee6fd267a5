#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "fit/landscape.hpp"
#include "fit/search.hpp"
#include "observe/provenance.hpp"

namespace tt {

/// A case at which something was measured, before D and beta are put into it.
struct Condition {
    Case c;
    std::string label;  ///< what it changes in the base case: "flow.pseudo_shear_rate=150 /s"
};

/// A number to be met: the mean of a quantity of summary.json in one condition. SI.
struct Target {
    std::string quantity;
    std::string unit;  ///< empty: dimensionless
    std::size_t condition = 0;
    Goal goal;
};

/// What `calibrate` is asked for.
struct Targets {
    std::string text;  ///< of the file
    std::string name;
    std::vector<Condition> conditions;  ///< no two the same
    std::vector<Target> targets;
    LogRange D, beta;
    std::vector<std::int64_t> seeds;  ///< of each condition; empty: the case's own
    std::vector<InputFile> inputs;    ///< the case and its outlines, as the results keep them
    SearchLimits limits;
};

/// Reads a file of targets (docs/theory/calibration.md). Overrides in it are written as after --set
/// and follow the rules of the case file. A case that is not where the file says is looked for in
/// `inputs/` beside it, so that the targets of a results directory can be read again. Throws
/// CaseError with every fault of the file, and of the cases it makes; IoError if it cannot be read.
Targets read_targets(const std::filesystem::path& path);

/// The condition with this pair and seed, ready to run. Frames at its beginning and end only: they
/// change no mean, and a calibration makes many runs.
Case case_at(const Condition& condition, double D, double beta, std::int64_t seed);

}  // namespace tt
