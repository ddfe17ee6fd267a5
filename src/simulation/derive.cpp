#include "simulation/derive.hpp"

#include "fluid/moments.hpp"
#include "simulation/drive.hpp"

namespace tt {

namespace {

/// u = Σ f c + ½ F of the uniform force: what an observer sees before the first step. A step would
/// add that of the membranes.
template <class Real>
void fill_velocity(const Populations<Real>& populations, Vec2 body_force, const Walls* walls,
                   VectorField<Real>& velocity) {
    const Lattice& lattice = populations.lattice();
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) {
            if (walls && !walls->is_open(i, j)) continue;
            const Vec2 momentum = moments(populations, i, j).momentum;
            velocity.x(i, j) = static_cast<Real>(momentum.x + 0.5 * body_force.x);
            velocity.y(i, j) = static_cast<Real>(momentum.y + 0.5 * body_force.y);
        }
    }
}

template <class Real>
void derive(const Model& model, Sites<Real>& sites, State& state) {
    const Lattice& lattice = model.lattice;
    sites.velocity = VectorField<Real>(lattice);
    const Walls* const walls = model.boundaries.walls.get();
    state.ports.resize(model.boundaries.ports.size());
    state.sections.resize(model.sections.size());
    follow_waves(model, state);
    fill_velocity(sites.populations, state.drive.body_force * model.drive.direction, walls,
                  sites.velocity);
    sites.borders = walls ? Borders<Real>(*walls, sites.populations) : Borders<Real>();
    sites.relaxation = Relaxation<Real>(lattice);
    sites.stencils = Stencils<Real>(state.cells.node_count());
    locate(model.delta, lattice, state.cells, sites.stencils);
    sites.cut.of_cell.resize(state.cells.cell_count());
    if (walls) cut_at_walls(*walls, state.cells, sites.stencils, sites.cut);
    if (state.interior.x.size() == state.cells.x.size())  // kept by a checkpoint
        restore_viscosity(model.viscosity, state.cells, state.interior, sites.relaxation);
    else
        rebuild_viscosity(model.viscosity, state.cells, state.interior, sites.relaxation);
}

}  // namespace

Field<> density_of_drop(const Model& model) {
    const Lattice& lattice = model.lattice;
    const double drop = model.boundaries.pressure_drop / d2q9::sound_speed_squared;
    Field<> density(lattice);
    for (int j = 0; j < lattice.ny; ++j)
        for (int i = 0; i < lattice.nx; ++i) density(i, j) = (0.5 - (i + 0.5) / lattice.nx) * drop;
    return density;
}

void start_flow(const Model& model, const VectorField<>& velocity, const Field<>& density,
                State& state) {
    state.sites = sites_at_rest(model.lattice, model.precision);
    std::visit(
        [&](auto& sites) {
            set_equilibrium(model.equilibrium, velocity, density, sites.populations);
        },
        state.sites);
}

void derive_kept(const Model& model, State& state) {
    // `derive` lays the cytoplasm where the nodes are now; the run goes on from where it was last
    // laid.
    const std::vector<double> x = state.interior.x;
    const std::vector<double> y = state.interior.y;
    derive(model, state);
    state.interior.x = x;
    state.interior.y = y;
    std::visit(
        [&](auto& sites) {
            restore_viscosity(model.viscosity, state.cells, state.interior, sites.relaxation);
        },
        state.sites);
}

void derive_changed(const Model& model, State& state) {
    const ContactState contact = state.contact;
    state.contact = {};
    state.contact.repulsion_count = contact.repulsion_count;
    state.contact.smallest_gap = contact.smallest_gap;
    derive_kept(model, state);
}

void derive(const Model& model, State& state) {
    std::visit([&](auto& sites) { derive(model, sites, state); }, state.sites);
}

}  // namespace tt
