#include "simulation/derive.hpp"

#include "fluid/moments.hpp"

namespace tt {

/// u = Σ f c + ½ F of the uniform force: what an observer sees before the first step.
void fill_velocity(const State& state, VectorField& velocity) {
    const Lattice& lattice = velocity.x.lattice();
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) {
            const Vec2 momentum = moments(state.populations, i, j).momentum;
            velocity.x(i, j) = momentum.x + 0.5 * state.drive.body_force;
            velocity.y(i, j) = momentum.y;
        }
    }
}

void derive(const Model& model, State& state) {
    const Lattice& lattice = model.lattice;
    state.force = VectorField(lattice);
    state.velocity = VectorField(lattice);
    fill_velocity(state, state.velocity);
    state.relaxation = Relaxation(lattice);
    state.stencils = Stencils(lattice, state.cells.node_count());
    locate(model.delta, lattice, state.cells, state.stencils);
    if (state.interior.x.size() == state.cells.x.size())  // kept by a checkpoint
        restore_viscosity(model.viscosity, state.cells, state.interior, state.relaxation);
    else
        rebuild_viscosity(model.viscosity, state.cells, state.interior, state.relaxation);
}

}  // namespace tt
