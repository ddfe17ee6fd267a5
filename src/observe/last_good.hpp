#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "io/archive.hpp"
#include "observe/checkpoints.hpp"
#include "observe/duty.hpp"
#include "simulation/state.hpp"

namespace tt {

/// The last state known to be sound, in memory: what a run that blows up can go on from. Taken
/// every 2 % of the run and every minute. A copy takes about as long as a step; runs of so few
/// steps that it would cost more than half a percent of them take it less often.
class LastGood {
public:
    LastGood(std::int64_t steps, std::string settings)
        : interval_(std::max<std::int64_t>(steps / 50, 1)), settings_(std::move(settings)) {}

    /// The step at which the next copy should be taken, if the minute does not come first.
    std::int64_t next() const { return next_; }
    Clock::time_point wake() const { return minute_.next(); }
    bool due(std::int64_t step) const { return step >= next_ || minute_.due(); }

    /// Precondition: the state has been examined, and looked at by the observers if they are to.
    void take(const State& state, const Observers& observers, double wall_seconds);

    bool any() const { return !surroundings_.bytes().empty(); }
    std::int64_t step() const { return state_.step; }
    const State& state() const { return state_; }  ///< without what is derived

    /// Writes it as a checkpoint. Precondition: any().
    void write(const std::filesystem::path& path) const;

private:
    const std::int64_t interval_;  ///< steps
    const std::string settings_;
    std::int64_t next_ = 0;
    Duty minute_{60.0};
    double begun_ = 0.0;   ///< [s] of this thread's processor time
    double copies_ = 0.0;  ///< [s] of it that all copies took
    std::int64_t first_step_ = 0;
    State state_;
    ArchiveBuffer surroundings_;
};

}  // namespace tt
