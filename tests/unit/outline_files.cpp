#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "outline_text.hpp"

using namespace tt;

namespace {

TEST(OutlineFile, is_read_however_it_comes) {
    const CellOutline plain = read_outline(text_of(ellipse_60), "o.csv", {});
    EXPECT_EQ(plain.given, 60);
    EXPECT_FALSE(plain.closed);
    EXPECT_FALSE(plain.clockwise);
    EXPECT_NEAR(measures_of(plain).area, 1e-12 * area_of(ellipse_60), 1e-25);
    std::vector<Vec2> closed = repeated(ellipse_60);
    closed.insert(closed.begin(), closed.front());
    std::string old_mac = text_of(ellipse_60, "{},{}\r");
    for (const std::string& text :
         {"\xEF\xBB\xBF" + text_of(ellipse_60), "X,Y\n" + text_of(ellipse_60), old_mac,
          "\xEF\xBB\xBFX,Y\r\n" + text_of(ellipse_60, "{},{}\r\n"), text_of(ellipse_60, "{}\t{}\n"),
          text_of(ellipse_60, "  {}   {}  \n"),
          "# traced\n\n" + text_of(ellipse_60, "{:+}, {:+}  # node\n"), text_of(closed),
          "\"\",\"x\",\"y\"\n" + text_of(ellipse_60, "\"1\",{},{}\n"),
          " \tX\tY\n" + text_of(ellipse_60, "1\t{}\t{}\n"),
          "Area,X (um),Y (um),Mean\n" + text_of(ellipse_60, "7.5,{},{},255\n")}) {
        EXPECT_EQ(read_outline(text, "o.csv", {}).points, plain.points) << text.substr(0, 60);
    }
    EXPECT_EQ(read_outline(text_of(closed), "o.csv", {}).given, 62);
    EXPECT_TRUE(read_outline(text_of(closed), "o.csv", {}).closed);
    std::vector<Vec2> swapped;
    for (const Vec2 p : ellipse_60) swapped.push_back({p.y, p.x});
    EXPECT_EQ(read_outline("row,col\n" + text_of(swapped), "o.csv", {}).points, plain.points);
}

TEST(OutlineFile, that_runs_clockwise_is_turned_round_and_told) {
    const std::vector<Vec2> backwards(ellipse_60.rbegin(), ellipse_60.rend());
    const CellOutline outline = read_outline(text_of(backwards), "o.csv", {});
    EXPECT_TRUE(outline.clockwise);
    EXPECT_GT(area_of(outline.points), 0.0);
    ASSERT_EQ(outline.remarks.size(), 1u);
    EXPECT_NE(outline.remarks[0].find("write y_down = true"), std::string::npos);
}

TEST(OutlineFile, in_pixels_with_y_down_is_the_cell_as_it_is_seen) {
    // A right-angled hook, no mirror image of itself, drawn on a screen.
    const std::string hook = "0,0\n10,0\n20,0\n20,10\n20,40\n10,40\n10,10\n0,10\n";
    OutlineShape shape;
    shape.pixel = Length{1e-7};
    shape.y_down = true;
    const CellOutline outline = read_outline(hook, "o.csv", shape);
    EXPECT_TRUE(outline.remarks.empty());
    EXPECT_NEAR(measures_of(outline).area, 5e-12, 1e-24);
    EXPECT_NEAR(measures_of(outline).height, 4e-6, 1e-18);
    double below = 0.0;  // the long arm hangs down, on the right
    for (const Vec2 p : outline.points)
        if (p.y < -1e-6) below += p.x;
    EXPECT_NEAR(below, 4e-7, 1e-15);
}

TEST(OutlineFile, of_another_kind_is_refused_in_one_sentence_with_the_cause) {
    const auto other = [](std::string text) {
        for (char& c : text)
            if (c == '.') c = ',';
        return text;
    };
    const std::string semicolons = text_of(ellipse_60, "{};{}\n");
    const std::string tabs = other(text_of(ellipse_60, "{:.3f}\t{:.3f}\n"));
    const std::string commas = other(text_of(ellipse_60, "{:.3f},{:.3f}\n"));
    EXPECT_EQ(faults_of("X;Y\n" + other(semicolons)),
              "o.csv:1:1: the columns are parted by semicolons; write x,y with a comma between the "
              "numbers and points in them, as in 4.15,0.2");
    EXPECT_EQ(faults_of("3,1;0,2\n" + other(semicolons)),
              "o.csv:1:1: the columns are parted by semicolons and the numbers have decimal "
              "commas; write x,y with a comma between the numbers and points in them, as in "
              "4.15,0.2");
    for (const std::string& text : {tabs, commas, "0 2,5\n" + tabs})
        EXPECT_EQ(faults_of(text),
                  "o.csv:1:1: the numbers have decimal commas; write x,y with points in the "
                  "numbers and a comma between them, as in 4.15,0.2");
    EXPECT_EQ(faults_of("X (mm),Y (mm)\n" + text_of(ellipse_60)),
              "o.csv: the heading says mm; write pixel = \"1 mm\" in [cells]");
    EXPECT_EQ(faults_of("\xFF\xFEx"),
              "o.csv: the text is in UTF-16; save it as UTF-8 or plain ASCII");
}

TEST(OutlineFile, has_its_bad_lines_told_ten_at_most) {
    EXPECT_EQ(faults_of("1,2\n3\n4,nan\n5,six\n1e30,0\n"),
              "o.csv:2:1: expected two numbers: x, y in um, found 1 word\n"
              "o.csv:3:1: nan is no coordinate of a cell\n"
              "o.csv:4:1: 'six' is no number; expected two: x, y in um\n"
              "o.csv:5:1: 1e30 is no coordinate of a cell");
    EXPECT_EQ(faults_of("1,2\n\"3,4\n\"5\",6\n"),
              "o.csv:2:1: a quote (\") is left open; close it, or leave it out");
    std::string many = "1,2\n";
    for (int k = 0; k < 1000; ++k) many += "3\n";
    const std::string told = faults_of(many);
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 10);
    EXPECT_NE(told.find("and 990 more lines like these"), std::string::npos);
    EXPECT_EQ(faults_of(""), "o.csv: 0 points are too few for an outline; at least 8 are needed");
    EXPECT_EQ(faults_of("0,0\n1,0\n0,1\n"),
              "o.csv:1:1: 3 points are too few for an outline; at least 8 are needed");
}

TEST(OutlineFile, that_is_no_simple_loop_is_refused_with_both_places) {
    std::string eight, line, square;
    for (int k = 0; k < 60; ++k) {
        const double t = 2.0 * std::numbers::pi * (k + 0.5) / 60;
        eight += fmt::format("{},{}\n", 4.0 * std::sin(t), 2.0 * std::sin(2.0 * t));
    }
    for (int k = 0; k < 20; ++k) line += fmt::format("{},{}\n", 0.3 * k, 0.1 * k);
    for (const char* corner :
         {"0,0", "5,0", "10,0", "10,5", "11,5", "10,5", "10,10", "0,10", "0,5"})
        square += std::string(corner) + "\n";
    EXPECT_EQ(faults_of(eight),
              "o.csv:30:1: the outline crosses or touches itself near (0, 0): its way from line 30 "
              "to line 31 meets that from line 60 to line 1; the outline of a cell is one simple "
              "loop");
    EXPECT_EQ(faults_of(line),
              "o.csv:1:1: all 20 points, from line 1 to line 20, lie on one straight line: they "
              "enclose no area");
    EXPECT_EQ(faults_of(square),
              "o.csv:4:1: the outline runs out to line 5 and straight back: line 4 and line 6 are "
              "the same point, (10, 5); leave the spur out");
    const std::string twice =
        "o.csv:{}:1: the outline is written twice over: line {} begins again "
        "what line 1 began; leave one of the two out";
    EXPECT_EQ(faults_of(text_of(ellipse_60) + text_of(ellipse_60)),
              fmt::format(fmt::runtime(twice), 61, 61));
    EXPECT_EQ(faults_of(text_of(repeated(ellipse_60)) + text_of(repeated(ellipse_60))),
              fmt::format(fmt::runtime(twice), 61, 61));
    // Two lobes that meet at one point; a corner that rests on a side.
    EXPECT_EQ(faults_of("0,0\n4,-1\n5,0\n4,1\n0,0\n-4,1\n-5,0\n-4,-1\n-1,-1\n"),
              "o.csv:1:1: the outline touches itself: line 1 and line 5 are the same point, (0, "
              "0); the outline of a cell is one simple loop");
    EXPECT_EQ(faults_of("0,0\n4,0\n8,0\n8,4\n4,0.0\n0,4\n-1,3\n-1,1\n").substr(0, 34),
              "o.csv:2:1: the outline touches its");
}

TEST(OutlineFile, of_edges_of_pixels_is_told_to_be_too_long) {
    // The edges of the pixels whose middles lie in a disc of radius 20, as ImageJ's wand runs.
    std::vector<Vec2> edges;
    std::vector<int> half;
    for (int j = -20; j < 20; ++j)
        half.push_back(static_cast<int>(std::lround(std::sqrt(400.0 - (j + 0.5) * (j + 0.5)))));
    for (int j = -20; j < 20; ++j) {
        edges.push_back({static_cast<double>(half[j + 20]), static_cast<double>(j)});
        edges.push_back({static_cast<double>(half[j + 20]), static_cast<double>(j + 1)});
    }
    for (int j = 19; j >= -20; --j) {
        edges.push_back({static_cast<double>(-half[j + 20]), static_cast<double>(j + 1)});
        edges.push_back({static_cast<double>(-half[j + 20]), static_cast<double>(j)});
    }
    OutlineShape shape;
    shape.pixel = Length{2e-7};
    shape.y_down = false;
    const CellOutline outline = read_outline(text_of(edges), "o.csv", shape);
    const double area = std::numbers::pi * 16e-12, perimeter = std::numbers::pi * 8e-6;
    EXPECT_NEAR(measures_of(outline).perimeter / perimeter, 1.27, 0.01);
    EXPECT_NEAR(measures_of(outline).reduced_area, 0.62, 0.01);
    ASSERT_EQ(outline.remarks.size(), 1u);
    EXPECT_NE(outline.remarks[0].find("too long"), std::string::npos) << outline.remarks[0];
    EXPECT_NE(outline.remarks[0].find("smoothing = \"0.3 um\""), std::string::npos);
    shape.smoothing = Length{3e-7};
    const CellOutline smooth = read_outline(text_of(edges), "o.csv", shape);
    EXPECT_TRUE(smooth.remarks.empty());
    EXPECT_NEAR(measures_of(smooth).area / area, 1.0, 0.01);
    EXPECT_NEAR(measures_of(smooth).perimeter / perimeter, 1.0, 0.02);
    shape.smoothing = Length{3e-6};
    EXPECT_NE(faults_of(text_of(edges), shape).find("at most"), std::string::npos);
}

TEST(OutlineFile, of_a_plain_rectangle_is_no_staircase) {
    const CellOutline outline =
        read_outline("0,0\n4,0.0\n8,0\n8,2\n8,4\n4.5,4\n0,4\n0,2.5\n", "o.csv", {});
    EXPECT_FALSE(outline.staircase);
    EXPECT_TRUE(outline.remarks.empty());
}

TEST(Smoothing, keeps_the_area_and_takes_waves_off_as_it_says) {
    // A circle whose radius waves 30 times around by a hundredth.
    std::vector<Vec2> wavy;
    for (int k = 0; k < 3000; ++k) {
        const double t = 2.0 * std::numbers::pi * k / 3000, r = 1.0 + 0.01 * std::cos(30.0 * t);
        wavy.push_back({r * std::cos(t), r * std::sin(t)});
    }
    const double wave = 2.0 * std::numbers::pi / 30.0, length = 0.2 * wave;
    const std::vector<Vec2> smooth = smoothed(wavy, length);
    EXPECT_NEAR(area_of(smooth), area_of(wavy), 1e-9);
    double low = 2.0, high = 0.0;
    for (const Vec2 p : smooth) {
        low = std::min(low, norm(p));
        high = std::max(high, norm(p));
    }
    const double kept = std::exp(-2.0 * std::pow(std::numbers::pi * 0.2, 2));
    EXPECT_NEAR(0.5 * (high - low), 0.01 * kept, 5e-4);
}

}  // namespace
