#pragma once

#include <cstdint>
#include <string>

#include "simulation/model.hpp"
#include "simulation/run.hpp"
#include "simulation/state.hpp"

namespace tt {

/// How far a run is and how fast it goes: what the progress line and status.json show.
struct Standing {
    std::string name;
    std::int64_t step = 0, steps = 0;
    double time = 0.0, end = 0.0;   ///< [s]
    double wall_seconds = 0.0;      ///< all sessions together
    double steps_per_second = 0.0;  ///< of late
    double mlups = 0.0;             ///< million site updates per second
    double seconds_left = 0.0;      ///< at this pace
    double lambda_C = 1.0;          ///< perimeter extension ratio, mean over cells
    std::int64_t checkpoint_step = -1;
    int cells = 0;
    int threads = 1;
    double dx = 0.0;  ///< site spacing [m]
};

/// Mean over cells of perimeter / rest perimeter; 1 without cells.
double mean_extension(const Suspension& cells);

/// Steps per second, smoothed over some seconds so that the time left does not jump.
class Pace {
public:
    explicit Pace(std::int64_t step)
        : step_(step), start_(Clock::now()), last_(start_), first_step_(step) {}

    void update(std::int64_t step);
    double steps_per_second() const { return rate_; }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    /// Mean since the start of this session.
    double mean_rate(std::int64_t step) const;

private:
    std::int64_t step_;
    Clock::time_point start_, last_;
    std::int64_t first_step_;
    double rate_ = 0.0;
};

}  // namespace tt
