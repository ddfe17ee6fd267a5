#include "simulation/advance.hpp"

#include <utility>

#include "base/parallel.hpp"
#include "fluid/collide_stream.hpp"
#include "membrane/area.hpp"
#include "simulation/drive.hpp"

namespace tt {
namespace {

/// Nodes move with the mean of the velocities sampled in this step and the last. Besides its
/// momentum a lattice fluid conserves (−1)^{x+t} u, which changes sign from step to step: the mean
/// does not see it, and so cannot feed it (docs/theory/interface.md).
void average_in_time(Suspension& cells, bool first_step) {
    const auto [begin, end] = team_share(cells.node_count());
    for (auto [velocity, sampled] :
         {std::pair{&cells.ux, &cells.ux_sampled}, std::pair{&cells.uy, &cells.uy_sampled}}) {
        double* const u = velocity->data();
        double* const last = sampled->data();
        for (int n = begin; n < end; ++n) {
            const double now = u[n];
            u[n] = first_step ? now : 0.5 * (now + last[n]);
            last[n] = now;
        }
    }
    team_barrier();
}

/// Forward Euler.
void move_nodes(Suspension& cells) {
    const auto [begin, end] = team_share(cells.node_count());
    for (int n = begin; n < end; ++n) {
        cells.x[n] += cells.ux[n];
        cells.y[n] += cells.uy[n];
    }
    team_barrier();
}

void finish_step(const Model& m, State& s) {
    on_one_thread([&] {
        hold_flow(m, s);
        ++s.step;
    });
}

}  // namespace

void advance(const Model& m, State& s, Exchange& x, FlowKept kept, StepTimes* times) {
    const bool everywhere = kept == FlowKept::everywhere || drive_looks_at(s.step);
    // Kept near membranes only, the velocity of a site takes the place of the force on it, which
    // the collision is the last to read: so much less to bring into the cache.
    VectorField& velocity = everywhere ? s.velocity : s.force;
    const Order order = m.jump.has_dipole() ? Order::first : Order::zeroth;
    const auto done = [times](Pass pass) {
        if (times) times->lap(pass);
    };
    if (times) times->start();

    set_membrane_forces(m.membrane, s.cells);  // Eqs. 10–15
    done(Pass::membrane);

    add_pair_forces(m.contact, m.lattice, s.cells, s.contact);  // Eqs. 16–17
    done(Pass::contact);

    unspread(s.stencils, s.force);
    locate(m.delta, m.lattice, s.cells, s.stencils);  // Eq. 8
    done(Pass::locate);

    set_dipoles(m.jump, s.cells);
    spread(order, s.stencils, s.cells, s.force);  // Eq. 9
    x.fold(s.force);
    done(Pass::spread);

    update_viscosity(m.viscosity, s.cells, s.interior, s.relaxation);
    done(Pass::viscosity);

    collide_and_stream(m.equilibrium, m.boundaries, {s.drive.body_force, 0.0}, s.force,
                       s.relaxation, s.populations, velocity,
                       everywhere ? nullptr : &s.stencils.near_membranes);  // Eqs. 1–4
    settle(x, s.populations);
    done(Pass::fluid);

    x.fill(velocity);
    interpolate(order, s.stencils, velocity, s.cells);  // Eq. 7
    correct_velocities(m.jump, s.cells);
    average_in_time(s.cells, s.step == 0);
    done(Pass::interpolate);

    if (m.membrane.hold_area) hold_areas(s.cells);
    move_nodes(s.cells);
    finish_step(m, s);
    done(Pass::move);
}

}  // namespace tt
