#include "simulation/feed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "membrane/outline.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {
namespace {

constexpr int width = Stencils<>::width;
/// Behind a port a cell is let go once no kernel of it can reach back, not even if it wavers.
constexpr double clear = kernel_reach + 1.0;

/// How far the foremost and the hindmost node of a cell of the feed have come along its flow.
struct Progress {
    double front = -std::numeric_limits<double>::infinity();
    double rear = std::numeric_limits<double>::infinity();
};
Progress progress_of(const Feed& feed, const Suspension& cells, int cell) {
    Progress progress;
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
        const double along = dot(cells.position(n), feed.in);
        progress.front = std::max(progress.front, along);
        progress.rear = std::min(progress.rear, along);
    }
    return progress;
}

/// From a place in the feed to that in the network after so many turns.
Vec2 moved_by(const Feed& feed, std::int32_t turn) {
    return Vec2{static_cast<double>(feed.i), static_cast<double>(feed.j)} -
           static_cast<double>(turn) * feed.period * feed.in;
}

/// Sites of the feed are counted round; the port is at 0, and cells are near it.
int near_port(int site, int period) { return site >= period / 2 ? site - period : site; }

int cell_with_number(const Suspension& cells, std::int32_t id) {
    return static_cast<int>(std::lower_bound(cells.id.begin(), cells.id.end(), id) -
                            cells.id.begin());
}

/// The ports that its cells come to next, by their turn.
void count_turns(const Feed& feed, FeedState& from) {
    const Suspension& cells = from.state.cells;
    for (int c = static_cast<int>(from.turn.size()); c < cells.cell_count(); ++c) {
        const double rear = progress_of(feed, cells, c).rear;
        from.turn.push_back(static_cast<std::int32_t>(std::floor((rear - clear) / feed.period)) +
                            1);
    }
}

void let_go(const Feed& feed, FeedState& from, Suspension& cells) {
    std::erase_if(from.followers, [&](const Follower& follower) {
        const double rear = progress_of(feed, from.state.cells, follower.leader).rear;
        if (rear < follower.turn * static_cast<double>(feed.period) + clear) return false;
        cells.led[static_cast<std::size_t>(cell_with_number(cells, follower.cell))] = 0;
        return true;
    });
}

/// Adds to the network what has come to the port in the feed.
void admit(const Model& model, const Feed& feed, std::int32_t leader, FeedState& from,
           State& state) {
    const std::int32_t turn = from.turn[static_cast<std::size_t>(leader)]++;
    const auto id = static_cast<std::int32_t>(state.cells.id.size() + state.departed.size());
    copy_cell(from.state.cells, leader, moved_by(feed, turn), state.cells);
    state.cells.id.back() = id;
    state.cells.led.back() = 1;
    const int cell = state.cells.cell_count() - 1;
    for (int n = state.cells.first[cell]; n < state.cells.first[cell + 1]; ++n) {
        state.interior.x.push_back(state.cells.x[n]);
        state.interior.y.push_back(state.cells.y[n]);
    }
    from.followers.push_back({id, leader, turn});
    const Outline shape = outline(state.cells, cell);
    const Exit& port = model.exits[static_cast<std::size_t>(feed.port)];
    from.entered.push_back({id, state.cells.kind[static_cast<std::size_t>(cell)],
                            static_cast<double>(state.step), place_along(port, middle_of(shape)),
                            area_moments(shape).area});
}

}  // namespace

Leader leader_of(const Model& model, const State& state, int cell) {
    if (state.cells.led[static_cast<std::size_t>(cell)] == 0) return {};
    const std::int32_t id = state.cells.id[static_cast<std::size_t>(cell)];
    for (std::size_t n = 0; n < state.feeds.size(); ++n)
        for (const Follower& follower : state.feeds[n].followers)
            if (follower.cell == id) return {&model.feeds[n], &state.feeds[n], &follower};
    return {};
}

bool admit_cells(const Model& model, State& state) {
    const int before = state.cells.cell_count();
    for (std::size_t n = 0; n < state.feeds.size(); ++n) {
        const Feed& feed = model.feeds[n];
        FeedState& from = state.feeds[n];
        count_turns(feed, from);
        let_go(feed, from, state.cells);
        const Suspension& cells = from.state.cells;
        for (std::int32_t c = 0; c < cells.cell_count(); ++c) {
            const double port = from.turn[static_cast<std::size_t>(c)] * double(feed.period);
            // No node is farther from another than half of the perimeter.
            const double one = dot(cells.position(cells.first[c]), feed.in);
            if (one + 0.5 * cells.perimeter[c] < port - kernel_reach) continue;
            if (progress_of(feed, cells, c).front >= port - kernel_reach)
                admit(model, feed, c, from, state);
        }
    }
    return state.cells.cell_count() > before;
}

template <class Real>
void take_loads(const Model& model, State& state, Sites<Real>& sites) {
    Suspension& cells = state.cells;
    const auto [begin, end] = own_cells(cells);
    for (int cell = begin; cell < end; ++cell) {
        const Leader leader = leader_of(model, state, cell);
        if (!leader) continue;
        const Feed& feed = *leader.feed;
        const auto& there = std::get<Sites<Real>>(leader.state->state.sites);
        const Suspension& others = leader.state->state.cells;
        const int other = leader.follower->leader;
        const int first = cells.first[cell], from = others.first[other];
        const int count = cells.node_count(cell);
        const auto copy = [&](const auto& source, auto& target, int per_node) {
            std::copy_n(&source[static_cast<std::size_t>(per_node) * from], per_node * count,
                        &target[static_cast<std::size_t>(per_node) * first]);
        };
        copy(others.fx, cells.fx, 1);
        copy(others.fy, cells.fy, 1);
        copy(others.dipole_xx, cells.dipole_xx, 1);
        copy(others.dipole_xy, cells.dipole_xy, 1);
        copy(there.stencils.wx, sites.stencils.wx, width);
        copy(there.stencils.wy, sites.stencils.wy, width);
        copy(there.stencils.sx, sites.stencils.sx, width);
        copy(there.stencils.sy, sites.stencils.sy, width);
        const auto here_i = [&](int i) {
            return feed.i + (feed.in.x != 0.0 ? near_port(i, feed.period) : i);
        };
        const auto here_j = [&](int j) {
            return feed.j + (feed.in.y != 0.0 ? near_port(j, feed.period) : j);
        };
        for (int n = 0; n < count; ++n) {
            sites.stencils.i[first + n] = here_i(there.stencils.i[from + n]);
            sites.stencils.j[first + n] = here_j(there.stencils.j[from + n]);
        }
        auto& cut = sites.cut.of_cell[static_cast<std::size_t>(cell)];
        cut = there.cut.of_cell[static_cast<std::size_t>(other)];
        for (CutStencil<Real>& stencil : cut) {
            stencil.node += first - from;
            stencil.i = here_i(stencil.i);
            stencil.j = here_j(stencil.j);
        }
    }
}
template void take_loads(const Model&, State&, Sites<double>&);
template void take_loads(const Model&, State&, Sites<float>&);

void follow(const Leader& leader, Suspension& cells, int cell) {
    const Suspension& others = leader.state->state.cells;
    const int first = cells.first[cell], from = others.first[leader.follower->leader];
    const Vec2 by = moved_by(*leader.feed, leader.follower->turn);
    for (int n = 0; n < cells.node_count(cell); ++n) {
        cells.x[first + n] = others.x[from + n] + by.x;
        cells.y[first + n] = others.y[from + n] + by.y;
    }
    const auto copy = [&](auto array) {
        std::copy_n(&(others.*array)[from], cells.node_count(cell), &(cells.*array)[first]);
    };
    for (const auto array :
         {&Suspension::ux, &Suspension::uy, &Suspension::ux_sampled, &Suspension::uy_sampled,
          &Suspension::rate_xx, &Suspension::rate_xy, &Suspension::stiffness})
        copy(array);
    for (const CarriedLoad& load : carried_loads) copy(load.values);
}

}  // namespace tt
