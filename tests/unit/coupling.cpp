#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "coupling/stencil.hpp"
#include "exchange/periodic.hpp"
#include "membrane/shapes.hpp"

using namespace tt;

namespace {

constexpr Lattice box{48, 24, true};

/// Nodes strewn over the channel, as near to the walls as a tenth of a site, with random forces.
Suspension strewn(std::uint64_t seed, double margin = 0.1) {
    Suspension cells;
    add_cell(cells, placed(circle(5.0, 60), 0.0, {24.0, 12.0}));
    Random random(seed);
    for (int n = 0; n < cells.node_count(); ++n) {
        cells.x[n] = random.uniform(2.0, box.nx - 2.0);
        cells.y[n] = random.uniform(margin, box.ny - margin);
        cells.fx[n] = random.uniform(-1.0, 1.0);
        cells.fy[n] = random.uniform(-1.0, 1.0);
    }
    return cells;
}

struct Kernel {
    Delta delta;
    bool first_moment_vanishes;
    const char* name;
};

class EveryKernel : public testing::TestWithParam<Kernel> {};

TEST_P(EveryKernel, force_on_sites_equals_force_on_nodes_up_to_the_wall) {
    const Suspension cells = strewn(1);
    Stencils stencils(cells.node_count());
    VectorField force(box);
    locate(GetParam().delta, box, cells, stencils);
    spread(Order::zeroth, stencils, cells, force);
    Vec2 on_nodes, on_sites;
    double torque_on_nodes = 0.0, torque_on_sites = 0.0;
    for (int n = 0; n < cells.node_count(); ++n) {
        on_nodes += cells.force(n);
        torque_on_nodes += cross(cells.position(n), cells.force(n));
    }
    for (int j = 0; j < box.ny; ++j) {
        for (int i = -2; i < box.nx + 2; ++i) {
            on_sites += force(i, j);
            torque_on_sites += cross(Lattice::position(i, j), force(i, j));
        }
    }
    EXPECT_NEAR(on_sites.x, on_nodes.x, 1e-12);
    EXPECT_NEAR(on_sites.y, on_nodes.y, 1e-12);
    // The paper's cosine misses the first moment by up to 0.021 sites in each direction.
    const double tolerance =
        GetParam().first_moment_vanishes ? 1e-11 : 0.021 * 2.0 * cells.node_count();
    EXPECT_NEAR(torque_on_sites, torque_on_nodes, tolerance);
}

TEST_P(EveryKernel, spread_and_interpolate_are_adjoint) {
    // Σ_nodes F·U(u) = Σ_sites f(F)·u for every force and velocity: the power put in is the power
    // taken out.
    Suspension cells = strewn(2);
    Stencils stencils(cells.node_count());
    VectorField force(box), velocity(box);
    Random random(3);
    for (int j = 0; j < box.ny; ++j) {
        for (int i = -2; i < box.nx + 2; ++i) {
            velocity.x(i, j) = random.uniform(-1.0, 1.0);
            velocity.y(i, j) = random.uniform(-1.0, 1.0);
        }
    }
    locate(GetParam().delta, box, cells, stencils);
    spread(Order::zeroth, stencils, cells, force);
    for (int c = 0; c < cells.cell_count(); ++c)
        interpolate(Order::first, stencils, velocity, cells, c);
    double power_of_nodes = 0.0, power_of_sites = 0.0;
    for (int n = 0; n < cells.node_count(); ++n)
        power_of_nodes += dot(cells.force(n), cells.velocity(n));
    for (int j = 0; j < box.ny; ++j) {
        for (int i = -2; i < box.nx + 2; ++i) power_of_sites += dot(force(i, j), velocity(i, j));
    }
    EXPECT_NEAR(power_of_nodes, power_of_sites, 1e-12);
}

TEST_P(EveryKernel, linear_velocity_is_interpolated_exactly_up_to_the_wall) {
    if (!GetParam().first_moment_vanishes) return;
    Suspension cells = strewn(4, 0.05);
    Stencils stencils(cells.node_count());
    VectorField velocity(box);
    for (int j = -2; j < box.ny + 2; ++j) {
        for (int i = -2; i < box.nx + 2; ++i) {
            velocity.x(i, j) = 0.3 + 0.02 * (j + 0.5);
            velocity.y(i, j) = -0.1 + 0.01 * (i + 0.5);
        }
    }
    locate(GetParam().delta, box, cells, stencils);
    for (int c = 0; c < cells.cell_count(); ++c)
        interpolate(Order::first, stencils, velocity, cells, c);
    for (int n = 0; n < cells.node_count(); ++n) {
        EXPECT_NEAR(cells.ux[n], 0.3 + 0.02 * cells.y[n], 1e-12);
        EXPECT_NEAR(cells.uy[n], -0.1 + 0.01 * cells.x[n], 1e-12);
        EXPECT_NEAR(cells.rate_xx[n], 0.0, 1e-12);
        EXPECT_NEAR(cells.rate_xy[n], 0.02 + 0.01, 1e-12);
    }
}

TEST_P(EveryKernel, gives_the_same_bits_for_any_number_of_threads) {
    Suspension cells = strewn(6);
    Stencils stencils(cells.node_count());
    VectorField one(box);
    locate(GetParam().delta, box, cells, stencils);
    spread(Order::zeroth, stencils, cells, one);
    for (int threads : {2, 3, 7}) {
        VectorField many(box);
        Stencils shared(cells.node_count());
        with_team(threads, [&] {
            locate(GetParam().delta, box, cells, shared);
            spread(Order::zeroth, shared, cells, many);
        });
        for (std::size_t k = 0; k < one.x.size(); ++k) {
            ASSERT_EQ(one.x.data()[k], many.x.data()[k]);
            ASSERT_EQ(one.y.data()[k], many.y.data()[k]);
        }
    }
}

TEST_P(EveryKernel, blocks_of_nodes_on_the_ends_of_the_box_lie_on_sites_and_halo) {
    // Whatever rounding makes of a position just outside: wrapped, −10⁻¹⁸ becomes the far end
    // itself.
    for (const Lattice& other : {Lattice{24, 12, true}, Lattice{24, 12, false}}) {
        Suspension cells;
        add_cell(cells, placed(circle(3.0, 40), 0.0, {12.0, 6.0}));
        const double tiny = 1e-18, small = 1e-14;
        const std::array<double, 8> shares{0.0, -tiny, tiny, small, -small, 1.0, 1.0 - 1e-16, 0.5};
        for (int n = 0; n < cells.node_count(); ++n) {
            cells.x[n] = other.nx * (shares[n % 8] + (n % 3 - 1));
            const double y = shares[n / 5];
            cells.y[n] = other.ny * (other.walls ? std::clamp(y, 0.0, 1.0) : y);
        }
        Stencils stencils(cells.node_count());
        locate(GetParam().delta, other, cells, stencils);
        constexpr int width = Stencils<>::width;
        for (int n = 0; n < cells.node_count(); ++n) {
            EXPECT_GE(stencils.i[n], -Lattice::halo);
            EXPECT_LE(stencils.i[n] + width, other.nx + Lattice::halo);
            EXPECT_GE(stencils.j[n], -Lattice::halo);
            EXPECT_LE(stencils.j[n] + stencils.points, other.ny + Lattice::halo);
            double along_x = 0.0, along_y = 0.0;
            for (int k = 0; k < width; ++k) {
                along_x += stencils.wx[width * n + k];
                along_y += stencils.wy[width * n + k];
            }
            EXPECT_NEAR(along_x, 1.0, 1e-12) << cells.x[n];
            EXPECT_NEAR(along_y, 1.0, 1e-12) << cells.y[n];
        }
    }
}

TEST(Cosine4, has_the_weights_of_its_formula) {
    for (double s = 0.0; s < 1.0; s += 0.01) {
        double w[4], slope[4];
        Cosine4::weights(1.0 + s, w, slope);
        for (int k = 0; k < 4; ++k)
            EXPECT_NEAR(w[k], 0.25 * (1.0 + std::cos(0.5 * M_PI * (k - 1 - s))), 1e-15);
    }
}

TEST(FourPointKernels, do_not_see_the_staggered_mode) {
    // Stripes (−1)^x of velocity are conserved by the lattice fluid: neither forces nor rates may
    // couple to them.
    for (double s = 0.0; s < 1.0; s += 0.013) {
        for (const Delta& delta : {Delta{Peskin4{}}, Delta{Cosine4{}}}) {
            double w[4], slope[4];
            std::visit([&](const auto& kernel) { kernel.weights(1.0 + s, w, slope); }, delta);
            EXPECT_NEAR(w[0] + w[2], 0.5, 1e-14);
            EXPECT_NEAR(w[1] + w[3], 0.5, 1e-14);
            EXPECT_NEAR(slope[0] + slope[2], 0.0, 1e-14);
            EXPECT_NEAR(slope[1] + slope[3], 0.0, 1e-14);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Delta, EveryKernel,
                         testing::Values(Kernel{Cosine4{}, false, "cosine4"},
                                         Kernel{Hat2{}, true, "hat2"},
                                         Kernel{Roma3{}, true, "roma3"},
                                         Kernel{Peskin4{}, true, "peskin4"}),
                         [](const auto& kernel) { return kernel.param.name; });

}  // namespace
