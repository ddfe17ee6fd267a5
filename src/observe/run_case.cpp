#include "observe/run_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "observe/checkpoints.hpp"
#include "observe/duty.hpp"
#include "observe/failure.hpp"
#include "observe/frame_recorder.hpp"
#include "observe/last_good.hpp"
#include "observe/profile_average.hpp"
#include "observe/provenance.hpp"
#include "observe/run_measures.hpp"
#include "observe/same_case.hpp"
#include "observe/series.hpp"
#include "observe/status.hpp"
#include "observe/summary.hpp"
#include "simulation/derive.hpp"
#include "simulation/rescale.hpp"
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
    void log(const std::string& message);
    void say(const std::string& message);
    void add_observers(Time series, Time frames);
    void start(const std::function<State()>& initial);
    void load(const ArchiveReader& archive);
    void take(const ArchiveReader& archive);
    ArchiveReader changed_after_failure();
    void leave_failure_behind();
    void resume(ArchiveReader& archive);
    double time_step_of(const ArchiveReader& archive) const;
    void keep_looks_apart(const ArchiveReader& archive);
    void tell_cadence(const char* what, Time before, std::optional<Time> asked);
    void expect_nothing_to_lose() const;
    bool was_done(std::int64_t step) const;
    void write_case() const;

    void loop();
    void observe();
    void take_last_look();
    void attend_to_duties();
    void save_checkpoint();
    void keep_good();
    void finish();
    Suggestion advice(const Instability& what);
    SimulationError failed(const SimulationError& error);

    bool at_end() const { return state_.step >= steps_; }
    bool at_stop() const { return state_.step >= stop_; }
    Time time_of(std::int64_t step) const {
        return Time{static_cast<double>(step) * model_.scales.time};
    }
    Standing standing();
    void record(const std::string& phase);
    void show_status();
    double wall_seconds() const { return earlier_seconds_ + pace_->seconds(); }
    RunOutcome outcome(RunOutcome::Ending ending) const;

    const RunRequest& request_;
    const Model& model_;
    Exchange& exchange_;
    const std::int64_t steps_;
    const std::int64_t stop_;  ///< the step at which this session stops
    ResultsDirectory results_;
    Checkpoints checkpoints_;
    LastGood good_;
    Progress progress_;
    OutputFile log_;
    State state_;
    Observers observers_;
    std::optional<Health> health_;
    std::optional<Pace> pace_;
    StepTimes step_times_;
    Session session_;
    double earlier_seconds_ = 0.0;
    bool status_failed_ = false;
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
      progress_(request.progress),
      log_(results_.path() / "run.log", OutputFile::Mode::append),
      status_duty_(2.0),
      progress_duty_(progress_.interval()),
      checkpoint_duty_(request.checkpoint.si),
      time_limit_(request.max_time ? request.max_time->si
                                   : std::numeric_limits<double>::infinity()) {
    session_.started = utc_now();
    session_.ending = "running";
    if (!results_.moved_to().empty())
        say(fmt::format("moved the former results to '{}'", results_.moved_to().string()));
}

void CaseRun::log(const std::string& message) {
    log_.append(fmt::format("{} {}\n", utc_now(), message));
}

void CaseRun::say(const std::string& message) {
    log(message);
    progress_.say(message);
}

void CaseRun::add_observers(Time series, Time frames) {
    const double dt = model_.scales.time;
    const Schedule looks(series.si, dt);
    const fs::path& path = results_.path();
    const auto tell = [this](const std::string& message) { say(message); };
    observers_.push_back(std::make_unique<Series>(looks, path));
    observers_.push_back(
        std::make_unique<ProfileAverage>(looks, path, request_.average_from, model_, tell));
    FramesHeader header = frames_header(model_, state_, request_.name);
    header.compressed = request_.compress;
    const Time fields = request_.fields.value_or(frames);
    std::optional<Schedule> with_fields;
    if (std::isfinite(fields.si)) with_fields.emplace(fields.si, dt);
    observers_.push_back(
        std::make_unique<FrameRecorder>(Schedule(frames.si, dt), with_fields, path, header, tell));
}

void CaseRun::start(const std::function<State()>& initial) {
    state_ = initial();
    pace_.emplace(state_.step);
    record("running");
    write_case();
    say(fmt::format("'{}': {} steps on {} x {} sites, {} cell{}, {} thread{}", request_.name,
                    steps_, model_.lattice.nx, model_.lattice.ny, state_.cells.cell_count(),
                    state_.cells.cell_count() == 1 ? "" : "s", model_.threads,
                    model_.threads == 1 ? "" : "s"));
    for (const std::string& note : request_.notes) say(note);
    add_observers(request_.series.value_or(Time{request_.end.si / 500.0}),
                  request_.frames.value_or(Time{request_.end.si / 50.0}));
    for (const auto& observer : observers_) observer->start();
    health_.emplace(request_.limits, state_);
    if (auto fault = health_->examine(model_, state_)) throw SimulationError(*fault);
    for (const auto& observer : observers_) observer->observe(Snapshot(model_, state_));
    save_checkpoint();
    keep_good();
}

/// DamagedArchive if the state cannot be gone on with, DirectoryInUse if it is of another case.
void CaseRun::load(const ArchiveReader& archive) {
    expect_same_case(request_.directory, archive.text("settings"), request_.settings);
    take(archive);
}

/// The last good state of a run that blew up, with numerics that differ from those it failed with.
ArchiveReader CaseRun::changed_after_failure() {
    const fs::path path = failure_folder(results_.path()) / "last_good";
    if (!fs::exists(path)) refuse_to_repeat(results_.path());
    ArchiveReader archive(path);
    session_.changes =
        changed_numerics(request_.directory, archive.text("settings"), request_.settings);
    if (session_.changes.empty()) refuse_to_repeat(results_.path());
    take(archive);
    return archive;
}

/// The state as it was kept, in the units of this session's time step.
void CaseRun::take(const ArchiveReader& archive) {
    state_ = load_state(archive, model_, exchange_);
    if (const double before = time_step_of(archive); before != model_.scales.time) {
        change_time_step(model_, model_.scales.time / before, state_);
        derive(model_, state_);
    }
    health_.emplace(request_.limits, state_);
    if (const auto fault = health_->examine(model_, state_))
        throw DamagedArchive(
            fmt::format("the checkpoint holds a state that is {}", SimulationError(*fault).what()));
    if (state_.step > steps_)
        throw DirectoryInUse(fmt::format(
            "the results in '{}' are at {} already, beyond the end asked for, {}; choose another "
            "directory with -o, or move them aside with --fresh",
            request_.directory.string(), to_text(time_of(state_.step)), to_text(request_.end)));
    session_.from_step = state_.step;
    session_.from_time = time_of(state_.step).si;
    earlier_seconds_ = archive.value<double>("wall_seconds");
    pace_.emplace(state_.step);
}

/// Goes on with the state that `load` took from there.
void CaseRun::resume(ArchiveReader& archive) {
    // Left by an earlier end, where the end or something else was changed since.
    fs::remove(results_.path() / "summary.json");
    if (archive.text("settings") != request_.settings) write_case();
    const Time series{archive.value<double>("series.interval")};
    const Time frames{archive.value<double>("frames.interval")};
    add_observers(request_.series.value_or(series), request_.frames.value_or(frames));
    keep_looks_apart(archive);
    Checkpoints::resume(archive, observers_, at_end());
    record("running");
    say(fmt::format("resumed at step {} of {}", state_.step, steps_));
    tell_cadence("rows of series.csv and cells.csv", series, request_.series);
    tell_cadence("frames", frames, request_.frames);
}

/// [s] of the state in it.
double CaseRun::time_step_of(const ArchiveReader& archive) const {
    const auto text = setting_in(archive.text("settings"), "chosen.dt");
    return text ? parse_measure(*text).si : model_.scales.time;
}

/// After a change of the time step: what was due and done at the former step must not be due a step
/// later. The state's step is the nearest to its time, or the one after.
void CaseRun::keep_looks_apart(const ArchiveReader& archive) {
    const double dt = time_step_of(archive);
    if (dt == model_.scales.time) return;
    const auto step = archive.value<std::int64_t>("step");
    for (const auto& observer : observers_) {
        const Schedule before(observer->schedule().interval(), dt);
        if (before.due(step))
            state_.step = std::max(state_.step, observer->schedule().counterpart(before, step));
    }
}

/// The changed run has a checkpoint of its own; what failed is history.
void CaseRun::leave_failure_behind() {
    save_checkpoint();
    retire_failure(results_.path());
    for (const SettingChange& change : session_.changes)
        say(fmt::format("numerics changed at step {}, t = {:.6g} ms: {} = {}, before {}",
                        state_.step, 1e3 * session_.from_time, change.key, change.after,
                        change.before));
}

void CaseRun::tell_cadence(const char* what, Time before, std::optional<Time> asked) {
    if (!asked || *asked == before) return;
    say(fmt::format("from here on {} come every {}, before every {}; averages count rows", what,
                    to_text(*asked), to_text(before)));
}

void CaseRun::write_case() const {
    replace_file(results_.path() / "case.toml", request_.case_toml, Durability::power);
    for (const InputFile& input : request_.inputs) {
        make_directory((results_.path() / input.name).parent_path());
        replace_file(results_.path() / input.name, input.bytes, Durability::power);
    }
    replace_file(results_.path() / "resolved.toml", request_.resolved_toml, Durability::power);
}

/// No checkpoint is left. What is there may be what the very start of a run leaves, but must not
/// be results: finished or not, they are of nobody's to write over.
void CaseRun::expect_nothing_to_lose() const {
    const fs::path& path = results_.path();
    if (const auto theirs = recorded_settings(path))
        expect_same_case(request_.directory, *theirs, request_.settings);
    const bool lost = fs::exists(path / "summary.json") || checkpoints_.exist() ||
                      recorded_status(path).value("checkpoint_step", std::int64_t{-1}) >= 0;
    if (lost)
        throw DirectoryInUse(fmt::format(
            "'{}' holds results but no checkpoint to go on from; choose another directory with "
            "-o, or move them aside with --fresh",
            request_.directory.string()));
}

/// Is all there that a run of just these settings leaves? summary.json is the last of it.
bool CaseRun::was_done(std::int64_t step) const {
    return step == steps_ && fs::exists(results_.path() / "summary.json") &&
           recorded_settings(results_.path()) == request_.settings;
}

Standing CaseRun::standing() {
    pace_->update(state_.step);
    Standing now;
    now.name = request_.name;
    now.step = state_.step;
    now.steps = steps_;
    now.time = time_of(state_.step).si;
    now.end = request_.end.si;
    now.wall_seconds = wall_seconds();
    now.steps_per_second = at_end() ? pace_->mean_rate(state_.step) : pace_->steps_per_second();
    now.mlups = now.steps_per_second * model_.lattice.nx * model_.lattice.ny * 1e-6;
    now.seconds_left =
        at_end() ? 0.0 : static_cast<double>(steps_ - state_.step) / now.steps_per_second;
    now.lambda_C = mean_extension(state_.cells);
    now.checkpoint_step = checkpoints_.saved_step();
    now.cells = state_.cells.cell_count();
    now.threads = model_.threads;
    now.dx = model_.scales.length;
    return now;
}

/// status.json and PROVENANCE.json as things stand.
void CaseRun::record(const std::string& phase) {
    session_.to_step = state_.step;
    session_.wall_seconds = pace_->seconds();
    session_.ending = phase;
    const Provenance provenance{request_.name,          request_.settings,     request_.case_toml,
                                request_.resolved_toml, request_.command_line, model_.threads,
                                request_.inputs};
    write_provenance(results_.path(), provenance, session_, hexadecimal(state_hash(state_)));
    write_status(results_.path(), standing(), phase);
}

void CaseRun::observe() {
    const Snapshot snapshot(model_, state_);
    for (const auto& observer : observers_) {
        if (observer->schedule().due(state_.step)) observer->observe(snapshot);
    }
}

/// At the end, of those that are not due there.
void CaseRun::take_last_look() {
    const Snapshot snapshot(model_, state_);
    for (const auto& observer : observers_) {
        if (!observer->schedule().due(state_.step)) observer->observe(snapshot);
    }
}

/// Of a state that has been examined, as every one is that `start` or `run_steps` leaves.
void CaseRun::save_checkpoint() {
    const std::function<void()> last_look = [this] { take_last_look(); };
    checkpoints_.save(state_, observers_, wall_seconds(),
                      at_end() ? last_look : std::function<void()>());
    checkpoint_duty_.done();
}

/// Likewise.
void CaseRun::keep_good() { good_.take(state_, observers_, wall_seconds()); }

/// No run ends for want of it: it is written again in two seconds.
void CaseRun::show_status() {
    try {
        write_status(results_.path(), standing(), "running");
        status_failed_ = false;
    } catch (const IoError& error) {
        if (!std::exchange(status_failed_, true))
            say(fmt::format("the run goes on without it: {}", error.what()));
    }
}

void CaseRun::attend_to_duties() {
    if (progress_duty_.due()) {
        progress_.show(standing());
        progress_duty_.done();
    }
    if (status_duty_.due()) {
        show_status();
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
        std::int64_t until = std::min(stop_, good_.next());
        for (const auto& observer : observers_)
            until = std::min(until, observer->schedule().next_after(state_.step));
        const auto wake = std::min({status_duty_.next(), progress_duty_.next(),
                                    checkpoint_duty_.next(), time_limit_.next(), good_.wake()});
        run_steps(model_, state_, exchange_, *health_, until, wake, &step_times_);
        if (state_.step == until) observe();
        attend_to_duties();
    }
}

void CaseRun::finish() {
    for (const auto& observer : observers_) observer->finish();
    SummaryInput input;
    input.window = {request_.average_from, time_of(steps_)};
    input.dx = Length{model_.scales.length};
    input.mirror_height = mirror_height(model_);
    input.shear_rate = Rate{model_.shear_rate / model_.scales.time};
    if (model_.drive.hold_mean_velocity) input.held_rate = input.shear_rate;
    input.shear_number = request_.shear_number;
    input.wall_seconds = wall_seconds();
    const double rate = static_cast<double>(steps_) / input.wall_seconds;
    input.mlups = rate * model_.lattice.nx * model_.lattice.ny * 1e-6;
    input.cell_steps_per_second = rate * state_.cells.cell_count();
    input.steps = steps_;
    input.threads = model_.threads;
    input.session = {state_.step - session_.from_step, pace_->seconds(), step_times_.seconds()};
    Json summary = summarise(results_.path(), input);
    if (Json changes = recorded_changes(results_.path()); !changes.empty())
        summary["numerics_changed"] = changes;
    record("done");
    // The last of all: where it stands, the run is finished and everything else is there.
    write_json(results_.path() / "summary.json", summary, Durability::power);
    say(fmt::format("done: {} steps in {:.1f} s: {:.3g} MLUPS, {:.3g} cell-steps/s", steps_,
                    input.wall_seconds, input.mlups, input.cell_steps_per_second));
    log_.append(describe_checks(read_checks(results_.path())));
}

/// What to write, tried if there is something to try.
Suggestion CaseRun::advice(const Instability& what) {
    if (!request_.remedies || !good_.any()) return {"", what.cure};
    progress_.say(
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
        record("failed");
        const SimulationError told = tell(advice(what));
        log(told.what());
        return told;
    } catch (const IoError& second) {
        progress_.say(fmt::format("the failure could not be recorded: {}", second.what()));
        return error;
    }
}

RunOutcome CaseRun::outcome(RunOutcome::Ending ending) const {
    RunOutcome result{ending, state_.step, steps_, state_hash(state_), wall_seconds(), {}};
    if (ending != RunOutcome::Ending::stopped) result.checks = read_checks(results_.path());
    return result;
}

RunOutcome CaseRun::run(const std::function<State()>& initial) {
    const auto tell = [this](const std::string& message) { say(message); };
    const bool failed_before = has_failed(results_.path());
    try {
        auto archive =
            failed_before
                ? std::optional(changed_after_failure())
                : checkpoints_.newest(tell, [this](const ArchiveReader& found) { load(found); });
        if (was_done(archive ? state_.step
                             : recorded_status(results_.path()).value("step", std::int64_t{-1}))) {
            return archive ? outcome(RunOutcome::Ending::was_done)
                           : RunOutcome{RunOutcome::Ending::was_done, steps_, steps_, 0, 0.0,
                                        read_checks(results_.path())};
        }
        if (archive) {
            resume(*archive);
            archive.reset();
            if (failed_before) leave_failure_behind();
            keep_good();
        } else {
            expect_nothing_to_lose();
            start(initial);
        }
        loop();
        if (checkpoints_.saved_step() != state_.step) save_checkpoint();
        if (!at_end()) {
            record("stopped");
            say(fmt::format("stopped at step {} of {}; the same command resumes", state_.step,
                            steps_));
            return outcome(RunOutcome::Ending::stopped);
        }
        finish();
        return outcome(RunOutcome::Ending::done);
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
