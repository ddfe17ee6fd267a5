#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"
#include "fluid/collide_row.hpp"

namespace {

using namespace tt;

/// A row with values of its own.
struct Row {
    static constexpr int count = 403;
    std::vector<std::vector<double>> values;
    RowOfSites sites{};

    Row() : values(15, std::vector<double>(count)) {
        Random random(7);
        for (auto& line : values) {
            for (double& v : line) v = random.uniform(-0.02, 0.02);
        }
        for (double& rate : values[11]) rate = random.uniform(0.2, 1.9);
        for (double& rate : values[12]) rate = random.uniform(0.2, 1.9);
        sites.count = count;
        for (int i = 0; i < d2q9::count; ++i) sites.at[i] = values[i].data();
        sites.force_x = values[9].data();
        sites.force_y = values[10].data();
        sites.body_force = {1e-4, -2e-4};
        sites.even = values[11].data();
        sites.odd = values[12].data();
        sites.velocity_x = values[13].data();
        sites.velocity_y = values[14].data();
    }
};

template <class AnEquilibrium>
class FluidInstructionSets : public testing::Test {};
using Equilibria = testing::Types<LinearEquilibrium, IncompressibleEquilibrium, FullEquilibrium>;
TYPED_TEST_SUITE(FluidInstructionSets, Equilibria);

/// The template is compiled here for the baseline, `collide_row` for the best this machine has.
TYPED_TEST(FluidInstructionSets, the_widest_and_the_narrowest_give_the_same_bits) {
    Row narrow;
    Row wide;
    collide_row_with<TypeParam>(narrow.sites);
    collide_row(TypeParam{}, wide.sites);
    EXPECT_EQ(narrow.values, wide.values);
}

}  // namespace
