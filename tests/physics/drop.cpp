#include "verify/drop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace tt {
namespace {

TEST(Drop, pressure_jump_is_laplaces_and_nears_it_as_the_grid_is_refined) {
    const LaplacePressure coarse = laplace_pressure(6.0, 0.01), fine = laplace_pressure(12.0, 0.01);
    std::printf("pressure jump R/gamma - 1: %.1e, %.1e; mu u/gamma left: %.1e, %.1e\n",
                coarse.ratio - 1.0, fine.ratio - 1.0, coarse.spurious_flow, fine.spurious_flow);
    EXPECT_NEAR(coarse.ratio, 1.0, 2e-3);
    EXPECT_LT(std::abs(fine.ratio - 1.0), 0.5 * std::abs(coarse.ratio - 1.0));
    EXPECT_LT(fine.spurious_flow, coarse.spurious_flow);
}

TEST(Drop, modes_relax_in_the_time_of_stokes_flow_at_second_order) {
    for (const double ratio : {1.0, 5.0}) {
        for (const int mode : {3, 4}) {
            double error[2];
            for (const int fine : {0, 1}) {
                DropScene scene;
                scene.radius = fine ? 12.0 : 6.0;
                scene.box = 6.0 * scene.radius;
                scene.viscosity = 1.0;
                scene.viscosity_ratio = ratio;
                error[fine] = relaxation_time_ratio(scene, mode) - 1.0;
            }
            const double order = std::log2(error[0] / error[1]);
            std::printf("ratio %g, mode %d: time %+.1f %%, %+.1f %% at 6, 12 sites, order %.2f\n",
                        ratio, mode, 100.0 * error[0], 100.0 * error[1], order);
            // The walls slow mode 3 by a hundredth, which hides its order.
            if (mode == 4) {
                EXPECT_NEAR(order, 2.0, 0.25);
            }
            EXPECT_NEAR((4.0 * error[1] - error[0]) / 3.0, 0.0, 0.03);
        }
    }
}

TEST(Drop, deformation_is_the_capillary_number_and_less_as_it_grows) {
    // Ca → 0 is the theory's limit; at 0.2 its next order, not known here, is a few per cent.
    const DropInShear small = drop_in_unbounded_shear(1.0, 0.03, 4.0);
    const DropInShear large = drop_in_unbounded_shear(1.0, 0.2, 6.0);
    std::printf("D/Ca %.4f at Ca = 0.03, %.4f at 0.2 (theory %.4f, %.4f); angle %.1f, %.1f deg\n",
                small.taylor / 0.03, large.taylor / 0.2, drop_deformation(1.0, 0.03) / 0.03,
                drop_deformation(1.0, 0.2) / 0.2, small.inclination * 57.29578,
                large.inclination * 57.29578);
    EXPECT_NEAR(small.taylor / drop_deformation(1.0, 0.03), 1.0, 0.01);
    EXPECT_NEAR(large.taylor / drop_deformation(1.0, 0.2), 1.0, 0.05);
    // 45° less half of the angle whose tangent is (1 + r) Ca.
    EXPECT_NEAR(small.inclination, 0.25 * M_PI - 0.5 * std::atan(2.0 * 0.03), 0.01);
    EXPECT_NEAR(large.inclination, 0.25 * M_PI - 0.5 * std::atan(2.0 * 0.2), 0.06);
}

TEST(Drop, nodes_spread_and_gather_no_further_than_the_speed_along_the_surface_makes_them) {
    for (const double ratio : {1.0, 5.0}) {
        DropScene scene;
        scene.radius = 7.0;
        scene.box = 56.0;
        scene.viscosity = 1.0;
        scene.viscosity_ratio = ratio;
        const double early = drop_in_shear(scene, 0.03, 4.0).spacing_ratio;
        const double late = drop_in_shear(scene, 0.03, 40.0).spacing_ratio;
        const double bound = std::pow((2.0 + ratio) / ratio, 2);
        std::printf("ratio %g: longest/shortest segment %.2f at k t = 4, %.2f at 40, bound %.2f\n",
                    ratio, early, late, bound);
        EXPECT_LT(early, 1.5 * bound);
        EXPECT_LT(late, 1.5 * bound);
    }
}

}  // namespace
}  // namespace tt
