#include "observe/failure.hpp"

#include <cmath>

#include <fmt/format.h>

#include "io/frames.hpp"
#include "io/json.hpp"
#include "observe/frame_recorder.hpp"
#include "simulation/derive.hpp"
#include "simulation/state_archive.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

std::string kept_in(const fs::path& folder, const LastGood& good, double dt) {
    std::string text = folder.string() + ": why.txt, the failing state, its picture in frames.h5";
    if (good.any())
        text += fmt::format(", and the last good state, of step {}, t = {:.6g} ms", good.step(),
                            1e3 * dt * static_cast<double>(good.step()));
    return text;
}

Json to_json(const Instability& what) {
    return Json{{"quantity", what.quantity},
                {"value", what.value},
                {"limit", what.limit},
                {"unit", what.unit},
                {"step", what.step},
                {"time", what.time},
                {"cell", what.cell >= 0 ? Json(what.cell) : Json()},
                {"node", what.node >= 0 ? Json(what.node) : Json()},
                {"x", what.x},
                {"y", what.y},
                {"cause", what.cause}};
}

void write_frames(const fs::path& folder, const std::string& name, const Model& model,
                  const LastGood& good, State& failing) {
    FramesWriter frames(folder, frames_header(model, failing, name), {});
    if (good.any()) {
        State before = good.state();
        derive(model, before);
        frames.write(frame_of(Snapshot(model, before)));
    }
    frames.write(frame_of(Snapshot(model, failing)));
    frames.merge();
}

}  // namespace

void keep_states(const fs::path& results, const std::string& name, const Model& model,
                 State& failing, const LastGood& good) {
    const fs::path folder = failure_folder(results);
    fs::remove_all(folder);  // of an earlier attempt that was cut off
    make_directory(folder);
    if (good.any()) good.write(folder / "last_good");
    write_frames(folder, name, model, good, failing);
    ArchiveWriter archive(folder / "failing");
    save_state(archive, failing);
    archive.commit();
}

SimulationError tell_failure(const fs::path& results, const Instability& what,
                             const Suggestion& advice, const LastGood& good, double dt) {
    const fs::path folder = failure_folder(results);
    std::string text = labelled("write", advice.text()) + '\n' +
                       labelled("kept", kept_in(folder, good, dt)) + '\n' +
                       labelled("see", "tanktread report " + results.string());
    if (good.any() && !advice.settings.empty())
        text += '\n' + labelled("go on", fmt::format("tanktread resume {} {}", results.string(),
                                                     advice.settings));
    const SimulationError error(what, text);
    replace_file(folder / "why.txt", std::string(error.what()) + '\n', Durability::power);
    Json record = to_json(what);
    record["advice"] = advice.text();
    record["last_good_step"] = good.any() ? Json(good.step()) : Json();
    write_json(folder / "failure.json", record, Durability::power);
    return error;
}

bool has_failed(const fs::path& results) {
    return fs::exists(failure_folder(results) / "failure.json");
}

void refuse_to_repeat(const fs::path& results) {
    throw FailedBefore(fmt::format(
        "'{0}' failed before, and the same would happen again:\n{1}Go on from the last good state "
        "with other numerics, `tanktread resume {0} --set\nKEY=VALUE`, or begin anew, with another "
        "-o or with --fresh.",
        results.string(), read_file(failure_folder(results) / "why.txt")));
}

void retire_failure(const fs::path& results) {
    const fs::path folder = failure_folder(results);
    int number = 1;
    while (fs::exists(fmt::format("{}.{}", folder.string(), number))) ++number;
    move_into_place(folder, fmt::format("{}.{}", folder.string(), number), Durability::power);
}

}  // namespace tt
