#include "membrane/viscosity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

constexpr double plasma_viscosity = 0.3;

/// An ellipse with unequal segments.
Suspension cell(int nodes = 61) {
    Suspension cells;
    add_cell(cells, placed(ellipse(9.0, 6.0, nodes), 0.4, {20.0, 15.0}));
    Random random(5);
    for (int n = 0; n < nodes; ++n) {
        cells.x[n] += random.uniform(-0.05, 0.05);
        cells.y[n] += random.uniform(-0.05, 0.05);
    }
    return cells;
}

/// Steps without moving the nodes until tension and moment have settled.
void settle(const MembraneViscosity& viscosity, Suspension& cells) {
    for (int n = 0; n < 12000; ++n) {
        for (auto* force : {&cells.fx, &cells.fy}) std::fill(force->begin(), force->end(), 0.0);
        add_viscous_forces(viscosity, plasma_viscosity, cells, 0);
    }
}

void set_velocities(Suspension& cells, std::uint64_t seed) {
    Random random(seed);
    for (int n = 0; n < cells.node_count(); ++n) {
        cells.ux[n] = 1e-3 * cells.y[n] + random.uniform(-1e-4, 1e-4);
        cells.uy[n] = random.uniform(-1e-4, 1e-4);
    }
}

TEST(MembraneViscosity, tension_is_that_of_the_rate_of_stretching_once_settled) {
    for (const double viscosity : {0.5, 5.0}) {
        Suspension cells = cell();
        set_velocities(cells, 3);
        settle({viscosity, 0.0}, cells);
        for (int k = 0; k < cells.node_count(); ++k) {
            const int next = k + 1 < cells.node_count() ? k + 1 : 0;
            const Vec2 edge = cells.position(next) - cells.position(k);
            const double rate =
                dot(edge, cells.velocity(next) - cells.velocity(k)) / dot(edge, edge);
            ASSERT_NEAR(cells.viscous_tension[k], viscosity * rate, 1e-9 * viscosity) << k;
        }
    }
}

TEST(MembraneViscosity, moment_is_that_of_the_rate_of_bending_once_settled) {
    for (const double viscosity : {0.05, 0.5}) {
        Suspension cells = cell();
        set_velocities(cells, 4);
        settle({0.0, viscosity}, cells);
        const int count = cells.node_count();
        const auto spin = [&](int k) {
            const int from = (k + count) % count, to = (from + 1) % count;
            const Vec2 edge = cells.position(to) - cells.position(from);
            return cross(edge, cells.velocity(to) - cells.velocity(from)) / dot(edge, edge);
        };
        for (int k = 0; k < count; ++k) {
            const Vec2 here = cells.position(k);
            const double arc = 0.5 * (norm(cells.position((k + 1) % count) - here) +
                                      norm(here - cells.position((k + count - 1) % count)));
            ASSERT_NEAR(cells.viscous_moment[k], viscosity * (spin(k) - spin(k - 1)) / arc,
                        1e-8 * viscosity)
                << k;
        }
    }
}

TEST(MembraneViscosity, forces_and_torques_sum_to_zero_and_take_the_power_that_is_dissipated) {
    const MembraneViscosity viscosity{1.0, 0.5};
    Suspension cells = cell();
    set_velocities(cells, 6);
    settle(viscosity, cells);
    Vec2 force;
    double torque = 0.0, power = 0.0;
    for (int n = 0; n < cells.node_count(); ++n) {
        force += cells.force(n);
        torque += cross(cells.position(n), cells.force(n));
        power += dot(cells.velocity(n), cells.force(n));
    }
    EXPECT_NEAR(norm(force), 0.0, 1e-14);
    EXPECT_NEAR(torque, 0.0, 1e-13);
    EXPECT_LT(power, 0.0);
    EXPECT_NEAR(-power / viscous_dissipation(viscosity, cells, 0), 1.0, 1e-9);
}

TEST(MembraneViscosity, does_nothing_to_a_cell_that_moves_as_a_rigid_body) {
    Suspension cells = cell();
    for (int n = 0; n < cells.node_count(); ++n) {
        cells.ux[n] = 0.01 - 2e-3 * cells.y[n];
        cells.uy[n] = -0.02 + 2e-3 * cells.x[n];
    }
    settle({10.0, 10.0}, cells);
    for (int n = 0; n < cells.node_count(); ++n) EXPECT_NEAR(norm(cells.force(n)), 0.0, 1e-13);
}

TEST(MembraneViscosity, of_a_circle_that_swells_is_as_in_theory) {
    // ∂u/∂s = U/R all round: T = η U/R, and T/R inwards per length.
    Suspension cells;
    constexpr int nodes = 400;
    constexpr double radius = 20.0, speed = 1e-3, eta = 5.0;
    add_cell(cells, circle(radius, nodes));
    for (int n = 0; n < nodes; ++n) {
        cells.ux[n] = speed * cells.x[n] / radius;
        cells.uy[n] = speed * cells.y[n] / radius;
    }
    settle({eta, 0.0}, cells);
    const double arc = 2.0 * std::numbers::pi * radius / nodes;
    for (int n = 0; n < nodes; n += 37) {
        const Vec2 outward = cells.position(n) / radius;
        EXPECT_NEAR(-dot(cells.force(n), outward) / arc, eta * speed / (radius * radius), 2e-8);
    }
}

}  // namespace
}  // namespace tt
