#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "source_dir.hpp"
#include "verify/cell.hpp"

namespace tt {
namespace {

/// A row of the exact solutions: boundary integrals, walls 40 um apart, periodic length 160 um.
TankTreading exact_row(const std::string& ratio_and_G) {
    std::ifstream file(TT_SOURCE_DIR "/tests/reference/capsule_shear_channel40.csv");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind(ratio_and_G + ",", 0) != 0) continue;
        std::istringstream rest(line.substr(ratio_and_G.size() + 1));
        TankTreading row;
        double radius = 0.0;
        char comma;
        rest >> row.taylor >> comma >> radius >> comma >> row.inclination_deg >> comma >>
            row.strain >> comma >> row.period;
        return row;
    }
    ADD_FAILURE() << "no row " << ratio_and_G;
    return {};
}

// That the capsule tank-treads as the exact solution at both viscosity ratios is a part of the
// selftest.

TEST(CapsuleInShear, the_numbers_that_the_selftest_carries_are_those_of_the_reference) {
    for (const int ratio : {1, 5}) {
        const TankTreading row = exact_row(std::to_string(ratio) + ",0.2");
        const TankTreading carried = exact_tank_treading(ratio);
        EXPECT_EQ(carried.taylor, row.taylor);
        EXPECT_EQ(carried.inclination_deg, row.inclination_deg);
        EXPECT_EQ(carried.strain, row.strain);
        EXPECT_EQ(carried.period, row.period);
    }
}

TEST(CapsuleInShear, without_the_jump_correction_the_membrane_lags_behind_the_fluid) {
    Case plain = capsule_case(1);
    plain.numerics.jump_correction = false;
    const double period = tank_treading(plain, 7.0).period;
    std::printf("ratio 1, h = a/8, no correction: period %+.2f %%\n",
                100.0 * (period / exact_tank_treading(1).period - 1.0));
    EXPECT_GT(period, 1.03 * exact_tank_treading(1).period);  // a first-order error
}

}  // namespace
}  // namespace tt
