#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "exchange/exchange.hpp"
#include "observe/observers.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// What a checkpoint holds beside the state: the program's version, the settings of the case, the
/// wall time spent so far and what the observers remember.
void put_surroundings(ArchiveOutput& archive, const std::string& settings, double wall_seconds,
                      const Observers& observers);

/// The folder checkpoint/ of a results directory: `current` and, one older, `previous`. Each holds
/// the state and its surroundings.
class Checkpoints {
public:
    Checkpoints(const std::filesystem::path& results, std::string settings);

    /// Never half-written: the new one takes its place only when it is whole, and with
    /// Durability::power only when it is on the disk. A stop does not wait for that: should the
    /// power fail in the seconds after, the one before is there still, and on the disk. At the end
    /// of a run `last_look` is called in between, for looks beyond the observers' schedule, and the
    /// observers are saved once more: a longer run goes on from what they remembered before
    /// (`resume`), ending once more from what they remember after.
    void save(const State& state, const Observers& observers, double wall_seconds,
              Durability durability, const std::function<void()>& last_look = {});

    /// DamagedArchive if what it holds beside the `state` in it cannot be of a run.
    static void expect_sound(ArchiveReader& archive, const State& state);

    /// Resumes the observers of the state in `archive`.
    static void resume(ArchiveReader& archive, const Observers& observers, bool at_end);

    /// The newest sound checkpoint, which is on the disk when this returns. One that is damaged, or
    /// whose content makes `load` throw DamagedArchive, is renamed to `damaged` and passed over
    /// with a message to `say`. Nothing if there is none at all; DamagedArchive if there are some
    /// and none is sound.
    std::optional<ArchiveReader> newest(const std::function<void(const std::string&)>& say,
                                        const std::function<void(ArchiveReader&)>& load);

    /// Have there been any, sound or not?
    bool exist() const;

    std::filesystem::path current() const { return folder_ / "current"; }
    std::filesystem::path previous() const { return folder_ / "previous"; }
    std::filesystem::path damaged() const { return folder_ / "damaged"; }
    std::int64_t saved_step() const { return saved_step_; }

private:
    std::filesystem::path folder_;
    std::string settings_;
    std::int64_t saved_step_ = -1;
};

}  // namespace tt
