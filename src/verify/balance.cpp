#include "verify/balance.hpp"

#include <cmath>
#include <filesystem>

#include "coupling/jump.hpp"
#include "fluid/moments.hpp"
#include "io/temporary_folder.hpp"
#include "membrane/shapes.hpp"
#include "simulation/state_archive.hpp"

namespace tt {
namespace {

constexpr std::int64_t steps = 60;

/// Momentum of the fluid and its mass beyond density 1.
struct Sums {
    Vec2 momentum;
    double mass = 0.0;
};

Sums sums_of(const Experiment& e) {
    Sums sums;
    for (int j = 0; j < e.model.lattice.ny; ++j) {
        for (int i = 0; i < e.model.lattice.nx; ++i) {
            const Moments m = e.state.moments(i, j);
            sums.momentum += m.momentum;
            sums.mass += m.density_deviation;
        }
    }
    return sums;
}

}  // namespace

Experiment crowded_shear(int threads) {
    Model m = plain_model({61, 43, true}, 1.0 / 3.0);
    m.viscosity.cytoplasm = {5.0 / 3.0};
    m.kinds[0].jump = jump_correction(m.delta, m.viscosity.plasma, m.viscosity.cytoplasm[0]);
    m.kinds[0].membrane.in_plane = NeoHookean{0.02};
    m.kinds[0].membrane.bending = CurrentCurvature{0.01};
    m.kinds[0].membrane.hardening = hardened_throughout(0.55, 16.0);
    m.kinds[0].membrane.area_stiffness = 1.0;
    m.kinds[0].membrane.hold_area = true;
    m.contact.law = Morse{1e-4, 0.8, 2.0, true};
    m.contact.range = 6.0;
    m.shear_rate = 2e-3;
    m.boundaries = {-0.5 * 43 * m.shear_rate, 0.5 * 43 * m.shear_rate, 0.0};
    m.threads = threads;
    Suspension cells;
    add_cell(cells, placed(biconcave(13.0, 63), 0.4, {16.3, 20.8}));
    add_cell(cells, placed(circle(9.4, 59), 0.0, {42.6, 22.4}));
    return Experiment(m, cells, simple_shear(m.lattice, m.shear_rate));
}

Drift drift_of_relaxing_cell() {
    Model m = plain_model({48, 40, false}, 1.0 / 6.0);
    m.viscosity.cytoplasm = {5.0 / 6.0};
    m.kinds[0].jump = jump_correction(m.delta, m.viscosity.plasma, m.viscosity.cytoplasm[0]);
    m.kinds[0].membrane.in_plane = NeoHookean{0.02};
    m.kinds[0].membrane.bending = CurrentCurvature{0.01};
    m.kinds[0].membrane.area_stiffness = 0.5;
    Suspension cells;
    add_cell(cells, placed(circle(9.0, 57), 0.0, {23.7, 20.2}));
    for (double& x : cells.x) x = 23.7 + 1.25 * (x - 23.7);
    for (double& y : cells.y) y = 20.2 + 0.8 * (y - 20.2);
    Experiment relaxing(m, cells);
    relaxing.advance_by(1);
    double force = 0.0;
    for (int n = 0; n < cells.node_count(); ++n) force += norm(relaxing.state.cells.force(n));
    relaxing.advance_by(99);
    const Sums sums = sums_of(relaxing);
    return {norm(sums.momentum) / force, sums.mass / (double(m.lattice.nx) * m.lattice.ny)};
}

bool same_bits_on_threads(int threads) {
    Experiment one = crowded_shear(1), many = crowded_shear(threads);
    one.advance_by(steps);
    many.advance_by(steps);
    return state_hash(one.state) == state_hash(many.state);
}

bool same_bits_after_restart() {
    Experiment straight = crowded_shear(1), stopped = crowded_shear(1);
    straight.advance_by(steps);
    stopped.advance_by(steps / 2 - 1);  // an odd step: the populations' other phase
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "state";
    {
        ArchiveWriter archive(path);
        save_state(archive, stopped.state);
        archive.commit();
    }
    stopped.state = load_state(ArchiveReader(path), stopped.model, stopped.ends);
    stopped.advance_by(steps - stopped.state.step);
    return state_hash(straight.state) == state_hash(stopped.state);
}

}  // namespace tt
