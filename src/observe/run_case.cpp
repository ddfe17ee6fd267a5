#include "observe/run_case.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "observe/case_run.hpp"
#include "observe/failure.hpp"
#include "observe/status.hpp"
#include "observe/summary.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "simulation/stop.hpp"

// The loop of a session, and how it ends.

namespace tt {

/// Of a state that has been examined, as every one is that `start` or `run_steps` leaves.
void CaseRun::save_checkpoint(Durability durability) {
    const std::function<void()> last_look = [this] { observers_.observe_others(model_, state_); };
    checkpoints_.save(state_, observers_, record_.wall_seconds(), durability,
                      at_end() ? last_look : std::function<void()>());
    checkpoint_duty_.done();
}

/// Likewise.
void CaseRun::keep_good() { good_.take(state_, observers_, record_.wall_seconds()); }

void CaseRun::attend_to_duties() {
    if (progress_duty_.due()) {
        record_.show_progress(state_, checkpoints_.saved_step());
        progress_duty_.done();
    }
    if (status_duty_.due()) {
        if (!std::exchange(length_told_, true)) record_.tell_length(state_);
        record_.show_status(state_, checkpoints_.saved_step());
        status_duty_.done();
    }
    if (checkpoint_duty_.due()) {
        save_checkpoint();
        keep_good();
    } else if (good_.due(state_.step)) {
        keep_good();
    }
}

void CaseRun::loop() {
    while (!at_stop() && !stop_requested() && !time_limit_.due()) {
        const std::int64_t until =
            std::min({stop_, good_.next(), observers_.next_after(state_.step)});
        const auto wake = std::min({status_duty_.next(), progress_duty_.next(),
                                    checkpoint_duty_.next(), time_limit_.next(), good_.wake()});
        run_steps(model_, state_, exchange_, *health_, until, wake, &step_times_);
        if (state_.step == until) observers_.observe_due(model_, state_);
        attend_to_duties();
    }
}

std::vector<RunCheck> CaseRun::finish() {
    observers_.finish();
    const SummaryInput input = record_.summary_input(state_, step_times_);
    Json summary = summarise(results_.path(), input);
    if (Json changes = recorded_changes(results_.path()); !changes.empty())
        summary["numerics_changed"] = changes;
    write_record("done");
    // The last of all: where it stands, the run is finished and everything else is there.
    write_json(results_.path() / "summary.json", summary, Durability::power);
    record_.say(fmt::format("done: {} steps in {:.1f} s: {:.3g} MLUPS, {} cell-steps/s", steps_,
                            input.wall_seconds, input.mlups,
                            rounded_text(input.cell_steps_per_second, Dimension{}, 3)));
    std::vector<RunCheck> checks = checks_from(summary["checks"]);
    record_.log(describe_checks(checks));
    return checks;
}

/// What to write, tried if there is something to try.
Suggestion CaseRun::advice(const Instability& what) {
    if (!request_.remedies || !good_.any()) return {"", what.cure};
    record_.whisper(
        fmt::format("unstable at step {}; trying what may help, a minute at most", what.step));
    return tried_suggestion(request_.remedies(), {model_, good_.state(), what}, request_.limits,
                            exchange_);
}

/// Leaves failure/, and tells with what was seen where it is. Never masks the error it records.
SimulationError CaseRun::failed(const SimulationError& error) {
    const Instability& what = error.instability();
    const auto tell = [&](const Suggestion& advice) {
        return tell_failure(results_.path(), what, advice, good_, model_.scales.time);
    };
    try {
        keep_states(results_.path(), request_.name, model_, state_, good_);
        tell({"", what.cure});  // the search for something better may be cut off
        write_record("failed");
        const SimulationError told = tell(advice(what));
        record_.log(told.what());
        return told;
    } catch (const IoError& second) {
        record_.whisper(fmt::format("the failure could not be recorded: {}", second.what()));
        return error;
    }
}

RunOutcome CaseRun::outcome(RunOutcome::Ending ending, std::vector<RunCheck> checks) const {
    return {ending,           state_.step, steps_, state_hash(state_), record_.wall_seconds(),
            std::move(checks)};
}

RunOutcome CaseRun::run(const std::function<State()>& initial) {
    try {
        if (auto finished = open(initial)) return *std::move(finished);
        loop();
        if (checkpoints_.saved_step() != state_.step)
            save_checkpoint(at_end() ? Durability::power : Durability::process);
        if (!at_end()) {
            write_record("stopped");
            record_.say(fmt::format("stopped at step {} of {}; the same command resumes",
                                    state_.step, steps_));
            return outcome(RunOutcome::Ending::stopped);
        }
        return outcome(RunOutcome::Ending::done, finish());
    } catch (const SimulationError& error) {
        throw failed(error);
    } catch (const IoError& error) {
        if (const auto place = results_.lies_elsewhere())
            throw IoError(
                fmt::format("'{}' was moved while the run wrote to it, to '{}'; resume it there",
                            request_.directory.string(), place->string()));
        throw;
    }
}

RunOutcome run_case(const RunRequest& request, const Model& model,
                    const std::function<State()>& initial, Exchange& exchange) {
    catch_stop_signals();
    return CaseRun(request, model, exchange).run(initial);
}

}  // namespace tt
