#include "observe/checkpoints.hpp"

#include <utility>

#include <fmt/format.h>

#include "simulation/state_archive.hpp"

namespace tt {

void put_surroundings(ArchiveOutput& archive, const std::string& case_hash, double wall_seconds,
                      const Observers& observers) {
    archive.put_text("case", case_hash);
    archive.put_value("wall_seconds", wall_seconds);
    for (const auto& observer : observers) observer->save(archive);
}

Checkpoints::Checkpoints(const std::filesystem::path& results, std::string case_hash)
    : folder_(results / "checkpoint"), case_hash_(std::move(case_hash)) {}

void Checkpoints::save(const State& state, const Observers& observers, double wall_seconds) {
    make_directory(folder_);
    for (const auto& observer : observers) observer->sync();
    ArchiveWriter archive(current());
    put_surroundings(archive, case_hash_, wall_seconds, observers);
    save_state(archive, state);
    archive.commit(previous());
    saved_step_ = state.step;
}

std::optional<ArchiveReader> Checkpoints::newest(
    const std::function<void(const std::string&)>& say) {
    std::string faults;
    for (const auto& path : {current(), previous()}) {
        if (!std::filesystem::exists(path)) continue;
        std::string fault = fmt::format("'{}' is of another case", path.string());
        try {
            ArchiveReader archive(path);
            if (archive.text("case") == case_hash_) {
                saved_step_ = archive.value<std::int64_t>("step");
                return archive;
            }
        } catch (const DamagedArchive& error) {
            fault = error.what();
            // Out of the way, or the next save would keep it as the previous one.
            move_into_place(path, folder_ / "damaged", Durability::power);
        }
        say(fmt::format("checkpoint passed over: {}", fault));
        faults += fault + '\n';
    }
    if (faults.empty()) return std::nullopt;
    throw DamagedArchive(
        fmt::format("{}no sound checkpoint is left; 'run --fresh' starts anew and keeps the old "
                    "directory beside it",
                    faults));
}

}  // namespace tt
