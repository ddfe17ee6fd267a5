#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exchange/exchange.hpp"
#include "observe/observer.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

using Observers = std::vector<std::unique_ptr<Observer>>;

/// What a checkpoint holds beside the state: the hash of the case, the wall time spent so far and
/// what the observers remember.
void put_surroundings(ArchiveOutput& archive, const std::string& case_hash, double wall_seconds,
                      const Observers& observers);

/// The folder checkpoint/ of a results directory: `current` and, one older, `previous`. Each holds
/// the state and its surroundings.
class Checkpoints {
public:
    Checkpoints(const std::filesystem::path& results, std::string case_hash);

    /// Never half-written: the new one takes its place only when it is whole and on the disk.
    void save(const State& state, const Observers& observers, double wall_seconds);

    /// The newest sound checkpoint of this case; one that is damaged (renamed to `damaged`) or of
    /// another case is passed over with a message to `say`. Nothing if there is none at all;
    /// DamagedArchive if there are some and none is sound.
    std::optional<ArchiveReader> newest(const std::function<void(const std::string&)>& say);

    std::filesystem::path current() const { return folder_ / "current"; }
    std::filesystem::path previous() const { return folder_ / "previous"; }
    std::int64_t saved_step() const { return saved_step_; }

private:
    std::filesystem::path folder_;
    std::string case_hash_;
    std::int64_t saved_step_ = -1;
};

}  // namespace tt
