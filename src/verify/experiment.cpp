#include "verify/experiment.hpp"

#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "fluid/moments.hpp"
#include "simulation/derive.hpp"
#include "simulation/run.hpp"

namespace tt {

Experiment::Experiment(const Case& c) : model(discretise(c)), state(initial_state(c, model)) {}

Experiment::Experiment(const Model& m, const Suspension& cells, const VectorField<>& velocity)
    : model(m) {
    state.cells = cells;
    state.drive.body_force = model.drive.body_force;
    start_flow(model, velocity, density_of_drop(model), state);
    derive(model, state);
}

Experiment::Experiment(const Model& m, const Suspension& cells)
    : Experiment(m, cells, VectorField<>(m.lattice)) {}

void Experiment::advance_by(std::int64_t steps) {
    if (steps <= 0) return;
    Health health(HealthLimits{}, state);
    run_steps(model, state, ends, health, state.step + steps, Clock::time_point::max());
}

void Experiment::advance_to_strain(double strain) {
    const auto end = static_cast<std::int64_t>(strain / model.shear_rate + 0.5);
    advance_by(end - state.step);
}

VectorField<> simple_shear(const Lattice& lattice, double rate) {
    VectorField<> velocity(lattice);
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) velocity.x(i, j) = rate * (j + 0.5 - 0.5 * lattice.ny);
    }
    return velocity;
}

Model plain_model(const Lattice& lattice, double viscosity) {
    Model m;
    m.lattice = lattice;
    m.viscosity.plasma = viscosity;
    m.viscosity.cytoplasm = {viscosity};
    m.viscosity.layer_viscosity = viscosity;
    m.viscosity.interface = AreaFraction{};
    m.viscosity.mean = HarmonicMean{};
    return m;
}

}  // namespace tt
