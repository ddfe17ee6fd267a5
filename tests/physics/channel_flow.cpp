#include <gtest/gtest.h>

#include <cstdio>

#include "fluid/analytic.hpp"
#include "flow.hpp"

namespace {

using namespace tt;

/// Error of the profile, driven to a peak velocity of 0.01.
double poiseuille_error(int height, Collision collision, double viscosity) {
    Flow flow({3, height, true});
    flow.collision = collision;
    flow.set_viscosity([&](int) { return viscosity; });
    flow.body_force.x = 0.08 * viscosity / (height * height);
    flow.run_to_rest();
    return profile_error(flow, [&](double y) {
        return analytic::poiseuille(y, height, viscosity, flow.body_force.x);
    });
}

TEST(ChannelFlow, poiseuille_with_magic_3_16_is_exact_at_any_viscosity) {
    for (const double viscosity : {0.02, 1.0 / 6.0, 1.0}) {
        for (const int height : {3, 8, 13}) {
            EXPECT_LT(poiseuille_error(height, Trt{}, viscosity), 1e-12)
                << height << " sites, " << viscosity;
        }
    }
}

TEST(ChannelFlow, poiseuille_with_one_relaxation_time_converges_at_second_order) {
    std::vector<double> errors;
    for (const int height : {8, 16, 32}) errors.push_back(poiseuille_error(height, Bgk{}, 0.3));
    std::printf("Poiseuille, BGK, viscosity 0.3: errors %.2e %.2e %.2e, order %.4f\n", errors[0],
                errors[1], errors[2], observed_order(errors));
    EXPECT_NEAR(observed_order(errors), 2.0, 0.01);
}

TEST(ChannelFlow, poiseuille_slips_at_the_walls_by_the_closed_form_in_the_magic_number) {
    // The lattice equations have the solution u = g y (H − y)/(2μ) + g (16 Λ − 3)/(24 μ).
    constexpr double viscosity = 0.4;
    for (const double magic : {1.0 / 12.0, 0.25, 1.0}) {
        Flow flow({3, 10, true});
        flow.collision = Trt{magic};
        flow.set_viscosity([](int) { return viscosity; });
        flow.body_force.x = 1e-4;
        flow.run_to_rest();
        const double slip = flow.body_force.x * (16.0 * magic - 3.0) / (24.0 * viscosity);
        EXPECT_LT(profile_error(
                      flow,
                      [&](double y) {
                          return analytic::poiseuille(y, 10.0, viscosity, flow.body_force.x) + slip;
                      }),
                  1e-12)
            << magic;
    }
}

TEST(ChannelFlow, couette_between_moving_walls_is_exact) {
    for (const Equilibrium& equilibrium :
         {Equilibrium{LinearEquilibrium{}}, Equilibrium{IncompressibleEquilibrium{}}}) {
        Flow flow({5, 9, true});
        flow.equilibrium = equilibrium;
        flow.boundaries = {-0.03, 0.05, 0.0};
        flow.run_to_rest();
        EXPECT_LT(
            profile_error(flow, [](double y) { return analytic::couette(y, 9.0, -0.03, 0.05); }),
            1e-12);
    }
}

Flow two_layers(int height, int interface, double bottom, double top, Collision collision) {
    Flow flow({3, height, true});
    flow.collision = collision;
    flow.set_viscosity([&](int j) { return j < interface ? bottom : top; });
    return flow;
}

TEST(ChannelFlow, couette_of_two_layers_that_meet_half_way_between_sites_is_exact) {
    for (const Collision& collision : {Collision{Trt{}}, Collision{Bgk{}}}) {
        Flow flow = two_layers(12, 5, 0.1, 0.5, collision);
        flow.boundaries.top_speed = 0.04;
        flow.run_to_rest();
        EXPECT_LT(profile_error(flow,
                                [](double y) {
                                    return analytic::couette(y, {12.0, 5.0, 0.1, 0.5}, 0.04);
                                }),
                  1e-12);
    }
}

double two_layer_poiseuille_error(int height, Collision collision) {
    Flow flow = two_layers(height, height / 4, 0.2, 1.0, collision);
    flow.body_force.x = 0.01 / (height * height);
    flow.run_to_rest();
    return profile_error(flow, [&](double y) {
        return analytic::poiseuille(y, {double(height), double(height / 4), 0.2, 1.0},
                                    flow.body_force.x);
    });
}

TEST(ChannelFlow, poiseuille_of_two_layers_with_magic_3_16_is_exact) {
    for (const int height : {8, 20}) EXPECT_LT(two_layer_poiseuille_error(height, Trt{}), 1e-12);
}

TEST(ChannelFlow, poiseuille_of_two_layers_otherwise_converges_at_second_order) {
    for (const Collision& collision : {Collision{Trt{0.25}}, Collision{Bgk{}}}) {
        std::vector<double> errors;
        for (const int height : {8, 16, 32})
            errors.push_back(two_layer_poiseuille_error(height, collision));
        std::printf("two-layer Poiseuille, ratio 5, %s: errors %.2e %.2e %.2e, order %.4f\n",
                    collision.index() == 0 ? "magic 1/4" : "BGK", errors[0], errors[1], errors[2],
                    observed_order(errors));
        EXPECT_NEAR(observed_order(errors), 2.0, 0.01);
    }
}

}  // namespace
