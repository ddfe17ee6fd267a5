#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "observe/progress.hpp"
#include "observe/provenance.hpp"
#include "observe/remedy.hpp"
#include "observe/results_directory.hpp"
#include "simulation/health.hpp"

namespace tt {

/// All that a run into a results directory needs beside the Model. SI.
struct RunRequest {
    std::filesystem::path directory;
    std::string name;
    std::string case_toml;          ///< as given
    std::string resolved_toml;      ///< every default and derived number
    std::vector<InputFile> inputs;  ///< what else the case was read from
    std::string settings;           ///< all of it, a line `table.key = value` each
    std::string command_line;
    std::vector<std::string> notes;  ///< on what was read: told as a run starts
    Time end;
    Time average_from;                   ///< start of the averaging window, which ends with the run
    std::optional<Time> series, frames;  ///< intervals; else as so far, or 1/500 and 1/50 of `end`
    std::optional<Time> fields;    ///< of the fields in frames; infinite: in none; else in each
    bool compress = false;         ///< frames
    Time checkpoint{300.0};        ///< wall clock
    std::optional<Time> max_time;  ///< wall clock of this session
    std::optional<Time> until;     ///< simulated time at which this session stops, before the end
    ProgressMode progress = ProgressMode::automatic;
    Start start = Start::resume;
    HealthLimits limits;
    std::optional<double> shear_number;             ///< G (Eq. 19), for summary.json
    std::function<std::vector<Remedy>()> remedies;  ///< to try if it blows up
};

}  // namespace tt
