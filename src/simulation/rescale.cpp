#include "simulation/rescale.hpp"

#include <cmath>
#include <variant>

#include "fluid/moments.hpp"

namespace tt {
namespace {

/// In phase even, whose halo nobody reads.
template <class Kind, class Real>
Populations<Real> rescaled(Kind kind, double ratio, Vec2 body_force,
                           const Populations<Real>& before) {
    const Lattice& lattice = before.lattice();
    Populations<Real> after(lattice);
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) {
            const Moments m = moments(before, i, j);
            // The force of the membranes is left out: what it adds to f^eq is of second order.
            const Vec2 u = velocity(kind, m.density_deviation, m.momentum + 0.5 * body_force);
            for (int k = 0; k < d2q9::count; ++k) {
                const double away =
                    before.arriving(k, i, j) - population(kind, k, m.density_deviation, u);
                after.set_slot(
                    k, i, j,
                    population(kind, k, ratio * m.density_deviation, ratio * u) + ratio * away);
            }
        }
    }
    return after;
}

}  // namespace

void change_time_step(const Model& model, double ratio, State& state) {
    std::visit(
        [&](auto kind, auto& sites) {
            sites.populations = rescaled(
                kind, ratio, state.drive.body_force * model.drive.direction, sites.populations);
        },
        model.equilibrium, state.sites);
    Suspension& cells = state.cells;
    for (auto* per_step : {&cells.fx, &cells.fy, &cells.pair_fx, &cells.pair_fy, &cells.ux,
                           &cells.uy, &cells.ux_sampled, &cells.uy_sampled}) {
        for (double& value : *per_step) value *= ratio;
    }
    for (const CarriedLoad& load : carried_loads)
        for (double& value : cells.*load.values) value *= ratio;
    state.drive.body_force *= ratio;
    state.drive.integral *= ratio;
    for (PortFlow& port : state.ports)
        for (auto* of_steps : {&port.density, &port.inflow})
            for (double& value : *of_steps) value *= ratio;
    for (SectionState& section : state.sections) {
        for (auto* of_steps : {&section.density, &section.inflow})
            for (double& value : *of_steps) value *= ratio;
        for (auto& velocity : section.velocity)
            for (double& value : velocity) value *= ratio;
    }
    for (Departed& departed : state.departed) {
        departed.time /= ratio;
        departed.speed *= ratio;
    }
    for (std::size_t n = 0; n < state.feeds.size(); ++n) {
        change_time_step(*model.feeds[n].channel, ratio, state.feeds[n].state);
        for (Entered& entered : state.feeds[n].entered) entered.time /= ratio;
    }
    state.step = std::llround(static_cast<double>(state.step) / ratio);
}

}  // namespace tt
