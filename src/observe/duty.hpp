#pragma once

#include <algorithm>
#include <chrono>

#include "simulation/run.hpp"

namespace tt {

/// Something to do by the wall clock.
class Duty {
public:
    explicit Duty(double interval) : interval_(interval), next_(after(interval)) {}
    bool due() const { return Clock::now() >= next_; }
    void done() { next_ = after(interval_); }
    Clock::time_point next() const { return next_; }

private:
    static Clock::time_point after(double seconds) {
        constexpr double for_ever = 1e9;
        const std::chrono::duration<double> wait(std::min(seconds, for_ever));
        return Clock::now() + std::chrono::duration_cast<Clock::duration>(wait);
    }
    double interval_;
    Clock::time_point next_;
};

}  // namespace tt
