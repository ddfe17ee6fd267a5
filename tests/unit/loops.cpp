#include "geometry/loops.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "case/walls_of.hpp"
#include "fluid/walls.hpp"

namespace tt {
namespace {

const Loop square{{2.2, 2.2}, {6.2, 2.2}, {6.2, 6.2}, {2.2, 6.2}};

TEST(Loops, that_meet_along_an_edge_are_one_piece) {
    Solid solid;
    solid.outside = true;
    solid.loops = {{{0, 2}, {5, 2}, {5, 8}, {0, 8}}, {{5, 2}, {10, 2}, {10, 8}, {5, 8}}};
    solid.period_x = 10;
    const Walls walls = make_walls(solid, {10, 10, true});
    EXPECT_EQ(walls.remarks.closed, 0);
    EXPECT_EQ(walls.open_sites(), 60);
    for (const WallLink& link : walls.links) EXPECT_NEAR(link.q, 0.5, 1e-12);
}

TEST(Loops, either_way_round_and_within_each_other_take_turns) {
    Loop turned = square;
    std::reverse(turned.begin(), turned.end());
    const Loop hole{{3.2, 3.2}, {5.2, 3.2}, {5.2, 5.2}, {3.2, 5.2}};
    for (const Loop& loop : {square, turned}) {
        const Walls walls = make_walls({{loop}, false, 12, 10}, {12, 10, false});
        EXPECT_EQ(walls.open_sites(), 120 - 16);
        const Walls ring = make_walls({{loop, hole}, true, 12, 10}, {12, 10, false});
        EXPECT_EQ(ring.open_sites(), 16 - 4);
    }
}

TEST(Walls, of_no_thickness_let_nothing_through) {
    // A plate of a tenth of a site across a box that is periodic along y.
    const Solid solid{{{{-1, 4.95}, {13, 4.95}, {13, 5.05}, {-1, 5.05}}}, false, 0.0, 10.0};
    const Walls walls = make_walls(solid, {12, 10, false});
    EXPECT_GT(walls.remarks.closed, 0);
    for (int i = 0; i < 12; ++i) EXPECT_FALSE(walls.is_open(i, 4) && walls.is_open(i, 5)) << i;
}

TEST(Walls, pockets_are_closed_and_parts_counted) {
    const Loop box{{1, 1}, {59, 1}, {59, 9}, {1, 9}};
    const Loop pocket{{61.1, 4.1}, {62.9, 4.1}, {62.9, 5.9}, {61.1, 5.9}};
    const Walls walls = make_walls({{box, pocket}, true, 0, 0}, {70, 10, true});
    EXPECT_EQ(walls.remarks.parts, 1);
    EXPECT_EQ(walls.open_sites(), 58 * 8);
    EXPECT_EQ(walls.remarks.pockets, 4);
    const Loop other{{61, 1}, {69, 1}, {69, 9}, {61, 9}};
    EXPECT_EQ(make_walls({{box, other}, true, 0, 0}, {70, 10, true}).remarks.parts, 2);
}

TEST(Loops, of_a_text_are_parted_by_empty_lines_and_faults_have_their_line) {
    const auto loops =
        read_loops("# walls\nx,y\n0,0\n4,0\n4,3\n\n\n1,1\n2,1\n2,2\n1,1\n", "w.csv", 1e-6);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_EQ(loops[0].size(), 3u);
    EXPECT_EQ(loops[1].size(), 3u);
    EXPECT_DOUBLE_EQ(loops[0][2].y, 3e-6);
    try {
        read_loops("0,0\n4,0\n4,3\n\n1,1\n2,x\n2,2\n", "w.csv", 1e-6);
        FAIL();
    } catch (const CaseError& error) {
        ASSERT_EQ(error.faults().size(), 1u);
        EXPECT_EQ(error.faults()[0].line, 6);
    }
}

TEST(Walls, the_narrowest_gap_is_that_between_two_walls_not_at_the_end_of_one) {
    Solid solid;
    solid.loops = {{{10.3, 0}, {14.3, 0}, {14.3, 6.6}, {10.3, 6.6}}};
    const Walls walls = make_walls(solid, {30, 16, true});
    EXPECT_NEAR(narrowest_gap(walls), 16 - 6.6, 1.0);
    // A throat is narrow across and wide along.
    solid.loops = {{{5, 0}, {15.2, 4.2}, {25, 0}}, {{5, 16}, {15.2, 11.8}, {25, 16}}};
    EXPECT_NEAR(narrowest_gap(make_walls(solid, {30, 16, true})), 7.6, 1.0);
}

}  // namespace
}  // namespace tt
