#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "base/parallel.hpp"

namespace tt {

/// The parts of a step by which its time is told, in the order of `advance`.
enum class Pass : std::uint8_t {
    membrane,   ///< forces of the membranes
    contact,    ///< forces between cells
    locate,     ///< stencils between nodes and sites, dipoles
    spread,     ///< forces and dipoles to sites
    viscosity,  ///< the cytoplasm laid anew
    fluid,      ///< collision, streaming, walls and ends
    move        ///< velocity to nodes, area held, nodes moved, flow held
};

/// Where the time of steps goes: seconds per pass as thread 0 sees them, waiting included.
class StepTimes {
public:
    static constexpr std::array<const char*, 7> names{"membrane",  "contact", "locate", "spread",
                                                      "viscosity", "fluid",   "move"};

    /// Begins a step, or goes on with it: what passed since the lap before is spent on no pass.
    void start() {
        if (team_rank() == 0) last_ = Clock::now();
    }
    /// What passed since the lap before was spent on `pass`.
    void lap(Pass pass) {
        if (team_rank() != 0) return;
        const Clock::time_point now = Clock::now();
        seconds_[static_cast<std::size_t>(pass)] +=
            std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }
    const std::array<double, names.size()>& seconds() const { return seconds_; }

private:
    using Clock = std::chrono::steady_clock;
    std::array<double, names.size()> seconds_{};
    Clock::time_point last_;
};

}  // namespace tt
