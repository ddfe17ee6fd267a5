#include <gtest/gtest.h>

#include <cstdio>

#include "flow.hpp"

namespace {

using namespace tt;

constexpr int length = 10;
constexpr int height = 9;
constexpr double drop = 1e-3;

Flow driven(const Equilibrium& equilibrium, double pressure_drop, double body_force) {
    Flow flow({length, height, true});
    flow.equilibrium = equilibrium;
    flow.boundaries.pressure_drop = pressure_drop;
    flow.body_force.x = body_force;
    flow.run(4000);
    return flow;
}

/// max |u − v| / max |v|.
double difference(const Flow& a, const Flow& b) {
    double worst = 0.0;
    double largest = 0.0;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < length; ++i) {
            worst = std::max(worst, norm(a.velocity(i, j) - b.velocity(i, j)));
            largest = std::max(largest, norm(b.velocity(i, j)));
        }
    }
    return worst / largest;
}

TEST(PressureEnds, drive_the_same_flow_as_a_body_force) {
    for (const Equilibrium& equilibrium :
         {Equilibrium{LinearEquilibrium{}}, Equilibrium{IncompressibleEquilibrium{}}}) {
        const Flow by_pressure = driven(equilibrium, drop, 0.0);
        const Flow by_force = driven(equilibrium, 0.0, drop / length);
        std::printf("pressure ends against body force: %.1e\n", difference(by_pressure, by_force));
        EXPECT_LT(difference(by_pressure, by_force), 1e-13);
    }
}

TEST(PressureEnds, pressure_falls_evenly_from_inlet_to_outlet) {
    const Flow flow = driven(LinearEquilibrium{}, drop, 0.0);
    const double step = -3.0 * drop / length;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < length; ++i) {
            const double expected = (i - 0.5 * (length - 1)) * step;
            EXPECT_NEAR(moments(flow.populations, i, j).density_deviation, expected, 1e-12);
        }
    }
}

TEST(PressureEnds, compressible_flow_keeps_the_momentum_and_is_off_by_half_the_density_drop) {
    const Flow by_pressure = driven(FullEquilibrium{}, drop, 0.0);
    const Flow by_force = driven(FullEquilibrium{}, 0.0, drop / length);
    const double relative = difference(by_pressure, by_force) / (3.0 * drop);
    std::printf("compressible: velocity off by %.3f of the density drop\n", relative);
    EXPECT_LT(relative, 0.5);
    EXPECT_GT(relative, 0.4);
    double worst = 0.0;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < length; ++i) {
            const Vec2 momentum = moments(by_pressure.populations, i, j).momentum;
            worst = std::max(worst, norm(momentum - by_force.velocity(i, j)) /
                                        by_force.velocity.x(i, height / 2));
        }
    }
    std::printf("compressible: momentum off by %.1e of itself\n", worst);
    EXPECT_LT(worst, 9.0 * drop * drop);
}

}  // namespace
