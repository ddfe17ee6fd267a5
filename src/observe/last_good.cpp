#include "observe/last_good.hpp"

#include <algorithm>

#include "simulation/state_archive.hpp"

namespace tt {
namespace {

double seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

/// Of the run's time, what copies may cost at most.
constexpr double share = 0.005;

}  // namespace

void LastGood::take(const State& state, const Observers& observers, double wall_seconds) {
    const Clock::time_point begin = Clock::now();
    const std::int64_t steps = state.step - state_.step;
    const double step_seconds = any() && steps > 0 ? seconds(begin - taken_) / steps : 0.0;
    copy_saved(state, state_);
    surroundings_.clear();
    put_surroundings(surroundings_, settings_, wall_seconds, observers);
    taken_ = Clock::now();
    minute_.done();
    // The quickest: the first one asks the system for memory, others are held up by other work.
    copy_seconds_ = std::min(copy_seconds_, seconds(taken_ - begin));
    const double dear = step_seconds > 0.0 ? copy_seconds_ / (share * step_seconds) : 0.0;
    next_ = state.step + std::max(interval_, static_cast<std::int64_t>(std::min(dear, 1e9)));
}

void LastGood::write(const std::filesystem::path& path) const {
    ArchiveWriter archive(path);
    archive.put_all(surroundings_);
    save_state(archive, state_);
    archive.commit();
}

}  // namespace tt
