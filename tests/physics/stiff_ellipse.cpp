#include <gtest/gtest.h>

#include <cstdio>

#include "verify/cell.hpp"

namespace tt {
namespace {

TEST(StiffEllipse, deforms_in_proportion_to_the_shear_rate_and_turns_as_jeffery_says) {
    StiffEllipse slow, fast;
    slow.reynolds = 0.2;
    fast.reynolds = 0.4;
    const JefferyOrbit a = jeffery_orbit(slow), b = jeffery_orbit(fast);
    std::printf("axis ratio %.3f to %.3f and %.3f to %.3f; period/Jeffery %.4f and %.4f\n",
                a.least_axis_ratio, a.most_axis_ratio, b.least_axis_ratio, b.most_axis_ratio,
                a.period_ratio, b.period_ratio);
    const double spread_a = a.most_axis_ratio - a.least_axis_ratio;
    const double spread_b = b.most_axis_ratio - b.least_axis_ratio;
    EXPECT_NEAR(spread_b / spread_a, 2.0, 0.2);
    EXPECT_LT(spread_a, 0.2);
    EXPECT_NEAR(a.period_ratio, 1.0, 0.08);
}

TEST(StiffEllipse, turns_more_slowly_the_longer_it_is) {
    double former = 0.0;
    for (const double ratio : {1.5, 2.0}) {
        StiffEllipse scene;
        scene.axis_ratio = ratio;
        const double period = jeffery_orbit(scene).period_ratio * (ratio + 1.0 / ratio);
        std::printf("axis ratio %.1f: k T/(2 pi) = %.3f, Jeffery %.3f\n", ratio, period,
                    ratio + 1.0 / ratio);
        EXPECT_GT(period, former);
        EXPECT_NEAR(period / (ratio + 1.0 / ratio), 1.0, 0.08);
        former = period;
    }
}

}  // namespace
}  // namespace tt
