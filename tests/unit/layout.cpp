#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/layout.hpp"
#include "case/random_layout.hpp"
#include "case/read.hpp"
#include "interaction/contact.hpp"
#include "io/checksum.hpp"
#include "membrane/shapes.hpp"

using namespace tt;

namespace {

Suspension packed(const std::vector<Vec2>& shape, int count, const Lattice& box,
                  std::uint64_t seed) {
    Suspension cells;
    for (const Placement& place : random_placements({shape, count}, box, seed))
        add_cell(cells, placed(shape, place));
    return cells;
}

/// So many copies of a shape that they fill this share of a box as wide as given.
Lattice box_for(const std::vector<Vec2>& shape, int count, double hematocrit, int width,
                bool walls = true) {
    return {static_cast<int>(std::ceil(count * area_of(shape) / hematocrit / width)), width, walls};
}

double distance_to_walls(const Suspension& cells, const Lattice& box) {
    double least = box.ny;
    for (const double y : cells.y) least = std::min({least, y, box.ny - y});
    return least;
}

/// That cells keep apart, from the walls too, with the area they have at rest.
void expect_sound(const Suspension& cells, const Lattice& box, double area) {
    EXPECT_TRUE(find_overlaps(box, cells).empty());
    if (box.walls) {
        EXPECT_GT(distance_to_walls(cells, box), 0.0);
    }
    for (int c = 0; c < cells.cell_count(); ++c)
        EXPECT_NEAR(cells.reference_area[c], area, 1e-6 * area);
}

TEST(RandomLayout, reaches_its_hematocrit_without_an_overlap) {
    for (const auto& [shape, count] :
         {std::pair{circle(10.0, 63), 15}, std::pair{biconcave(12.0, 80), 31}}) {
        const double hematocrit = count * area_of(shape) / (100.0 * 100.0);
        EXPECT_GT(hematocrit, 0.39);
        const Lattice box{100, 100, true};
        const Suspension cells = packed(shape, count, box, 3);
        EXPECT_EQ(cells.cell_count(), count);
        expect_sound(cells, box, area_of(shape));
    }
}

TEST(RandomLayout, fills_three_quarters_of_any_box) {
    const auto round = circle(8.0, 50), concave = biconcave(10.0, 49), oval = ellipse(9.0, 5.0, 45);
    struct Start {
        const std::vector<Vec2>& shape;
        int count, width;
        bool walls;
    };
    for (const Start& s :
         {Start{round, 12, 40, true}, Start{round, 16, 200, true}, Start{round, 12, 50, false},
          Start{concave, 8, 60, true}, Start{concave, 10, 50, false}, Start{oval, 12, 40, true}}) {
        const Lattice box = box_for(s.shape, s.count, 0.75, s.width, s.walls);
        const Suspension cells = packed(s.shape, s.count, box, 1);
        ASSERT_EQ(cells.cell_count(), s.count);
        expect_sound(cells, box, area_of(s.shape));
    }
}

TEST(RandomLayout, does_not_stretch_membranes_much) {
    const std::vector<Vec2> shape = biconcave(10.0, 49);
    const Lattice box = box_for(shape, 8, 0.75, 60);
    const double rest = perimeter_of(shape);
    const Suspension cells = packed(shape, 8, box, 1);
    for (const double perimeter : cells.reference_perimeter)
        EXPECT_NEAR(perimeter, rest, 0.06 * rest);
}

TEST(RandomLayout, is_a_function_of_the_seed) {
    const std::vector<Vec2> shape = circle(10.0, 63);
    for (const double hematocrit : {0.2, 0.6}) {
        const Lattice box = box_for(shape, 12, hematocrit, 100);
        EXPECT_EQ(packed(shape, 12, box, 5).x, packed(shape, 12, box, 5).x);
        EXPECT_NE(packed(shape, 12, box, 5).x, packed(shape, 12, box, 6).x);
    }
}

// Dilute layouts are those of the first version of the program, dense ones those of today.
TEST(RandomLayout, keeps_its_bits) {
    const auto fingerprint = [](double hematocrit, int count) {
        const std::vector<Vec2> shape = circle(8.0, 50);
        const Lattice box = box_for(shape, count, hematocrit, 100);
        std::string bytes;
        for (const Placement& place : random_placements({shape, count}, box, 1))
            bytes += fmt::format("{:a} {:a} ", place.centre.x, place.centre.y);
        return checksum(bytes);
    };
    EXPECT_EQ(fingerprint(0.3, 20), 11585085735208442967u);
    EXPECT_EQ(fingerprint(0.7, 20), 17815452131439189405u);
}

TEST(RandomLayout, takes_work_in_proportion_to_the_number_of_cells) {
    const std::vector<Vec2> shape = circle(8.0, 32);
    const auto visits = [&](int count) {
        const auto side = static_cast<int>(std::sqrt(count * area_of(shape) / 0.45));
        const Lattice box = box_for(shape, count, 0.45, side);
        return static_cast<double>(lay_at_random({shape, count}, box, 1).visits) / count;
    };
    EXPECT_LT(visits(1600), 2.0 * visits(800));
    EXPECT_LT(visits(800), 50.0);
}

/// Cells that came to cross each other while they were small never part by bending. They grow anew,
/// and no others.
TEST(RandomLayout, cells_that_cross_each_other_grow_anew) {
    const std::vector<Vec2> shape = biconcave(5.4, 18);
    const Lattice box{120, 120, true};
    const int count = static_cast<int>(0.75 * 120 * 120 / area_of(shape));
    const RandomLayout layout = lay_at_random({shape, count}, {box, nullptr}, 1);
    EXPECT_GE(layout.scale, 1.0);
    EXPECT_LT(static_cast<double>(layout.visits) / count, 3000.0);
}

TEST(RandomLayout, says_what_fits_where_there_is_no_room) {
    const std::vector<Vec2> shape = circle(30.0, 63);
    const Lattice box{200, 100, true};
    try {
        random_placements({shape, 9}, box, 1);
        FAIL() << "nine discs of radius 30 cannot fit";
    } catch (const CaseError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("no room for 9 cells; hematocrit"), std::string::npos) << text;
        int fits = 0;
        ASSERT_EQ(std::sscanf(text.c_str() + text.find("count = "), "count = %d", &fits), 1);
        EXPECT_EQ(random_placements({shape, fits}, box, 1).size(), static_cast<std::size_t>(fits));
    }
}

Suspension start_of(const std::string& cells, const std::string& width) {
    const Case c = parse_case(
        fmt::format("format = 1\n[domain]\nlength = \"24 um\"\nwidth = \"{}\"\n[cells]\n{}\n"
                    "[numerics]\ndx = \"0.25 um\"\n[time]\nend = \"1 ms\"\n",
                    width, cells),
        "case.toml");
    return initial_state(c, discretise(c)).cells;
}

TEST(Fit, refuses_cells_that_overlap_whatever_their_shape) {
    const std::string pair =
        "shape = \"ellipse\"\nradius = \"2 um\"\naspect_ratio = 2\nlayout = \"explicit\"\n"
        "positions = [[\"8 um\", \"6 um\"], [\"{} um\", \"6 um\"]]";
    EXPECT_EQ(start_of(fmt::format(fmt::runtime(pair), "14"), "12 um").cell_count(), 2);
    EXPECT_THROW(start_of(fmt::format(fmt::runtime(pair), "13"), "12 um"), CaseError);
    EXPECT_THROW(start_of(fmt::format(fmt::runtime(pair), "31"), "12 um"), CaseError)
        << "across the end of the box";
}

TEST(InitialStretch, is_along_the_axis_that_angle_turns) {
    const std::string cell = "radius = \"2 um\"\ninitial_stretch = 2.25\nangle = ";
    for (const double degrees : {0.0, 30.0, 90.0, 135.0}) {
        const Suspension s = start_of(cell + fmt::format("\"{} deg\"", degrees), "12 um");
        double longest = 0.0, along = 0.0;
        for (int n = 0; n < s.node_count(); ++n) {
            const Vec2 p = s.position(n) - Vec2{48.0, 24.0};
            if (norm(p) > longest) longest = norm(p), along = std::atan2(p.y, p.x);
        }
        EXPECT_NEAR(longest, 8.0 * 1.5, 0.05) << degrees;
        EXPECT_NEAR(std::sin(along - degrees * M_PI / 180.0), 0.0, 0.1) << degrees;
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

const std::string disc = "shape = \"biconcave\"\nradius = \"3.91 um\"\n";

TEST(Fit, looks_at_the_outline_as_it_lies) {
    EXPECT_EQ(start_of(disc, "6 um").cell_count(), 1);
    EXPECT_EQ(start_of(disc + "angle = \"20 deg\"", "6 um").cell_count(), 1);
    EXPECT_THROW(start_of(disc + "angle = \"90 deg\"", "6 um"), CaseError);
    EXPECT_EQ(
        start_of("shape = \"ellipse\"\nradius = \"4 um\"\naspect_ratio = 4", "5 um").cell_count(),
        1);
    EXPECT_EQ(start_of(disc + "layout = \"random\"\ncount = 2", "6 um").cell_count(), 2);
    EXPECT_EQ(start_of("radius = \"2.9 um\"\ninitial_stretch = 2", "5 um").cell_count(), 1);
}

TEST(PaperLayout, has_pairs_of_cells_whatever_the_hematocrit) {
    const std::string rows = "layout = \"paper\"\nradius = \"2 um\"\nhematocrit = ";
    EXPECT_EQ(start_of(rows + "\"4 %\"", "12 um").cell_count(), 2);
    EXPECT_EQ(start_of(rows + "\"15 %\"", "12 um").cell_count(), 4);
}

}  // namespace
