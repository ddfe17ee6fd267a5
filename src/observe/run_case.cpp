#include "observe/run_case.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "observe/checkpoints.hpp"
#include "observe/duty.hpp"
#include "observe/failure.hpp"
#include "observe/last_good.hpp"
#include "observe/observers.hpp"
#include "observe/run_record.hpp"
#include "observe/same_case.hpp"
#include "observe/status.hpp"
#include "observe/summary.hpp"
#include "observe/take_up.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// One session of a run: opening the directory, the loop, the ending.
class CaseRun {
public:
    CaseRun(const RunRequest& request, const Model& model, Exchange& exchange);

    RunOutcome run(const std::function<State()>& initial);

private:
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

CaseRun::CaseRun(const RunRequest& request, const Model& model, Exchange& exchange)
    : request_(request),
      model_(model),
      exchange_(exchange),
      steps_(steps_until(request.end.si, model.scales.time)),
      stop_(request.until ? std::min(steps_, steps_until(request.until->si, model.scales.time))
                          : steps_),
      results_(request.directory, request.start),
      checkpoints_(results_.path(), request.settings),
      good_(steps_, request.settings),
      record_(request, results_.path(), model, steps_),
      status_duty_(2.0),
      progress_duty_(record_.progress_interval()),
      checkpoint_duty_(request.checkpoint.si),
      time_limit_(request.max_time ? request.max_time->si
                                   : std::numeric_limits<double>::infinity()) {
    if (!results_.moved_to().empty())
        record_.say(fmt::format("moved the former results to '{}'", results_.moved_to().string()));
}

void CaseRun::set_observers(Time series, Time frames) {
    observers_ = observers_of(request_, results_.path(), series, frames, model_, state_,
                              [this](const std::string& message) { record_.say(message); });
}

void CaseRun::start(const std::function<State()>& initial) {
    try {
        state_ = initial();
    } catch (...) {  // refused
        results_.withdraw();
        throw;
    }
    record_.begin(state_.step);
    write_record("running");
    record_.write_case();
    record_.say(fmt::format("'{}': {} steps on {} x {} sites, {} cell{}, {} thread{}",
                            request_.name, steps_, model_.lattice.nx, model_.lattice.ny,
                            state_.cells.cell_count(), state_.cells.cell_count() == 1 ? "" : "s",
                            model_.threads, model_.threads == 1 ? "" : "s"));
    for (const std::string& note : request_.notes) record_.say(note);
    set_observers(request_.series.value_or(Time{request_.end.si / 500.0}),
                  request_.frames.value_or(Time{request_.end.si / 50.0}));
    observers_.start();
    health_.emplace(request_.limits, state_);
    if (auto fault = health_->examine(model_, state_)) throw SimulationError(*fault);
    observers_.observe_due(model_, state_);
    save_checkpoint();
    keep_good();
}

/// DamagedArchive if the state cannot be gone on with, DirectoryInUse if it is of another case.
void CaseRun::load(ArchiveReader& archive) {
    expect_same_case(request_.directory, archive.text("settings"), request_.settings);
    use(archive);
}

/// The last good state of a run that blew up, with numerics that differ from those it failed with.
ArchiveReader CaseRun::changed_after_failure() {
    const fs::path path = failure_folder(results_.path()) / "last_good";
    if (!fs::exists(path)) refuse_to_repeat(results_.path());
    ArchiveReader archive(path);
    record_.change(
        changed_numerics(request_.directory, archive.text("settings"), request_.settings));
    if (record_.session().changes.empty()) refuse_to_repeat(results_.path());
    use(archive);
    return archive;
}

/// The state as it was kept, in the units of this session's time step.
void CaseRun::use(ArchiveReader& archive) {
    state_ = take_up(archive, model_, exchange_);
    health_.emplace(request_.limits, state_);
    if (const auto fault = health_->examine(model_, state_))
        throw DamagedArchive(
            fmt::format("the checkpoint holds a state that is {}", SimulationError(*fault).what()));
    if (state_.step > steps_)
        throw DirectoryInUse(fmt::format(
            "the results in '{}' are at {} already, beyond the end asked for, {}; choose another "
            "directory with -o, or move them aside with --fresh",
            request_.directory.string(), to_text(time_of(state_.step)), to_text(request_.end)));
    record_.begin(state_.step, archive.value<double>("wall_seconds"));
}

/// Goes on with the state that `load` took from there.
void CaseRun::resume(ArchiveReader& archive) {
    // Left by an earlier end, where the end or something else was changed since.
    fs::remove(results_.path() / "summary.json");
    if (archive.text("settings") != request_.settings) record_.write_case();
    const Time series{archive.value<double>("series.interval")};
    const Time frames{archive.value<double>("frames.interval")};
    set_observers(request_.series.value_or(series), request_.frames.value_or(frames));
    state_.step = step_apart_from_looks(archive, model_, observers_, state_.step);
    Checkpoints::resume(archive, observers_, at_end());
    write_record("running");
    record_.say(fmt::format("resumed at step {} of {}", state_.step, steps_));
    tell_cadence("rows of series.csv and cells.csv", series, request_.series);
    tell_cadence("frames", frames, request_.frames);
}

/// The changed run has a checkpoint of its own; what failed is history.
void CaseRun::leave_failure_behind() {
    save_checkpoint();
    retire_failure(results_.path());
    for (const SettingChange& change : record_.session().changes)
        record_.say(fmt::format("numerics changed at step {}, t = {:.6g} ms: {} = {}, before {}",
                                state_.step, 1e3 * record_.session().from_time, change.key,
                                change.after, change.before));
}

void CaseRun::tell_cadence(const char* what, Time before, std::optional<Time> asked) {
    if (!asked || *asked == before) return;
    record_.say(fmt::format("from here on {} come every {}, before every {}; averages count rows",
                            what, to_text(*asked), to_text(before)));
}

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
    const auto tell = [this](const std::string& message) { record_.say(message); };
    const bool failed_before = has_failed(results_.path());
    try {
        auto archive = failed_before ? std::optional(changed_after_failure())
                                     : checkpoints_.newest(
                                           tell, [this](ArchiveReader& found) { load(found); });
        const std::int64_t step =
            archive ? state_.step
                    : recorded_status(results_.path()).value("step", std::int64_t{-1});
        if (step == steps_ && is_finished(results_.path(), request_)) {
            std::vector<RunCheck> checks = read_checks(results_.path());
            return archive ? outcome(RunOutcome::Ending::was_done, std::move(checks))
                           : RunOutcome{RunOutcome::Ending::was_done,
                                        steps_,
                                        steps_,
                                        0,
                                        0.0,
                                        std::move(checks)};
        }
        if (archive) {
            resume(*archive);
            archive.reset();
            if (failed_before) leave_failure_behind();
            keep_good();
        } else {
            expect_nothing_to_lose(results_.path(), request_, checkpoints_);
            start(initial);
        }
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

}  // namespace

RunOutcome run_case(const RunRequest& request, const Model& model,
                    const std::function<State()>& initial, Exchange& exchange) {
    catch_stop_signals();
    return CaseRun(request, model, exchange).run(initial);
}

}  // namespace tt
