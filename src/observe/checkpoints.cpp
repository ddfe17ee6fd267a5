#include "observe/checkpoints.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/version.hpp"
#include "observe/frame_recorder.hpp"
#include "observe/series.hpp"
#include "simulation/state_archive.hpp"

namespace tt {
namespace {

/// Before the names of what the observers remember after their last look.
constexpr const char* after_last_look = "end.";
constexpr const char* last_look_taken = "last_look";

}  // namespace

void put_surroundings(ArchiveOutput& archive, const std::string& settings, double wall_seconds,
                      const Observers& observers) {
    archive.put_text("version", version);
    archive.put_text("settings", settings);
    archive.put_value("wall_seconds", wall_seconds);
    for (const auto& observer : observers) observer->save(archive);
}

Checkpoints::Checkpoints(const std::filesystem::path& results, std::string settings)
    : folder_(results / "checkpoint"), settings_(std::move(settings)) {}

void Checkpoints::save(const State& state, const Observers& observers, double wall_seconds,
                       Durability durability, const std::function<void()>& last_look) {
    make_directory(folder_);
    for (const auto& observer : observers) observer->sync();
    ArchiveBuffer surroundings;
    put_surroundings(surroundings, settings_, wall_seconds, observers);
    if (last_look) {
        surroundings.put_value<std::int64_t>(last_look_taken, 1);
        last_look();
        for (const auto& observer : observers) observer->sync();
        surroundings.enter(after_last_look);
        for (const auto& observer : observers) observer->save(surroundings);
    }
    with_second_try([&] {
        ArchiveWriter archive(current());
        archive.put_all(surroundings);
        save_state(archive, state);
        archive.commit(previous(), durability);
    });
    saved_step_ = state.step;
}

void Checkpoints::expect_sound(ArchiveReader& archive, const State& state) {
    const auto seconds = archive.value<double>("wall_seconds");
    if (!(seconds >= 0.0) || !std::isfinite(seconds))
        throw DamagedArchive(
            fmt::format("the checkpoint cannot be loaded: its run took {} s", seconds));
    const bool has_last = archive.has(last_look_taken);
    for (const char* prefix : {"", after_last_look}) {
        if (prefix == after_last_look && !has_last) continue;
        archive.enter(prefix);
        Series::examine(archive, state);
        FrameRecorder::examine(archive);
    }
    archive.enter("");
}

void Checkpoints::resume(ArchiveReader& archive, const Observers& observers, bool at_end) {
    const auto step = archive.value<std::int64_t>("step");
    const bool has_last = archive.has(last_look_taken);
    for (const auto& observer : observers) {
        // The last look is dropped, unless it is where it is due by now.
        const bool keep = at_end || observer->schedule().due(step);
        archive.enter(has_last && keep ? after_last_look : "");
        observer->resume(archive);
    }
    archive.enter("");
}

std::optional<ArchiveReader> Checkpoints::newest(const std::function<void(const std::string&)>& say,
                                                 const std::function<void(ArchiveReader&)>& load) {
    std::string faults;
    const auto pass_over = [&](const std::filesystem::path& path, const std::exception& error) {
        // Out of the way, or the next save would keep it as the previous one.
        move_into_place(path, damaged(), Durability::power);
        say(fmt::format("checkpoint passed over: {}", error.what()));
        faults += std::string(error.what()) + '\n';
    };
    for (const auto& path : {current(), previous()}) {
        if (!std::filesystem::exists(path)) continue;
        std::optional<ArchiveReader> archive;
        try {
            archive.emplace(path);
            load(*archive);
        } catch (const DamagedArchive& error) {
            pass_over(path, error);
            continue;
        } catch (const IoError& error) {
            if (archive) throw;  // of something else than this file
            pass_over(path, error);
            continue;
        }
        sync_file(path);  // the next one makes it the previous
        saved_step_ = archive->value<std::int64_t>("step");
        return archive;
    }
    if (faults.empty()) return std::nullopt;
    throw DamagedArchive(
        fmt::format("{}no sound checkpoint is left; 'run --fresh' starts anew and keeps the old "
                    "directory beside it",
                    faults));
}

bool Checkpoints::exist() const {
    namespace fs = std::filesystem;
    return fs::exists(current()) || fs::exists(previous()) || fs::exists(damaged());
}

}  // namespace tt
