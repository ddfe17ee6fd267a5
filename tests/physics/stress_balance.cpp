#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "exchange/periodic.hpp"
#include "observe/cell_measures.hpp"
#include "observe/run_measures.hpp"
#include "simulation/advance.hpp"

namespace tt {
namespace {

/// One soft cell between walls four radii apart, in shear, on a coarse lattice.
Case sheared_cell(double viscosity_ratio) {
    Case c;
    c.domain.length = Length{20e-6};
    c.domain.width = Length{16e-6};
    c.flow.drive = ShearDrive{{}, 0.1};
    c.cells.count = 1;
    c.cells.cytoplasm_viscosity.si = viscosity_ratio * c.plasma.viscosity.si;
    c.membrane.hardening.apply_to.clear();
    c.contact.model = NoContact{};
    c.numerics.dx = Length{0.5e-6};
    return c;
}

struct ShearedCell {
    Model model;
    State state;
    Periodic periodic;

    explicit ShearedCell(const Case& c) : model(discretise(c)), state(initial_state(c, model)) {}
    void until(double strain) {
        while (static_cast<double>(state.step) * model.shear_rate < strain) {
            advance(model, state, periodic);
        }
    }
};

TEST(StressBalance, wall_stress_and_the_balance_of_momentum_agree_once_a_cell_tank_treads) {
    for (double ratio : {1.0, 5.0}) {
        ShearedCell run(sheared_cell(ratio));
        run.until(ratio == 1.0 ? 8.0 : 16.0);
        const RunMeasures m =
            measure_run(run.model, run.state, measure_cells(run.model, run.state));
        const double balance = m.balance_shear_stress.si / m.wall_shear_stress.si;
        fmt::print("ratio {}: D {:.3f}, mu_rel {:.4f} by the walls, {:.4f} by the balance\n", ratio,
                   m.taylor_inertia, m.mu_rel, m.mu_rel * balance);
        EXPECT_GT(m.mu_rel, 1.05);
        // Across the jump of viscosity ν ∇u of the sites is not quite the lattice's own stress.
        EXPECT_NEAR(balance, 1.0, ratio == 1.0 ? 1e-3 : 2.5e-2);
    }
}

TEST(TankTreading, phase_rate_gives_the_time_in_which_a_node_goes_round) {
    ShearedCell run(sheared_cell(1.0));
    run.until(10.0);
    const Suspension& cells = run.state.cells;
    const auto arm = [&] { return cells.position(0) - area_moments(outline(cells, 0)).centroid; };
    double turned = 0.0, phase = 0.0;
    const auto start = run.state.step;
    while (turned > -2.0 * std::numbers::pi) {
        const Vec2 before = arm();
        const double rate = measure_cell(run.model, run.state, 0).phase_rate.si;
        constexpr int steps = 5;
        for (int k = 0; k < steps; ++k) advance(run.model, run.state, run.periodic);
        phase += steps * rate * run.model.scales.time;
        const Vec2 after = arm();
        turned += std::atan2(cross(before, after), dot(before, after));
    }
    const double period = static_cast<double>(run.state.step - start) * run.model.shear_rate;
    const double by_rate = 2.0 * std::numbers::pi * period / -phase;
    fmt::print("kT {:.3f} by following a node, {:.3f} by the phase rate\n", period, by_rate);
    EXPECT_NEAR(by_rate / period, 1.0, 2e-3);
}

}  // namespace
}  // namespace tt
