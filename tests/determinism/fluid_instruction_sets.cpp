#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "base/random.hpp"
#include "fluid/collide_row.hpp"

namespace {

using namespace tt;

/// A row with values of its own.
template <class Real>
struct Row {
    static constexpr int count = 403;
    std::array<std::vector<Real>, d2q9::count> populations;
    std::array<std::vector<Real>, 6> fields;
    RowOfSites<Real> sites{};

    Row() {
        Random random(7);
        for (auto& line : populations) fill(line, random, -0.02, 0.02);
        for (auto& line : fields) fill(line, random, -0.02, 0.02);
        for (const int rates : {2, 3}) fill(fields[rates], random, 0.2, 1.9);
        sites.count = count;
        for (int i = 0; i < d2q9::count; ++i) sites.at[i] = populations[i].data();
        sites.force_x = fields[0].data();
        sites.force_y = fields[1].data();
        sites.body_force = {1e-4, -2e-4};
        sites.even = fields[2].data();
        sites.odd = fields[3].data();
        sites.velocity_x = fields[4].data();
        sites.velocity_y = fields[5].data();
    }

    static void fill(std::vector<Real>& line, Random& random, double low, double high) {
        line.resize(count);
        for (Real& v : line) v = static_cast<Real>(random.uniform(low, high));
    }
};

template <class AnEquilibrium, class Real>
void expect_same_bits() {
    Row<Real> narrow;
    Row<Real> wide;
    collide_row_with<AnEquilibrium>(narrow.sites);
    collide_row(AnEquilibrium{}, wide.sites);
    EXPECT_EQ(narrow.populations, wide.populations);
    EXPECT_EQ(narrow.fields, wide.fields);
}

template <class AnEquilibrium>
class FluidInstructionSets : public testing::Test {};
using Equilibria = testing::Types<LinearEquilibrium, IncompressibleEquilibrium, FullEquilibrium>;
TYPED_TEST_SUITE(FluidInstructionSets, Equilibria);

/// The template is compiled here for the baseline, `collide_row` for the best this machine has.
TYPED_TEST(FluidInstructionSets, the_widest_and_the_narrowest_give_the_same_bits) {
    expect_same_bits<TypeParam, double>();
    expect_same_bits<TypeParam, float>();
}

}  // namespace
