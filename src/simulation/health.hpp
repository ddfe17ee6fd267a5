#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Beyond these a run has left what it can compute. They notice a blow-up; accuracy is a matter of
/// `check`.
struct HealthLimits {
    double node_step =
        0.5;  ///< largest way of a node in one step [sites]: beyond, explicit coupling overshoots
    double mach = 0.5;         ///< largest speed / speed of sound
    double area_error = 0.05;  ///< largest |A / A_ref − 1| of a cell
    int interval = 100;        ///< steps between the costly checks
};

/// Watches a run. Comparisons are written so that a NaN fails them, and come before any position is
/// made an index.
class Health {
public:
    /// Starts from the positions in `state`.
    Health(const HealthLimits& limits, const State& state);

    /// Starts anew from the positions in `state`, as some cells are gone.
    void forget(const State& state) { x_ = state.cells.x, y_ = state.cells.y; }

    /// That of the channel of a feed, which is looked after with the network.
    Health* of_feed(std::size_t n) { return feeds_[n].get(); }

    /// Looks at the nodes a step has moved: the way of each since the last call, and its place
    /// between the walls. Cheap; `advance` calls it in every step. Team function, by cells.
    void watch_nodes(const Model& model, const Suspension& cells);

    /// After a step whose nodes were watched: what is wrong, or nothing; if `all`, looks at all
    /// that `examine` does. Team function that tells all the same; all threads must have waited
    /// since they watched, as they do at the end of `advance`.
    std::optional<Instability> after_step(const Model& model, const State& state, bool all);

    /// Is it time for all that `examine` does, after this step?
    bool due(std::int64_t step) const { return step % limits_.interval == 0; }

    /// All checks but the node step: node places, speed at every site, area and orientation of
    /// every cell, outlines that cross themselves. A state that no step has led to is examined
    /// before it is looked at or written.
    std::optional<Instability> examine(const Model& model, const State& state) const;

private:
    /// Rows of sites and cells to look at.
    struct Share {
        std::pair<int, int> rows, cells;
    };
    std::optional<Instability> node_steps(const Model& model, const State& state) const;
    std::optional<Instability> examine(const Model& model, const State& state,
                                       const Share& share) const;

    HealthLimits limits_;
    std::vector<std::unique_ptr<Health>> feeds_;
    std::vector<double> x_, y_;              ///< positions at the last call
    std::atomic<bool> nodes_failed_{false};  ///< of any thread, in this step
    std::atomic<bool> failed_{false};        ///< the same of everything
    std::optional<Instability> found_;       ///< for all threads to tell
};

}  // namespace tt
