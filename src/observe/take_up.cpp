#include "observe/take_up.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.hpp"
#include "io/file.hpp"
#include "io/frames_format.hpp"
#include "observe/same_case.hpp"
#include "observe/status.hpp"
#include "simulation/derive.hpp"
#include "simulation/rescale.hpp"
#include "simulation/state_archive.hpp"

namespace tt {
namespace {

/// [s] of the state in it.
double time_step_of(const ArchiveReader& archive, const Model& model) {
    const auto text = setting_in(archive.text("settings"), "chosen.dt");
    return text ? parse_measure(*text).si : model.scales.time;
}

/// More than the heading and the row of the start: those come after the first checkpoint.
bool has_rows_of_steps(const std::filesystem::path& table) {
    if (!std::filesystem::exists(table)) return false;
    const std::string text = read_file(table);
    return std::count(text.begin(), text.end(), '\n') > 2;
}

}  // namespace

State take_up(ArchiveReader& archive, const Model& model, Exchange& exchange) {
    State state = load_state(archive, model, exchange);
    Checkpoints::expect_sound(archive, state);
    if (const double before = time_step_of(archive, model); before != model.scales.time) {
        change_time_step(model, model.scales.time / before, state);
        derive(model, state);
    }
    return state;
}

std::int64_t step_apart_from_looks(const ArchiveReader& archive, const Model& model,
                                   const Observers& observers, std::int64_t step) {
    const double dt = time_step_of(archive, model);
    if (dt == model.scales.time) return step;
    const auto former = archive.value<std::int64_t>("step");
    for (const auto& observer : observers) {
        const Schedule before(observer->schedule().interval(), dt);
        if (before.due(former))
            step = std::max(step, observer->schedule().counterpart(before, former));
    }
    return step;
}

void expect_nothing_to_lose(const std::filesystem::path& results, const RunRequest& request,
                            const Checkpoints& checkpoints) {
    if (const auto theirs = recorded_settings(results))
        expect_same_case(request.directory, *theirs, request.settings);
    const bool lost = std::filesystem::exists(results / "summary.json") || checkpoints.exist() ||
                      has_rows_of_steps(results / "series.csv") ||
                      whole_number_of(recorded_status(results), "checkpoint_step", -1) >= 0;
    if (lost)
        throw DirectoryInUse(fmt::format(
            "'{}' holds results but no checkpoint to go on from; choose another directory with "
            "-o, or move them aside with --fresh",
            request.directory.string()));
}

bool frames_stay_apart(const std::filesystem::path& results) {
    try {
        return frames::kind_of(frames::File(results / "frames.h5").id) == frames::Kind::index;
    } catch (const IoError&) {  // not there or damaged: told by whoever reads it
        return false;
    }
}

bool is_finished(const std::filesystem::path& results, const RunRequest& request) {
    return has_summary(results) && recorded_settings(results) == request.settings;
}

}  // namespace tt
