#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tt {

/// When something is due, in steps: the n-th time is the step nearest to n · interval, with the
/// interval a real number of steps. A function of the step alone, so it neither drifts nor changes
/// across a restart.
class Schedule {
public:
    Schedule() = default;
    /// Every `interval` seconds of a run with time step `dt` [s]; an interval below one step means
    /// every step.
    Schedule(double interval, double dt) : steps_(std::max(1.0, interval / dt)) {}

    bool due(std::int64_t step) const { return nth(nearest(step)) == step; }

    /// The first due step after `step`.
    std::int64_t next_after(std::int64_t step) const {
        std::int64_t n = nearest(step);
        while (nth(n) <= step) ++n;
        while (n > 0 && nth(n - 1) > step) --n;
        return nth(n);
    }

    double interval_in_steps() const { return steps_; }

private:
    /// Beyond what a step number can be: never.
    std::int64_t nth(std::int64_t n) const { return whole(static_cast<double>(n) * steps_); }
    std::int64_t nearest(std::int64_t step) const {
        return whole(static_cast<double>(step) / steps_);
    }
    static std::int64_t whole(double number) {
        constexpr double largest = 9.2e18;  // just below 2^63
        return number < largest ? std::llround(number) : std::numeric_limits<std::int64_t>::max();
    }

    double steps_ = 1.0;
};

/// The number of steps that reaches `end` seconds: the smallest with steps · dt ≥ end but for
/// rounding.
inline std::int64_t steps_until(double end, double dt) {
    return static_cast<std::int64_t>(std::ceil(end / dt * (1.0 - 1e-12)));
}

}  // namespace tt
