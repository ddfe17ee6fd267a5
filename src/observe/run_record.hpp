#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "observe/pace.hpp"
#include "observe/progress.hpp"
#include "observe/provenance.hpp"
#include "observe/run_request.hpp"
#include "observe/summary.hpp"
#include "io/file.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// What a run tells of itself while it goes: the terminal, run.log, status.json, PROVENANCE.json
/// and the copies of what it was made from.
class RunRecord {
public:
    RunRecord(const RunRequest& request, const std::filesystem::path& results, const Model& model,
              std::int64_t steps);

    void log(const std::string& message);                                 ///< run.log only
    void say(const std::string& message);                                 ///< and the terminal
    void whisper(const std::string& message) { progress_.say(message); }  ///< the terminal only
    double progress_interval() const { return progress_.interval(); }     ///< wall seconds

    /// This session begins at `step`, with so much wall time spent by former ones.
    void begin(std::int64_t step, double earlier_seconds = 0.0);
    /// It goes on with other numerics than the former ones.
    void change(std::vector<SettingChange> changes);
    const Session& session() const { return session_; }
    double wall_seconds() const { return earlier_seconds_ + pace_->seconds(); }

    /// case.toml, what it was read from, and resolved.toml.
    void write_case() const;
    /// status.json and PROVENANCE.json as things stand. `phase` as in `write_status`.
    void write(const std::string& phase, const State& state, std::int64_t checkpoint_step);
    /// status.json alone. No run ends for want of it: it is written again soon.
    void show_status(const State& state, std::int64_t checkpoint_step);
    void show_progress(const State& state, std::int64_t checkpoint_step);

    /// Says once, at the speed of this session so far, how long a run takes that takes hours.
    void tell_length(const State& state);

    /// What `summarise` needs of a run that is at its end.
    SummaryInput summary_input(const State& state, const StepTimes& step_times) const;

private:
    Standing standing(const State& state, std::int64_t checkpoint_step);

    const RunRequest& request_;
    const std::filesystem::path results_;
    const Model& model_;
    const std::int64_t steps_;
    Progress progress_;
    OutputFile log_;
    std::optional<Pace> pace_;
    Session session_;
    double earlier_seconds_ = 0.0;
    bool status_failed_ = false;
};

}  // namespace tt
