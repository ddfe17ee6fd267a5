#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tt {

/// The step nearest to `steps`, a real number of them; the later of two that are as near, whatever
/// the rounding of a time and of an interval that divides it.
inline std::int64_t nearest_step(double steps) {
    constexpr double farthest = 4e18;  // whatever an interval is, twice of it is an int64 too
    return static_cast<std::int64_t>(std::floor(std::min(steps, farthest) * (1.0 + 1e-12) + 0.5));
}

/// The number of steps of a run that ends at `end` seconds: the step nearest to it, and one at
/// least. The same rule as Schedule's, so that an interval which divides the end meets it.
inline std::int64_t steps_until(double end, double dt) {
    return std::max(std::int64_t{1}, nearest_step(end / dt));
}

/// When something is due, in steps: the n-th time is the step nearest to n · interval, with the
/// interval a real number of steps. A function of the step alone, so it neither drifts nor changes
/// across a restart.
class Schedule {
public:
    Schedule() = default;
    /// Every `interval` seconds of a run with time step `dt` [s]; an interval below one step means
    /// every step.
    Schedule(double interval, double dt)
        : interval_(interval), steps_(std::max(1.0, interval / dt)) {}

    double interval() const { return interval_; }  ///< [s]

    bool due(std::int64_t step) const { return nth(nearest(step)) == step; }

    /// The first due step after `step`.
    std::int64_t next_after(std::int64_t step) const {
        std::int64_t n = nearest(step);
        while (nth(n) <= step) ++n;
        while (n > 0 && nth(n - 1) > step) --n;
        return nth(n);
    }

    /// The step at which this schedule has the look that `other`, of the same interval and another
    /// time step, has at `step`.
    std::int64_t counterpart(const Schedule& other, std::int64_t step) const {
        return nth(other.nearest(step));
    }

private:
    std::int64_t nth(std::int64_t n) const { return nearest_step(static_cast<double>(n) * steps_); }
    std::int64_t nearest(std::int64_t step) const {
        return std::llround(static_cast<double>(step) / steps_);
    }

    double interval_ = 0.0;
    double steps_ = 1.0;
};

}  // namespace tt
