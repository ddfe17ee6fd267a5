#include "observe/last_good.hpp"

#include <algorithm>
#include <ctime>

#include "simulation/state_archive.hpp"

namespace tt {
namespace {

/// Processor time of this thread [s]: other work on the machine does not count.
double busy_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Of the run's time, what copies may cost at most, but for the first twentieth of a second of
/// them. A little more goes into stopping the team.
constexpr double share = 0.004;
constexpr double allowance = 0.05;  // s

}  // namespace

void LastGood::take(const State& state, const Observers& observers, double wall_seconds) {
    const double begin = busy_seconds();
    if (!any()) {
        begun_ = begin;
        first_step_ = state.step;
    }
    copy_saved(state, state_);
    surroundings_.clear();
    put_surroundings(surroundings_, settings_, wall_seconds, observers);
    minute_.done();
    const double now = busy_seconds();
    copies_ += now - begin;
    // Until the run has gone on for long enough to pay for them.
    const double owed = (copies_ - allowance) / share - (now - begun_);
    const double pace = static_cast<double>(state.step - first_step_) / (now - begun_);
    const std::int64_t wait =
        owed > 0.0 ? static_cast<std::int64_t>(std::min(owed * pace, 1e9)) : 0;
    next_ = state.step + std::max(interval_, wait);
}

void LastGood::write(const std::filesystem::path& path) const {
    ArchiveWriter archive(path);
    archive.put_all(surroundings_);
    save_state(archive, state_);
    archive.commit();
}

}  // namespace tt
