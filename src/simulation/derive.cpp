#include "simulation/derive.hpp"

#include "fluid/collide_stream.hpp"

namespace tt {

void derive(const Model& model, State& state) {
    const Lattice& lattice = model.lattice;
    state.force = VectorField(lattice);
    state.velocity = VectorField(lattice);
    state.relaxation = Relaxation(lattice);
    state.stencils = Stencils(state.cells.node_count());
    locate(model.delta, lattice, state.cells, state.stencils);
    if (state.interior.x.size() == state.cells.x.size())  // kept by a checkpoint
        restore_viscosity(model.viscosity, state.cells, state.interior, state.relaxation);
    else
        rebuild_viscosity(model.viscosity, state.cells, state.interior, state.relaxation);
}

}  // namespace tt
