#include "membrane/rigid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "membrane/node_mobility.hpp"
#include "membrane/outline.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

/// With nodes at unequal distances.
Suspension rigid_ellipse(int nodes = 47) {
    Suspension cells;
    std::vector<Vec2> points;
    Random random(3);
    for (int k = 0; k < nodes; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + random.uniform(-0.2, 0.2)) / nodes;
        points.push_back({30.0 + 9.0 * std::cos(angle), 20.0 + 5.0 * std::sin(angle)});
    }
    add_cell(cells, points);
    return cells;
}

void set_random_velocities(Suspension& cells, std::uint64_t seed) {
    Random random(seed);
    for (int n = 0; n < cells.node_count(); ++n) {
        cells.ux[n] = random.uniform(-1e-2, 1e-2) + 2e-3 * cells.y[n];
        cells.uy[n] = random.uniform(-1e-2, 1e-2);
    }
}

TEST(RigidBodies, keep_their_shape_and_their_loads_sum_to_zero_however_they_turn) {
    Suspension cells = rigid_ellipse();
    const Suspension start = cells;
    double turned = 0.0;
    for (int step = 0; step < 400; ++step) {
        set_random_velocities(cells, static_cast<std::uint64_t>(step));
        const Vec2 before = cells.position(1) - cells.position(0);
        move_rigidly(node_mobility(0.3), cells, 0);
        const Vec2 after = cells.position(1) - cells.position(0);
        turned += std::atan2(cross(before, after), dot(before, after));
    }
    EXPECT_GT(std::abs(turned), 0.2);
    for (int n = 0; n < cells.node_count(); ++n)
        for (int other = 0; other < n; ++other)
            ASSERT_NEAR(norm(cells.position(n) - cells.position(other)),
                        norm(start.position(n) - start.position(other)), 1e-10);
    set_rigid_forces(cells, 0);
    Vec2 force;
    double torque = 0.0, scale = 0.0;
    const Vec2 middle = middle_of(outline(cells, 0));
    for (int n = 0; n < cells.node_count(); ++n) {
        force += cells.force(n);
        torque += cross(cells.position(n) - middle, cells.force(n));
        scale += norm(cells.force(n));
    }
    EXPECT_GT(scale, 0.1);
    EXPECT_LT(norm(force), 1e-12 * scale);
    EXPECT_LT(std::abs(torque), 1e-11 * scale);
}

TEST(RigidBodies, that_move_rigidly_already_are_left_alone) {
    Suspension cells = rigid_ellipse();
    const Vec2 centre{11.0, -4.0};
    for (int n = 0; n < cells.node_count(); ++n) {
        const Vec2 arm = cells.position(n) - centre;
        cells.ux[n] = 0.02 - 0.003 * arm.y;
        cells.uy[n] = -0.01 + 0.003 * arm.x;
    }
    const Suspension before = cells;
    move_rigidly(node_mobility(0.3), cells, 0);
    for (int n = 0; n < cells.node_count(); ++n) {
        EXPECT_NEAR(cells.ux[n], before.ux[n], 1e-14);
        EXPECT_NEAR(cells.uy[n], before.uy[n], 1e-14);
        EXPECT_NEAR(cells.rigid_fx[n], 0.0, 1e-14);
        EXPECT_NEAR(cells.rigid_fy[n], 0.0, 1e-14);
    }
}

TEST(RigidBodies, are_loaded_against_what_would_deform_them) {
    Suspension cells = rigid_ellipse();
    for (int n = 0; n < cells.node_count(); ++n) cells.ux[n] = 1e-3 * (cells.y[n] - 20.0);
    const Suspension before = cells;
    move_rigidly(node_mobility(0.3), cells, 0);
    set_rigid_forces(cells, 0);
    double power = 0.0;
    for (int n = 0; n < cells.node_count(); ++n) power += dot(cells.force(n), before.velocity(n));
    EXPECT_LT(power, -1e-6);
}

}  // namespace
}  // namespace tt
