#include "simulation/advance.hpp"

#include "base/parallel.hpp"
#include "fluid/collide_stream.hpp"
#include "simulation/drive.hpp"

namespace tt {
namespace {

/// The fluid's part of a step: halos hold what arrives through ends and walls, and return what leaves through them.
void flow(const Model& m, State& s, Exchange& x) {
    if (s.populations.phase == Populations::Phase::odd) {
        x.fill(s.populations);
        fill_pressure_ends(m.boundaries, s.populations);
        fill_walls(m.boundaries, s.populations);
    }
    collide_and_stream(m.equilibrium, {s.drive.body_force, 0.0}, s.force, s.relaxation, s.populations, s.velocity);
    if (s.populations.phase == Populations::Phase::odd) {
        fold_walls(m.boundaries, s.populations);
        fold_pressure_ends(m.boundaries, s.populations);
        x.fold(s.populations);
    }
}

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
        using Phase = Populations::Phase;
        s.populations.phase = s.populations.phase == Phase::even ? Phase::odd : Phase::even;
        hold_flow(m, s);
        ++s.step;
    });
}

}  // namespace

void advance(const Model& m, State& s, Exchange& x) {
    set_membrane_forces(m.membrane, s.cells);                                          // Eqs. 10–15
    add_pair_forces(m.contact, m.lattice, s.cells, s.contact);                         // Eqs. 16–17
    unspread(s.stencils, s.force);
    locate(m.delta, m.lattice, s.cells, s.stencils);                                   // Eq. 8
    spread(s.stencils, s.cells, s.force);                                              // Eq. 9
    x.fold(s.force);
    update_viscosity(m.viscosity, s.cells, s.interior, s.relaxation);
    flow(m, s, x);                                                                     // Eqs. 1–4
    x.fill(s.velocity);
    interpolate(s.stencils, s.velocity, s.cells);                                      // Eq. 7
    move_nodes(s.cells);
    finish_step(m, s);
}

}  // namespace tt
