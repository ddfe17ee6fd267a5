#include "simulation/advance.hpp"

#include "base/parallel.hpp"
#include "fluid/collide_stream.hpp"
#include "simulation/drive.hpp"

namespace tt {
namespace {

/// Forward Euler with the interpolated velocity.
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

void advance(const Model& m, State& s, Exchange& x, FlowKept kept) {
    const bool everywhere = kept == FlowKept::everywhere || drive_looks_at(s.step);
    // Kept near membranes only, the velocity of a site takes the place of the force on it, which
    // the collision is the last to read: so much less to bring into the cache.
    VectorField& velocity = everywhere ? s.velocity : s.force;
    const Order order = m.jump.has_dipole() ? Order::first : Order::zeroth;
    set_membrane_forces(m.membrane, s.cells);                   // Eqs. 10–15
    add_pair_forces(m.contact, m.lattice, s.cells, s.contact);  // Eqs. 16–17
    set_dipoles(m.jump, s.cells);
    unspread(s.stencils, s.force);
    locate(m.delta, m.lattice, s.cells, s.stencils);  // Eq. 8
    spread(order, s.stencils, s.cells, s.force);      // Eq. 9
    x.fold(s.force);
    update_viscosity(m.viscosity, s.cells, s.interior, s.relaxation);
    collide_and_stream(m.equilibrium, m.boundaries, {s.drive.body_force, 0.0}, s.force,
                       s.relaxation, s.populations, velocity,
                       everywhere ? nullptr : &s.stencils.near_membranes);  // Eqs. 1–4
    settle(x, s.populations);
    x.fill(velocity);
    interpolate(order, s.stencils, velocity, s.cells);  // Eq. 7
    correct_velocities(m.jump, s.cells);
    move_nodes(s.cells);
    finish_step(m, s);
}

}  // namespace tt
