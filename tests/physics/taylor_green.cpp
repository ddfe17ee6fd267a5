#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <numbers>

#include "flow.hpp"
#include "fluid/analytic.hpp"

namespace {

using namespace tt;

/// Relative error of vortices in a box of `size` × `size` sites, velocity ∝ 1/size, after they
/// decayed to 1/e.
double decay_error(const Equilibrium& equilibrium, int size) {
    constexpr double viscosity = 0.1;
    Flow flow({size, size, false});
    flow.equilibrium = equilibrium;
    flow.set_viscosity([](int) { return viscosity; });
    const double w = 2.0 * std::numbers::pi / size;
    const double speed = 0.32 / size;
    const auto exact = [&](int i, int j, double time) {
        return analytic::taylor_green(Lattice::position(i, j), {w, w}, speed, viscosity, time);
    };
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const Vec2 u = exact(i, j, 0.0);
            flow.velocity.x(i, j) = u.x;
            flow.velocity.y(i, j) = u.y;
        }
    }
    set_equilibrium(equilibrium, flow.velocity, Field<>(flow.lattice), flow.populations);
    // Without its pressure Navier–Stokes flow would start with sound waves, a relative error of the
    // order of Ma.
    if (equilibrium.index() != 0) {
        for (int k = 0; k < d2q9::count; ++k) {
            for (int j = 0; j < size; ++j) {
                for (int i = 0; i < size; ++i) {
                    const double pressure = analytic::taylor_green_pressure(
                        Lattice::position(i, j), {w, w}, speed, viscosity, 0.0);
                    flow.populations.set_slot(
                        k, i, j, flow.populations.slot(k, i, j) + d2q9::weight[k] * 3.0 * pressure);
                }
            }
        }
    }
    const auto steps = static_cast<long long>(1.0 / (2.0 * viscosity * w * w));
    flow.run(steps + 1);  // a pass gives the velocity of its start
    double square = 0.0;
    double scale = 0.0;
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const Vec2 u = exact(i, j, static_cast<double>(steps));
            const Vec2 off = flow.velocity(i, j) - u;
            square += dot(off, off);
            scale += dot(u, u);
        }
    }
    return std::sqrt(square / scale);
}

TEST(TaylorGreen, vortices_decay_at_second_order_with_every_equilibrium) {
    const std::array<Equilibrium, 3> kinds{LinearEquilibrium{}, IncompressibleEquilibrium{},
                                           FullEquilibrium{}};
    const std::array<const char*, 3> names{"linear", "incompressible", "full"};
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        std::vector<double> errors;
        for (const int size : {16, 32, 64}) errors.push_back(decay_error(kinds[kind], size));
        std::printf("Taylor-Green, %s: errors %.2e %.2e %.2e, order %.3f\n", names[kind], errors[0],
                    errors[1], errors[2], observed_order(errors));
        EXPECT_NEAR(observed_order(errors), 2.0, 0.05) << names[kind];
    }
}

}  // namespace
