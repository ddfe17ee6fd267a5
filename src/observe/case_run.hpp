#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "observe/checkpoints.hpp"
#include "observe/duty.hpp"
#include "observe/last_good.hpp"
#include "observe/observers.hpp"
#include "observe/remedy.hpp"
#include "observe/results_directory.hpp"
#include "observe/run_case.hpp"
#include "observe/run_record.hpp"
#include "simulation/run.hpp"
#include "simulation/step_times.hpp"

namespace tt {

/// One session of a run: opening the directory, the loop, the ending.
class CaseRun {
public:
    CaseRun(const RunRequest& request, const Model& model, Exchange& exchange);

    RunOutcome run(const std::function<State()>& initial);

private:
    std::optional<RunOutcome> open(const std::function<State()>& initial);
    void set_observers(Time series, Time frames);
    void start(const std::function<State()>& initial);
    void load(ArchiveReader& archive);
    void use(ArchiveReader& archive);
    ArchiveReader changed_after_failure();
    void leave_failure_behind();
    void resume(ArchiveReader& archive);
    void tell_cadence(const char* what, Time before, std::optional<Time> asked);

    void loop();
    void attend_to_duties();
    void save_checkpoint(Durability durability = Durability::power);
    void keep_good();
    std::vector<RunCheck> finish();
    Suggestion advice(const Instability& what);
    SimulationError failed(const SimulationError& error);

    bool at_end() const { return state_.step >= steps_; }
    bool at_stop() const { return state_.step >= stop_; }
    Time time_of(std::int64_t step) const {
        return Time{static_cast<double>(step) * model_.scales.time};
    }
    void write_record(const std::string& phase) {
        record_.write(phase, state_, checkpoints_.saved_step());
    }
    RunOutcome outcome(RunOutcome::Ending ending, std::vector<RunCheck> checks = {}) const;

    const RunRequest& request_;
    const Model& model_;
    Exchange& exchange_;
    const std::int64_t steps_;
    const std::int64_t stop_;  ///< the step at which this session stops
    ResultsDirectory results_;
    Checkpoints checkpoints_;
    LastGood good_;
    RunRecord record_;
    State state_;
    Observers observers_;
    std::optional<Health> health_;
    StepTimes step_times_;
    bool length_told_ = false;
    Duty status_duty_, progress_duty_, checkpoint_duty_, time_limit_;
};

}  // namespace tt
