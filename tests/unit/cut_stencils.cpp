#include "coupling/cut_stencils.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "coupling/delta/delta.hpp"
#include "exchange/periodic.hpp"
#include "membrane/suspension.hpp"

namespace tt {
namespace {

const Lattice box{30, 24, true};

/// A wedge from the bottom wall and a post across the ends of the box.
Walls wedge_and_post() {
    Solid solid;
    solid.period_x = box.nx;
    solid.loops = {{{8.3, -3}, {13.7, 11.4}, {20.1, -3}},
                   {{-2.7, 9.1}, {2.4, 8.2}, {3.3, 15.6}, {-1.8, 16.3}}};
    return make_walls(solid, box);
}

/// Nodes with forces and dipoles, half a site and more from every wall.
Suspension nodes_beside(const Walls& walls) {
    Random random(5);
    std::vector<Vec2> places;
    while (places.size() < 200) {
        const Vec2 p{random.uniform(0.0, box.nx), random.uniform(0.5, box.ny - 0.5)};
        const double away = walls.distance_at(p);
        if (away > 0.5 && away < 3.0) places.push_back(p);
    }
    Suspension cells;
    std::vector<Vec2> ring;  // any outline: what counts are its nodes
    for (int k = 0; k < 200; ++k)
        ring.push_back(Vec2{10 * std::cos(0.01 * k), 10 * std::sin(0.01 * k)});
    add_cell(cells, ring);
    for (int n = 0; n < 200; ++n) {
        cells.x[n] = places[n].x, cells.y[n] = places[n].y;
        cells.fx[n] = random.uniform(-1.0, 1.0), cells.fy[n] = random.uniform(-1.0, 1.0);
        cells.dipole_xx[n] = random.uniform(-1.0, 1.0);
        cells.dipole_xy[n] = random.uniform(-1.0, 1.0);
    }
    return cells;
}

struct Coupled {
    Walls walls = wedge_and_post();
    Suspension cells = nodes_beside(walls);
    Stencils<> stencils{cells.node_count()};
    CutStencils<> cut;

    Coupled() {
        locate(Roma3{}, box, cells, stencils);
        cut.of_cell.resize(1);
        cut_at_walls(walls, cells, stencils, cut);
    }
    VectorField<> spread_all(Order order) {
        VectorField<> force(box);
        spread(order, stencils, cells, force);
        spread_cut(order, cut, cells, force);
        return force;
    }
    void interpolate_all(Order order, const VectorField<>& velocity) {
        interpolate(order, stencils, velocity, cells, 0);
        interpolate_cut(order, cut, velocity, cells, 0);
    }
};

TEST(CutStencils, put_no_force_into_a_wall_and_keep_its_sum_and_torque) {
    Coupled c;
    ASSERT_GT(c.cut.of_cell[0].size(), 30u);
    const VectorField<> force = c.spread_all(Order::zeroth);
    Vec2 on_nodes, on_sites;
    double torque = 0.0;
    for (int n = 0; n < c.cells.node_count(); ++n) {
        on_nodes += c.cells.force(n);
        torque += cross(c.cells.position(n), c.cells.force(n));
    }
    for (int j = -2; j < box.ny + 2; ++j)
        for (int i = -2; i < box.nx + 2; ++i) {
            on_sites += force(i, j);
            torque -= cross(Lattice::position(i, j), force(i, j));
            if (!c.walls.open(i, j)) {
                EXPECT_EQ(norm(force(i, j)), 0.0) << i << " " << j;
            }
        }
    EXPECT_NEAR(on_sites.x, on_nodes.x, 1e-11);
    EXPECT_NEAR(on_sites.y, on_nodes.y, 1e-11);
    EXPECT_NEAR(torque, 0.0, 1e-9);
}

TEST(CutStencils, take_a_linear_velocity_and_its_rates_exactly) {
    Coupled c;
    VectorField<> velocity(box);
    // Not over the ends of the box: what is linear is not periodic.
    for (int j = -2; j < box.ny + 2; ++j)
        for (int i = -2; i < box.nx + 2; ++i) {
            const Vec2 p = Lattice::position(i, j);
            velocity.x(i, j) = 0.1 + 0.02 * p.x - 0.03 * p.y;
            velocity.y(i, j) = -0.2 + 0.05 * p.x - 0.02 * p.y;
        }
    c.interpolate_all(Order::first, velocity);
    for (const auto& cut : c.cut.of_cell[0]) {
        const Vec2 p = c.cells.position(cut.node);
        if (p.x < 4.0 || p.x > 26.0) continue;
        EXPECT_NEAR(c.cells.ux[cut.node], 0.1 + 0.02 * p.x - 0.03 * p.y, 1e-12);
        EXPECT_NEAR(c.cells.uy[cut.node], -0.2 + 0.05 * p.x - 0.02 * p.y, 1e-12);
        EXPECT_NEAR(c.cells.rate_xx[cut.node], 0.04, 1e-10);
        EXPECT_NEAR(c.cells.rate_xy[cut.node], 0.02, 1e-10);
    }
}

TEST(CutStencils, give_the_power_that_they_take) {
    Coupled c;
    const VectorField<> force = c.spread_all(Order::first);
    VectorField<> velocity(box);
    Random random(7);
    for (int j = -2; j < box.ny + 2; ++j)
        for (int i = -2; i < box.nx + 2; ++i) {
            velocity.x(i, j) = random.uniform(-1.0, 1.0);
            velocity.y(i, j) = random.uniform(-1.0, 1.0);
        }
    c.interpolate_all(Order::first, velocity);
    double power = 0.0;
    for (int j = -2; j < box.ny + 2; ++j)
        for (int i = -2; i < box.nx + 2; ++i) power -= dot(force(i, j), velocity(i, j));
    for (int n = 0; n < c.cells.node_count(); ++n)
        power += dot(c.cells.force(n), {c.cells.ux[n], c.cells.uy[n]}) +
                 c.cells.dipole_xx[n] * c.cells.rate_xx[n] +
                 c.cells.dipole_xy[n] * c.cells.rate_xy[n];
    EXPECT_NEAR(power, 0.0, 1e-10);
}

}  // namespace
}  // namespace tt
