#include <gtest/gtest.h>

#include "base/random.hpp"
#include "fluid/moments.hpp"

namespace {

using namespace tt;

TEST(Moments, of_the_rest_state_vanish) {
    const Populations populations(Lattice{3, 2, true});
    const Moments m = moments(populations, 1, 1);
    EXPECT_EQ(m.density_deviation, 0.0);
    EXPECT_EQ(m.momentum, Vec2{});
    EXPECT_EQ(m.xx, 0.0);
    EXPECT_EQ(m.xy, 0.0);
    EXPECT_EQ(m.yy, 0.0);
}

TEST(Moments, of_an_equilibrium_are_density_1_its_velocity_and_its_momentum_flux) {
    const Lattice lattice{4, 3, false};
    VectorField velocity(lattice);
    velocity.x(2, 1) = 0.03;
    velocity.y(2, 1) = -0.07;
    Populations populations(lattice);
    for (const Equilibrium& equilibrium :
         {Equilibrium{LinearEquilibrium{}}, Equilibrium{IncompressibleEquilibrium{}},
          Equilibrium{FullEquilibrium{}}}) {
        populations.phase = Phase::odd;
        set_equilibrium(equilibrium, velocity, Field<>(velocity.x.lattice()), populations);
        EXPECT_EQ(populations.phase, Phase::even);
        const Moments m = moments(populations, 2, 1);
        const double inertia = equilibrium.index() == 0 ? 0.0 : 1.0;
        EXPECT_NEAR(m.density_deviation, 0.0, 1e-16);
        EXPECT_NEAR(m.momentum.x, 0.03, 1e-16);
        EXPECT_NEAR(m.momentum.y, -0.07, 1e-16);
        EXPECT_NEAR(m.xx, inertia * 0.03 * 0.03, 1e-16);
        EXPECT_NEAR(m.xy, inertia * 0.03 * -0.07, 1e-16);
        EXPECT_NEAR(m.yy, inertia * 0.07 * 0.07, 1e-16);
    }
}

template <class Real>
class MomentsOfRow : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(MomentsOfRow, Reals);

TYPED_TEST(MomentsOfRow, density_is_that_of_its_sites_in_either_phase) {
    Random random(4);
    Populations<TypeParam> populations(Lattice{7, 3, true});
    for (int k = 0; k < d2q9::count; ++k) {
        for (int j = 0; j < 3; ++j)
            for (int i = -1; i <= 7; ++i) populations.set_slot(k, i, j, random.uniform());
    }
    for (const auto phase : {Phase::even, Phase::odd}) {
        populations.phase = phase;
        for (int j = 0; j < 3; ++j) {
            const std::vector<double> row = density_deviations(populations, j);
            ASSERT_EQ(row.size(), 7u);
            for (int i = 0; i < 7; ++i)
                EXPECT_EQ(row[i], moments(populations, i, j).density_deviation);
        }
    }
}

}  // namespace
