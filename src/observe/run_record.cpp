#include "observe/run_record.hpp"

#include <utility>

#include <fmt/format.h>

#include "observe/places.hpp"
#include "observe/run_measures.hpp"
#include "observe/status.hpp"
#include "simulation/state_archive.hpp"

namespace tt {

RunRecord::RunRecord(const RunRequest& request, const std::filesystem::path& results,
                     const Model& model, std::int64_t steps)
    : request_(request),
      results_(results),
      model_(model),
      steps_(steps),
      progress_(request.progress),
      log_(results / "run.log", OutputFile::Mode::append) {
    session_.started = utc_now();
    session_.ending = "running";
}

void RunRecord::log(const std::string& message) {
    log_.append(fmt::format("{} {}{}", utc_now(), message, message.ends_with('\n') ? "" : "\n"));
}

void RunRecord::say(const std::string& message) {
    log(message);
    progress_.say(message);
}

void RunRecord::begin(std::int64_t step, double earlier_seconds) {
    session_.from_step = step;
    session_.from_time = static_cast<double>(step) * model_.scales.time;
    earlier_seconds_ = earlier_seconds;
    pace_.emplace(step);
}

void RunRecord::change(std::vector<SettingChange> changes) {
    session_.changes = std::move(changes);
}

void RunRecord::write_case() const {
    replace_file(results_ / "case.toml", request_.case_toml, Durability::power);
    keep_inputs(results_, request_.inputs);
    write_places(results_, model_);
    replace_file(results_ / "resolved.toml", request_.resolved_toml, Durability::power);
}

Standing RunRecord::standing(const State& state, std::int64_t checkpoint_step) {
    pace_->update(state.step);
    const bool at_end = state.step >= steps_;
    Standing now;
    now.name = request_.name;
    now.step = state.step;
    now.steps = steps_;
    now.time = static_cast<double>(state.step) * model_.scales.time;
    now.end = request_.end.si;
    now.wall_seconds = wall_seconds();
    now.steps_per_second = at_end ? pace_->mean_rate(state.step) : pace_->steps_per_second();
    now.mlups = now.steps_per_second * model_.open_area() * 1e-6;
    now.seconds_left =
        at_end ? 0.0 : static_cast<double>(steps_ - state.step) / now.steps_per_second;
    now.lambda_C = mean_extension(state.cells);
    now.checkpoint_step = checkpoint_step;
    now.cells = state.cells.cell_count();
    now.threads = model_.threads;
    now.dx = model_.scales.length;
    return now;
}

void RunRecord::write(const std::string& phase, const State& state, std::int64_t checkpoint_step) {
    session_.to_step = state.step;
    session_.wall_seconds = pace_->seconds();
    session_.ending = phase;
    const Provenance provenance{request_.name,          request_.settings,     request_.case_toml,
                                request_.resolved_toml, request_.command_line, model_.threads,
                                request_.inputs};
    write_provenance(results_, provenance, session_, hexadecimal(state_hash(state)));
    write_status(results_, standing(state, checkpoint_step), phase);
}

void RunRecord::show_status(const State& state, std::int64_t checkpoint_step) {
    try {
        write_status(results_, standing(state, checkpoint_step), "running");
        status_failed_ = false;
    } catch (const IoError& error) {
        if (!std::exchange(status_failed_, true))
            say(fmt::format("the run goes on without it: {}", error.what()));
    }
}

void RunRecord::show_progress(const State& state, std::int64_t checkpoint_step) {
    progress_.show(standing(state, checkpoint_step));
}

void RunRecord::tell_length(const State& state) {
    const double left = static_cast<double>(steps_ - state.step) / pace_->mean_rate(state.step);
    if (takes_long(left)) say(remark_on_length(left));
}

SummaryInput RunRecord::summary_input(const State& state, const StepTimes& step_times) const {
    SummaryInput input;
    input.window = {request_.average_from, Time{static_cast<double>(steps_) * model_.scales.time}};
    input.dx = Length{model_.scales.length};
    input.mirror_height = mirror_height(model_);
    for (const CellKind& kind : model_.kinds) input.kinds.push_back(kind.name);
    input.one_way = model_.port_names.empty();
    input.shear_rate = Rate{model_.shear_rate / model_.scales.time};
    if (model_.drive.hold_mean_velocity) input.held_rate = input.shear_rate;
    input.shear_number = request_.shear_number;
    input.wall_seconds = wall_seconds();
    const double rate = static_cast<double>(steps_) / input.wall_seconds;
    input.mlups = rate * model_.open_area() * 1e-6;
    input.cell_steps_per_second = rate * state.cells.cell_count();
    input.steps = steps_;
    input.threads = model_.threads;
    input.session = {state.step - session_.from_step, pace_->seconds(), step_times.seconds()};
    return input;
}

}  // namespace tt
