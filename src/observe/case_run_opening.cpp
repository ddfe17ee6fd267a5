#include "observe/case_run.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/units.hpp"
#include "observe/failure.hpp"
#include "observe/same_case.hpp"
#include "observe/status.hpp"
#include "observe/take_up.hpp"
#include "simulation/state_archive.hpp"

// How a session opens: at the start of a run, where an earlier one stopped, or after a blow-up.

namespace tt {

namespace fs = std::filesystem;

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

/// The outcome, if the run is at its end already and everything is there.
std::optional<RunOutcome> CaseRun::open(const std::function<State()>& initial) {
    const auto tell = [this](const std::string& message) { record_.say(message); };
    const bool failed_before = has_failed(results_.path());
    auto archive = failed_before
                       ? std::optional(changed_after_failure())
                       : checkpoints_.newest(tell, [this](ArchiveReader& found) { load(found); });
    const std::int64_t step =
        archive ? state_.step : whole_number_of(recorded_status(results_.path()), "step", -1);
    const bool apart = archive && frames_stay_apart(results_.path());
    if (step == steps_ && is_finished(results_.path(), request_) && !apart) {
        std::vector<RunCheck> checks = read_checks(results_.path());
        if (archive) return outcome(RunOutcome::Ending::was_done, std::move(checks));
        return RunOutcome{RunOutcome::Ending::was_done, steps_, steps_, 0, 0.0, std::move(checks)};
    }
    if (!archive) {
        expect_nothing_to_lose(results_.path(), request_, checkpoints_);
        start(initial);
        return std::nullopt;
    }
    resume(*archive);
    archive.reset();
    if (failed_before) leave_failure_behind();
    keep_good();
    return std::nullopt;
}

}  // namespace tt
