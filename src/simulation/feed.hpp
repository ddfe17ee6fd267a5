#pragma once

#include <cstdint>
#include <memory>

#include "base/vec2.hpp"
#include "coupling/cut_stencils.hpp"
#include "coupling/stencil.hpp"

namespace tt {

struct Model;
struct State;
struct FeedState;
struct Suspension;
template <class Real>
struct Sites;

/// A straight channel of the width of a port, periodic along its flow, that runs beside the
/// network. What arrives at its end enters the network through the port, plasma and cells
/// (docs/theory/ports.md). Its sites are those of the network moved by whole sites. Lattice units.
struct Feed {
    std::shared_ptr<const Model> channel;
    int port = 0;
    int period = 0;     ///< of the channel, along its flow
    Vec2 in;            ///< direction of its flow, into the network
    int i = 0, j = 0;   ///< site of the network that is site (0, 0) of the channel
    double room = 0.0;  ///< behind the port and before it, in which cells are led
};

/// A cell of the network that is still led: its nodes are where those of a cell of the feed are.
struct Follower {
    std::int32_t cell = 0;    ///< its number in the network
    std::int32_t leader = 0;  ///< that of the other in the feed
    std::int32_t turn = 0;    ///< how many periods of the channel it has gone
};

/// A cell that has come in.
struct Entered {
    std::int64_t id = 0, kind = 0;
    double time = 0.0;   ///< [steps], when its foremost node came to the port
    double place = 0.0;  ///< of its middle along the port
    double area = 0.0;
};

/// Where the cell comes from if it is led; else nothing.
struct Leader {
    const Feed* feed = nullptr;
    const FeedState* state = nullptr;
    const Follower* follower = nullptr;
    explicit operator bool() const { return feed != nullptr; }
};
Leader leader_of(const Model& model, const State& state, int cell);

/// Lets the cells in that have come to a port in its feed, and lets those go that are past it with
/// all of their kernels. Until then a cell is led: it moves as in the feed and loads the fluid as
/// there, so that it passes the port without a trace. Between steps, one thread; true if any came.
bool admit_cells(const Model& model, State& state);

/// Gives led cells the loads and kernels that they have in their feed, which has just made the same
/// step. After the loads and kernels of all cells have been made; a team function, by cells.
template <class Real>
void take_loads(const Model& model, State& state, Sites<Real>& sites);

/// Moves a led cell to where its feed has moved it.
void follow(const Leader& leader, Suspension& cells, int cell);

}  // namespace tt
