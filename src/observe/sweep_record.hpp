#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "io/json.hpp"

namespace tt {

/// How a run of a sweep stands.
enum class RunEnding { waiting, stopped, failed, done };
std::string word_of(RunEnding ending);

/// A run of a sweep as its directory keeps it.
struct SweptRun {
    std::string name;
    std::filesystem::path directory;  ///< from that of the sweep; elsewhere: it was found
    std::vector<std::string> values;  ///< of the swept keys, as people write them
    RunEnding ending = RunEnding::waiting;
    std::string why;  ///< of one that failed
};

/// A sweep as its directory keeps it: sweep.json.
struct SweepRecord {
    std::string name;
    std::string case_file;
    std::vector<std::vector<std::string>> axes;  ///< the keys that each changes
    std::vector<SweptRun> runs;

    std::vector<std::string> keys() const;  ///< of all axes, in their order
};

/// Swept keys as directories and figures name them: the last word, or all of a key where two end
/// alike.
std::vector<std::string> short_keys(const std::vector<std::string>& keys);

/// The values of key number `key` as numbers of one dimension; nothing if one of them is none.
struct SweptNumbers {
    Dimension dimension;
    std::vector<double> si;  ///< a run each
};
std::optional<SweptNumbers> numbers_of(const SweepRecord& sweep, std::size_t key);

/// A mean of a run's summary.json that a table can have: no time on the clock is among them.
struct SummaryMean {
    std::string name;
    std::string unit;             ///< empty: dimensionless
    double mean = 0.0;            ///< NaN where it is not defined
    double standard_error = 0.0;  ///< NaN where it is not known
};
std::vector<SummaryMean> summary_means(const std::filesystem::path& results);

/// Names of the checks that a finished run raises; "numerics_changed" of one that blew up and went
/// on with others.
std::vector<std::string> raised_checks(const std::filesystem::path& results);

/// Writes sweep.json and table.csv: a row a run, with swept keys, ending, checks raised, and every
/// mean with its standard error. Both follow from the runs alone, whatever stops there were.
void write_sweep(const std::filesystem::path& directory, const SweepRecord& sweep);

bool is_sweep(const std::filesystem::path& directory);

/// What sweep.json says. IoError if it is not there, or damaged.
SweepRecord read_sweep_record(const std::filesystem::path& directory);

/// "12 of 30 runs done, 1 failed, 17 to do", and a line for each that failed.
std::string describe_sweep(const SweepRecord& sweep);

}  // namespace tt
