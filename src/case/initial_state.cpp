#include "case/initial_state.hpp"

#include <cmath>
#include <utility>

#include "case/suspend.hpp"
#include "coupling/stencil.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "simulation/derive.hpp"

namespace tt {
namespace {

/// The flow without cells: Couette between the walls, the Poiseuille flow of the nominal rate, or
/// what plasma alone does between walls of any shape.
void add_flow_without_cells(const Model& m, VectorField<>& velocity, Field<>& density) {
    const double height = m.lattice.ny;
    const double mean = m.drive.target_velocity * m.drive.waveform.at(0.0);
    for (int j = 0; j < m.lattice.ny; ++j) {
        const double y = j + 0.5;
        const double couette = m.boundaries.bottom_speed +
                               (m.boundaries.top_speed - m.boundaries.bottom_speed) * y / height;
        const double poiseuille = 6.0 * mean * (y / height) * (1.0 - y / height);
        for (int i = 0; i < m.lattice.nx; ++i) {
            if (const UndisturbedFlow* plasma = m.undisturbed.get()) {
                velocity.x(i, j) = mean * plasma->velocity.x(i, j);
                velocity.y(i, j) = mean * plasma->velocity.y(i, j);
                density(i, j) = mean * m.viscosity.plasma * plasma->density(i, j);
            } else {
                velocity.x(i, j) = couette + poiseuille;
            }
        }
    }
}

/// What an observer sees of the ports before the first step.
void set_ports(const Model& m, FluidStart start, State& state) {
    if (!m.undisturbed || start == FluidStart::rest) return;
    const double unit = m.drive.target_velocity;
    for (const UndisturbedFlow::Port& port : m.undisturbed->ports) {
        const double density = unit * m.viscosity.plasma * port.density;
        const double inflow = unit * port.inflow;
        state.ports.push_back({{density, density}, {inflow, inflow}});
    }
}

/// Before the first step nodes move with the fluid around them: what an observer sees of them then,
/// and nothing else, follows from it.
template <class Real>
void let_nodes_follow(Sites<Real>& sites, Suspension& cells) {
    Periodic().fill(sites.velocity);
    for (int cell = 0; cell < cells.cell_count(); ++cell)
        interpolate(Order::zeroth, sites.stencils, sites.velocity, cells, cell);
}

/// The fluid in its flow and all that follows from the cells, which are there.
void start(const Case& c, const Model& model, State& state) {
    state.drive.body_force = model.drive.body_force;
    // Nothing is nearer than the reach of the contact forces; without them gaps are not measured.
    state.contact.smallest_gap = model.contact.range > 0.0 ? model.contact.range : std::nan("");
    VectorField<> velocity(model.lattice);
    Field<> density = density_of_drop(model);
    if (c.flow.start == FluidStart::developed) add_flow_without_cells(model, velocity, density);
    start_flow(model, velocity, density, state);
    set_ports(model, c.flow.start, state);
    derive(model, state);
    std::visit([&](auto& sites) { let_nodes_follow(sites, state.cells); }, state.sites);
}

/// The channel of a feed with its cells at random.
State feed_at_start(const Case& c, const Model& network, const Feed& feed,
                    const LayoutWatch& watch) {
    State state;
    state.cells = cells_of_feed(c, network, feed, watch);
    start(c, *feed.channel, state);
    return state;
}

}  // namespace

State initial_state(const Case& c, const Model& model, const LayoutWatch& watch) {
    State state;
    state.cells = suspended_cells(c, model, watch);
    for (const Feed& feed : model.feeds)
        state.feeds.emplace_back().state = feed_at_start(c, model, feed, watch);
    if (admit_cells(model, state)) refuse_overlaps(model, state.cells);
    state.interior = {};
    start(c, model, state);
    return state;
}

}  // namespace tt
