#include "observe/partition.hpp"

#include <gtest/gtest.h>

namespace tt {
namespace {

constexpr Length feeding{20e-6}, wide{14e-6}, narrow{9.2e-6};

// Worked by hand from the formulas of Pries and Secomb (2005).
TEST(PriesLaw, of_a_fork_of_20_into_14_and_9_um_at_30_percent) {
    const PriesLaw law(feeding, narrow, wide, 0.3);
    EXPECT_NEAR(law.X0, 0.0337, 5e-5);
    EXPECT_NEAR(law.B, 1.244, 5e-4);
    EXPECT_NEAR(law.A, 0.185, 5e-4);
    EXPECT_NEAR(PriesLaw(feeding, wide, narrow, 0.3).A, -0.185, 5e-4);
    EXPECT_NEAR(law.cell_fraction(0.221), 0.178, 1e-3);
}

TEST(PriesLaw, shares_of_both_daughters_add_up_and_end_at_the_edges) {
    const PriesLaw law(feeding, narrow, wide, 0.3), other(feeding, wide, narrow, 0.3);
    for (const double x : {0.01, 0.1, 0.3, 0.5, 0.8, 0.99})
        EXPECT_NEAR(law.cell_fraction(x) + other.cell_fraction(1.0 - x), 1.0, 1e-12);
    EXPECT_EQ(law.cell_fraction(0.03), 0.0);
    EXPECT_EQ(law.cell_fraction(0.97), 1.0);
}

}  // namespace
}  // namespace tt
