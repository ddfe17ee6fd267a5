#include "simulation/health.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "base/isa.hpp"
#include "base/parallel.hpp"
#include "base/vec2.hpp"
#include "grid/d2q9.hpp"
#include "membrane/outline.hpp"
#include "membrane/outline_checks.hpp"

namespace tt {
namespace {

using Range = std::pair<int, int>;  ///< [first, second)

const char* const smaller_step =
    "a smaller dt (or a lower density_scale), a finer node spacing, or a softer membrane";

int cell_of(const Suspension& cells, int node) {
    const auto after = std::upper_bound(cells.first.begin(), cells.first.end(), node);
    return static_cast<int>(after - cells.first.begin()) - 1;
}

/// What was measured against what.
struct Reading {
    std::string quantity;
    double value;
    double limit;
    std::string unit;
};

Instability fault(const Model& model, const State& state, Reading reading) {
    Instability what;
    what.quantity = std::move(reading.quantity);
    what.value = reading.value;
    what.limit = reading.limit;
    what.unit = std::move(reading.unit);
    what.step = state.step;
    what.time = static_cast<double>(state.step) * model.scales.time;
    return what;
}

/// Tells where, in the box.
void place(const Model& model, Vec2 position, Instability& what) {
    const double length = model.lattice.nx;
    what.x = (position.x - length * std::floor(position.x / length)) * model.scales.length;
    what.y = position.y * model.scales.length;
}

Instability fault_at_node(const Model& model, const State& state, int node, Reading reading) {
    Instability what = fault(model, state, std::move(reading));
    place(model, state.cells.position(node), what);
    const int cell = cell_of(state.cells, node);
    what.cell = state.cells.id[cell];
    what.node = node - state.cells.first[cell];
    return what;
}

// Far beyond any real travel, yet far from where a site index would overflow.
constexpr double farthest = 1e15;

/// Nodes now and at the last call, and what is allowed of them.
struct NodesWatched {
    int count;
    const double *x, *y, *x_before, *y_before;
    double way2;         ///< square of the largest way
    double bottom, top;  ///< of their places
};

/// How many nodes went too far or are where none can be. NaN fails every comparison.
TT_CLONES int count_faults(const NodesWatched& watched) {
    const NodesWatched w = watched;
    int faults = 0;
#pragma omp simd reduction(+ : faults)
    for (int n = 0; n < w.count; ++n) {
        const double x = w.x[n], y = w.y[n];
        const double dx = x - w.x_before[n], dy = y - w.y_before[n];
        const bool right = (dx * dx + dy * dy < w.way2) & (x > -farthest) & (x < farthest) &
                           (y > w.bottom) & (y < w.top);
        faults += right ? 0 : 1;
    }
    return faults;
}

/// Of the nodes of one cell, each finite and, where there are walls, in the open.
std::optional<Instability> node_places(const Model& model, const State& state, int cell) {
    const Suspension& cells = state.cells;
    const double height = model.lattice.ny;
    const Walls* const walls = model.boundaries.walls.get();
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
        const double x = cells.x[n];
        const double y = cells.y[n];
        const bool known = std::abs(x) < farthest && std::abs(y) < farthest;
        if (known && (!model.lattice.walls || (y > 0.0 && y < height))) {
            if (!walls || walls->distance_at({x, y}) > 0.0) continue;
            Instability what =
                fault_at_node(model, state, n,
                              {"distance to the wall", walls->distance_at({x, y}), 0.0, "sites"});
            what.cause = "a node went through a wall";
            what.cure = smaller_step;
            return what;
        }
        const bool in_x = !(std::abs(x) < farthest);
        const double limit = !known ? farthest : y > 0.0 ? height : 0.0;
        Instability what = fault_at_node(
            model, state, n, {in_x ? "node x" : "node y", in_x ? x : y, limit, "sites"});
        what.cause = known ? "a node went through a wall" : "a force or a velocity overflowed";
        what.cure = smaller_step;
        return what;
    }
    return std::nullopt;
}

/// How many of a row's sites are not slower than allowed.
template <class Real>
TT_CLONES int count_too_fast(const Real* ux, const Real* uy, int count, Real limit2) {
    int faults = 0;
#pragma omp simd reduction(+ : faults)
    for (int i = 0; i < count; ++i) faults += ux[i] * ux[i] + uy[i] * uy[i] < limit2 ? 0 : 1;
    return faults;
}

template <class Real>
std::optional<Instability> speeds(const Model& model, const State& state,
                                  const VectorField<Real>& velocity, double mach, Range rows) {
    const Real limit = static_cast<Real>(mach * mach * d2q9::sound_speed_squared);
    for (int j = rows.first; j < rows.second; ++j) {
        const Real* const ux = velocity.x.row(j);
        const Real* const uy = velocity.y.row(j);
        if (count_too_fast(ux, uy, model.lattice.nx, limit) == 0) continue;
        int i = 0;
        while (ux[i] * ux[i] + uy[i] * uy[i] < limit) ++i;
        const double value = std::sqrt((ux[i] * ux[i] + uy[i] * uy[i]) / d2q9::sound_speed_squared);
        Instability what = fault(
            model, state, {fmt::format("Mach number at site ({}, {})", i, j), value, mach, ""});
        what.cause = "the flow is too fast for the time step, or a membrane force has blown up";
        what.cure = "a smaller dt (or a lower density_scale) or a slower flow";
        if (state.step == 0 && std::isfinite(value))
            what.cure = fmt::format(
                "--set numerics.dt=\"{:.2g} us\" --set numerics.density_scale=auto, or a slower "
                "flow",
                model.scales.time * 1e6 * 0.1 / value);
        place(model, Lattice::position(i, j), what);
        return what;
    }
    return std::nullopt;
}

std::optional<Instability> areas(const Model& model, const State& state, double limit,
                                 Range of_cells) {
    const Suspension& cells = state.cells;
    for (int c = of_cells.first; c < of_cells.second; ++c) {
        const double error = signed_area(outline(cells, c)) / cells.reference_area[c] - 1.0;
        if (std::abs(error) < limit) continue;
        const char* const quantity =
            error <= -1.0 ? "area error (the outline is inside out)" : "area error";
        Instability what = fault(model, state, {quantity, 100.0 * error, 100.0 * limit, "%"});
        what.cell = cells.id[c];
        place(model, middle_of(outline(cells, c)), what);
        what.cause = "the membrane leaks or the cell collapsed";
        what.cure = "a larger area_stiffness, a finer node spacing or a smaller dt";
        return what;
    }
    return std::nullopt;
}

std::optional<Instability> crossings(const Model& model, const State& state, Range of_cells) {
    const Suspension& cells = state.cells;
    for (int c = of_cells.first; c < of_cells.second; ++c) {
        const auto crossing = self_crossing(outline(cells, c));
        if (!crossing) continue;
        const std::string quantity =
            fmt::format("crossings of segment {} with segment {} of the same cell", crossing->first,
                        crossing->second);
        Instability what =
            fault_at_node(model, state, cells.first[c] + crossing->first, {quantity, 1.0, 0.0, ""});
        what.cause = "the membrane folded onto itself";
        what.cure = "a finer node spacing, a larger bending_modulus, or a smaller dt";
        return what;
    }
    return std::nullopt;
}

/// What was found in the channel of a feed, which is no place in the box.
Instability in_feed(const Model& model, std::size_t feed, Instability what) {
    const auto port = static_cast<std::size_t>(model.feeds[feed].port);
    what.quantity += fmt::format(", in the channel that feeds port '{}'", model.port_names[port]);
    what.cell = what.node = -1;
    what.x = what.y = std::nan("");
    return what;
}

}  // namespace

Health::Health(const HealthLimits& limits, const State& state)
    : limits_(limits), x_(state.cells.x), y_(state.cells.y) {
    for (const FeedState& feed : state.feeds)
        feeds_.push_back(std::make_unique<Health>(limits, feed.state));
}

std::optional<Instability> Health::node_steps(const Model& model, const State& state) const {
    const Suspension& cells = state.cells;
    for (int n = 0; n < cells.node_count(); ++n) {
        const double way = norm(Vec2{cells.x[n] - x_[n], cells.y[n] - y_[n]});
        if (way < limits_.node_step) continue;
        Instability found = fault_at_node(
            model, state, n, {"way of a node in one step", way, limits_.node_step, "sites"});
        found.cause = "membrane forces too stiff for the time step, or nodes too close together";
        found.cure = smaller_step;
        place(model, {x_[n], y_[n]}, found);  // where it was last sound
        return found;
    }
    return std::nullopt;
}

void Health::watch_nodes(const Model& model, const Suspension& cells) {
    const bool walls = model.lattice.walls;
    const auto [begin, end] = own_nodes(cells);
    const double *const x = cells.x.data(), *const y = cells.y.data();
    const int faults =
        count_faults({end - begin, x + begin, y + begin, x_.data() + begin, y_.data() + begin,
                      limits_.node_step * limits_.node_step, walls ? 0.0 : -farthest,
                      walls ? static_cast<double>(model.lattice.ny) : farthest});
    if (faults > 0) {
        nodes_failed_ = true;
        return;  // what was good is kept to tell the way from
    }
    std::copy(x + begin, x + end, x_.data() + begin);
    std::copy(y + begin, y + end, y_.data() + begin);
}

std::optional<Instability> Health::after_step(const Model& model, const State& state, bool all) {
    for (std::size_t n = 0; n < feeds_.size(); ++n)
        if (auto found = feeds_[n]->after_step(*model.feeds[n].channel, state.feeds[n].state, all))
            return in_feed(model, n, *std::move(found));
    if (!nodes_failed_) {
        if (!all) return std::nullopt;
        const Share own{own_rows(model.lattice), own_cells(state.cells)};
        if (examine(model, state, own)) failed_ = true;
        team_barrier();
        if (!failed_) return std::nullopt;
    }
    on_one_thread([&] {
        found_ = nodes_failed_ ? node_steps(model, state) : std::nullopt;
        if (!found_) found_ = examine(model, state);
    });
    if (team_rank() == 0) nodes_failed_ = failed_ = false;  // all have read them
    return found_;
}

std::optional<Instability> Health::examine(const Model& model, const State& state) const {
    for (std::size_t n = 0; n < feeds_.size(); ++n)
        if (auto found = feeds_[n]->examine(*model.feeds[n].channel, state.feeds[n].state))
            return in_feed(model, n, *std::move(found));
    return examine(model, state, {{0, model.lattice.ny}, {0, state.cells.cell_count()}});
}

std::optional<Instability> Health::examine(const Model& model, const State& state,
                                           const Share& share) const {
    for (int c = share.cells.first; c < share.cells.second; ++c) {
        if (state.cells.led[static_cast<std::size_t>(c)] != 0) continue;  // partly behind its port
        if (auto found = node_places(model, state, c)) return found;
    }
    const auto too_fast = [&](const auto& sites) {
        return speeds(model, state, sites.velocity, limits_.mach, share.rows);
    };
    if (auto found = std::visit(too_fast, state.sites)) return found;
    if (auto found = areas(model, state, limits_.area_error, share.cells)) return found;
    return crossings(model, state, share.cells);
}

}  // namespace tt
