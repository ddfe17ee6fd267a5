#include "observe/observers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "observe/passages.hpp"
#include "observe/frame_recorder.hpp"
#include "observe/port_series.hpp"
#include "observe/profile_average.hpp"
#include "observe/section_profiles.hpp"
#include "observe/section_series.hpp"
#include "observe/series.hpp"

namespace tt {

void Observers::start() const {
    for (const auto& observer : all_) observer->start();
}

std::int64_t Observers::next_after(std::int64_t step) const {
    std::int64_t next = std::numeric_limits<std::int64_t>::max();
    for (const auto& observer : all_) next = std::min(next, observer->schedule().next_after(step));
    return next;
}

void Observers::observe_due(const Model& model, const State& state) const {
    const Snapshot snapshot(model, state);
    for (const auto& observer : all_)
        if (observer->schedule().due(state.step)) observer->observe(snapshot);
}

void Observers::observe_others(const Model& model, const State& state) const {
    const Snapshot snapshot(model, state);
    for (const auto& observer : all_)
        if (!observer->schedule().due(state.step)) observer->observe(snapshot);
}

void Observers::finish() const {
    for (const auto& observer : all_) observer->finish();
}

Observers observers_of(const RunRequest& request, const std::filesystem::path& results, Time series,
                       Time frames, const Model& model, const State& state,
                       const std::function<void(const std::string&)>& say) {
    const double dt = model.scales.time;
    const Schedule rows(series.si, dt);
    const Time fields = request.fields.value_or(frames);
    std::optional<Schedule> with_fields;
    if (std::isfinite(fields.si)) with_fields.emplace(fields.si, dt);
    FramesHeader header = frames_header(model, state, request.name);
    header.compressed = request.compress;

    Observers observers;
    observers.add(std::make_unique<Series>(rows, results));
    if (model.port_names.empty())
        observers.add(
            std::make_unique<ProfileAverage>(rows, results, request.average_from, model, say));
    else
        observers.add(std::make_unique<PortSeries>(rows, results, model.port_names));
    if (!model.sections.empty()) {
        observers.add(std::make_unique<SectionSeries>(rows, results, model));
        observers.add(
            std::make_unique<SectionProfiles>(rows, results, request.average_from, model, say));
    }
    if (!model.exits.empty()) observers.add(left_cells(rows, results));
    if (!model.feeds.empty()) observers.add(entered_cells(rows, results));
    observers.add(std::make_unique<FrameRecorder>(Schedule(frames.si, dt), with_fields, results,
                                                  header, say));
    return observers;
}

}  // namespace tt
