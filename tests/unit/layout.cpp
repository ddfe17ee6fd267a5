#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/error.hpp"
#include "case/layout.hpp"
#include "interaction/contact.hpp"
#include "membrane/shapes.hpp"

using namespace tt;

namespace {

Suspension packed(const std::vector<Vec2>& shape, int count, double length, std::uint64_t seed) {
    Suspension cells;
    for (const Placement& p : random_placements(shape, count, length, 100.0, 1.0, seed)) {
        add_cell(cells, placed(shape, p.angle, p.centre));
    }
    return cells;
}

TEST(RandomLayout, reaches_its_hematocrit_without_an_overlap) {
    for (const auto& [shape, count] :
         {std::pair{circle(10.0, 63), 15}, std::pair{biconcave(12.0, 80), 31}}) {
        const double hematocrit = count * area_of(shape) / (100.0 * 100.0);
        EXPECT_GT(hematocrit, 0.39);
        const Suspension cells = packed(shape, count, 100.0, 3);
        EXPECT_EQ(cells.cell_count(), count);
        EXPECT_TRUE(find_overlaps({100, 100, true}, cells).empty());
        for (int n = 0; n < cells.node_count(); ++n) {
            EXPECT_GT(cells.y[n], 0.0);
            EXPECT_LT(cells.y[n], 100.0);
        }
    }
}

TEST(RandomLayout, is_a_function_of_the_seed) {
    const std::vector<Vec2> shape = circle(10.0, 63);
    EXPECT_EQ(packed(shape, 12, 200.0, 5).x, packed(shape, 12, 200.0, 5).x);
    EXPECT_NE(packed(shape, 12, 200.0, 5).x, packed(shape, 12, 200.0, 6).x);
}

TEST(RandomLayout, says_how_far_it_came_where_there_is_no_room) {
    try {
        random_placements(circle(30.0, 63), 9, 200.0, 100.0, 1.0, 1);
        FAIL() << "nine discs of radius 30 cannot fit";
    } catch (const CaseError& error) {
        EXPECT_NE(std::string(error.what()).find("no room for 9 cells; hematocrit"),
                  std::string::npos);
    }
}

TEST(PaperLayout, is_two_symmetric_rows_up_to_the_perturbation) {
    const auto rows = two_rows(12, 400.0, 100.0, 0.0, 1);
    std::set<double> heights;
    for (const Placement& p : rows) heights.insert(p.centre.y);
    EXPECT_EQ(heights, (std::set<double>{25.0, 75.0}));
    const auto shaken = two_rows(12, 400.0, 100.0, 2.5, 1);
    for (int c = 0; c < 12; ++c) {
        const Vec2 shift = shaken[c].centre - rows[c].centre;
        EXPECT_LE(std::fabs(shift.x), 2.5);
        EXPECT_LE(std::fabs(shift.y), 2.5);
        EXPECT_NE(shift.y, 0.0);
    }
}

}  // namespace
