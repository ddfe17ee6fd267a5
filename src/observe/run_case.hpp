#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exchange/exchange.hpp"
#include "observe/checks.hpp"
#include "observe/progress.hpp"
#include "observe/provenance.hpp"
#include "observe/remedy.hpp"
#include "observe/results_directory.hpp"
#include "simulation/health.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

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

struct RunOutcome {
    enum class Ending { done, was_done, stopped };
    Ending ending = Ending::done;
    std::int64_t step = 0;
    std::int64_t steps = 0;
    std::uint64_t state_hash = 0;  ///< 0 where no checkpoint was left to read it from
    double wall_seconds = 0.0;     ///< all sessions together
    std::vector<RunCheck> checks;  ///< of a run that is done
};

/// Runs the case into its results directory, or goes on with it, until its end, a signal,
/// `until` or the time limit; leaves the directory such that the same call goes on, to the same
/// bits as if it had never stopped. A call with a later end makes a finished run longer; rows and
/// frames that are there stay, later ones come as it asks. `initial` is called only for a run that
/// starts. Throws SimulationError (last good state in failure/), DirectoryInUse, IoError.
RunOutcome run_case(const RunRequest& request, const Model& model,
                    const std::function<State()>& initial, Exchange& exchange);

}  // namespace tt
