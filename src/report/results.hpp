#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "io/csv.hpp"
#include "io/frames.hpp"
#include "io/json.hpp"
#include "observe/checks.hpp"

namespace tt {

/// A quantity of summary.json.
struct SummaryLine {
    std::string name;
    std::string unit;  ///< empty: dimensionless
    double mean = 0.0;
    double standard_error = 0.0;           ///< NaN where it is not known
    double sd_time = 0.0, sd_cells = 0.0;  ///< NaN where it does not apply
    std::string reason;                    ///< why there is no mean
};

/// A results directory as a reader meets it. A run that is not finished, or was killed, lacks some
/// of the files; what is not there is empty.
struct Results {
    std::filesystem::path directory;
    std::string name;  ///< of the case
    std::map<std::string, std::string>
        settings;  ///< "flow.drive" → "shear"; from resolved.toml, else case.toml
    Json status, provenance, summary;
    Json places;  ///< of ports and sections (observe/places.hpp)
    std::vector<RunCheck> checks;
    std::vector<SummaryLine> quantities;          ///< averages of the summary, in its order
    double window_begin = 0.0, window_end = 0.0;  ///< of averaging [s]; equal: none
    Table series, cells, profiles, ports, sections;
    std::shared_ptr<const FramesReader> frames;   ///< nullptr: no frames.h5
    Json failure;                                 ///< of a run that blew up; else empty
    std::string why;                              ///< the same in words
    std::shared_ptr<const FramesReader> failing;  ///< its last good and its failing state
    std::vector<std::string> faults;              ///< what is damaged and left out, in words

    /// A setting as its text, or `otherwise`.
    std::string setting(const std::string& key, const std::string& otherwise = "") const;
    bool finished() const { return !summary.empty(); }
};

/// Reads what is there. Throws IoError if the directory does not exist or holds neither a case nor
/// any results, or if one of its JSON or TOML files is damaged.
Results read_results(const std::filesystem::path& directory);

/// The values of a column; empty if the table has no such column.
const std::vector<double>& values(const Table& table, std::string_view name);

/// A length or other number of the settings in SI, from text such as "0.2 um", "75 /s", "1.2 cP" or
/// a bare number. NaN if the text is not one.
double setting_si(const std::string& text);

/// The same of a list, "0 ms, 0.5 ms"; NaN for each that is not a number.
std::vector<double> settings_si(const std::string& list);

/// Mean of a series column over the averaging window, or over the later half of the run if there is
/// no window; NaN if there is no such column.
double window_mean(const Results& results, const std::string& column);

}  // namespace tt
