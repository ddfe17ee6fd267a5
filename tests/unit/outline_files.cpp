#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "case/read_outline.hpp"
#include "command.hpp"
#include "io/checksum.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "membrane/outline.hpp"
#include "membrane/shapes.hpp"
#include "temporary_directory.hpp"

using namespace tt;

namespace {

std::string text_of(const std::vector<Vec2>& points, const char* format = "{},{}\n") {
    std::string text;
    for (const Vec2 p : points) text += fmt::format(fmt::runtime(format), p.x, p.y);
    return text;
}

/// An ellipse of 6 by 4 um that no other length stands in.
const std::vector<Vec2> ellipse_60 = ellipse(3.0, 2.0, 60);

std::vector<Vec2> repeated(std::vector<Vec2> points, std::size_t from = 0) {
    points.push_back(points[from]);
    return points;
}

/// All faults, one a line, or "none".
std::string faults_of(const std::string& text, const CellsCase& cells = {}) {
    try {
        read_outline(text, "o.csv", cells);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "none";
}

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
    CellsCase cells;
    cells.pixel = Length{1e-7};
    cells.y_down = true;
    const CellOutline outline = read_outline(hook, "o.csv", cells);
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
    CellsCase cells;
    cells.pixel = Length{2e-7};
    cells.y_down = false;
    const CellOutline outline = read_outline(text_of(edges), "o.csv", cells);
    const double area = std::numbers::pi * 16e-12, perimeter = std::numbers::pi * 8e-6;
    EXPECT_NEAR(measures_of(outline).perimeter / perimeter, 1.27, 0.01);
    EXPECT_NEAR(measures_of(outline).reduced_area, 0.62, 0.01);
    ASSERT_EQ(outline.remarks.size(), 1u);
    EXPECT_NE(outline.remarks[0].find("too long"), std::string::npos) << outline.remarks[0];
    EXPECT_NE(outline.remarks[0].find("smoothing = \"0.3 um\""), std::string::npos);
    cells.smoothing = Length{3e-7};
    const CellOutline smooth = read_outline(text_of(edges), "o.csv", cells);
    EXPECT_TRUE(smooth.remarks.empty());
    EXPECT_NEAR(measures_of(smooth).area / area, 1.0, 0.01);
    EXPECT_NEAR(measures_of(smooth).perimeter / perimeter, 1.0, 0.02);
    cells.smoothing = Length{3e-6};
    EXPECT_NE(faults_of(text_of(edges), cells).find("at most"), std::string::npos);
}

TEST(OutlineFile, of_a_plain_rectangle_is_no_staircase) {
    const CellOutline outline =
        read_outline("0,0\n4,0.0\n8,0\n8,2\n8,4\n4.5,4\n0,4\n0,2.5\n", "o.csv", {});
    EXPECT_FALSE(outline.staircase);
    EXPECT_TRUE(outline.remarks.empty());
}

/// What ImageJ saves: `half` has whole coordinates from the corner of the bounding box, or those of
/// parts of pixels behind them.
std::string roi_of(const std::vector<Vec2>& points, int type, unsigned options = 0) {
    std::string bytes(64, '\0');
    const auto put = [&](std::size_t at, unsigned value) {
        if (bytes.size() < at + 2) bytes.resize(at + 2);
        bytes[at] = static_cast<char>(value >> 8);
        bytes[at + 1] = static_cast<char>(value);
    };
    const std::size_t n = points.size();
    bytes.replace(0, 4, "Iout");
    put(4, 227);
    bytes[6] = static_cast<char>(type);
    put(8, 70);  // top, left
    put(10, 300);
    put(16, static_cast<unsigned>(n));
    put(50, options);
    for (std::size_t k = 0; k < n; ++k) {
        put(64 + 2 * k, static_cast<unsigned>(std::lround(points[k].x) - 300));
        put(64 + 2 * (n + k), static_cast<unsigned>(std::lround(points[k].y) - 70));
    }
    for (std::size_t k = 0; (options & 128) != 0 && k < n; ++k) {
        for (const auto& [at, value] : {std::pair{64 + 4 * n + 4 * k, points[k].x},
                                        std::pair{64 + 4 * n + 4 * (n + k), points[k].y}}) {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
            put(at, bits >> 16);
            put(at + 2, bits & 0xFFFF);
        }
    }
    return bytes;
}

TEST(OutlineFile, may_be_a_region_of_imagej) {
    std::vector<Vec2> disc = circle(20.0, 100);
    for (Vec2& p : disc) p += Vec2{321.25, 95.5};
    CellsCase cells;
    EXPECT_EQ(faults_of(roi_of(disc, 7, 128)),
              "o.csv: its numbers are pixels; write pixel = \"0.1 um\", the side of one, in "
              "[cells]");
    cells.pixel = Length{2e-7};
    const CellOutline parts = read_outline(roi_of(disc, 7, 128), "o.roi", cells);
    EXPECT_TRUE(parts.remarks.empty());
    EXPECT_EQ(parts.given, 100);
    EXPECT_NEAR(measures_of(parts).area, 4e-14 * area_of(disc), 1e-17);
    // A square with one corner cut, the upper right one on the screen.
    const std::vector<Vec2> cut{{300, 70},  {310, 70},  {330, 90},  {330, 110},
                                {320, 110}, {310, 110}, {300, 110}, {300, 90}};
    for (const int type : {0, 8}) {
        const CellOutline whole = read_outline(roi_of(cut, type), "o.roi", cells);
        EXPECT_NEAR(measures_of(whole).area, 4e-14 * (30 * 40 - 200), 1e-20);
        const Vec2 middle = whole.points[0];
        EXPECT_LT(std::abs(middle.x), 5e-6);
        double right_top = -1.0, left_top = -1.0;
        for (const Vec2 p : whole.points) {
            right_top = std::max(right_top, p.x + p.y);
            left_top = std::max(left_top, -p.x + p.y);
        }
        EXPECT_LT(right_top, left_top);  // y is turned upwards
    }
    EXPECT_EQ(faults_of(roi_of({{300, 70}, {310, 80}, {320, 70}}, 0), cells),
              "o.csv: 3 points are too few for an outline; at least 8 are needed");
    std::vector<Vec2> spur = cut;
    spur.insert(spur.begin() + 3, {{340, 90}, {330, 90}});
    EXPECT_NE(faults_of(roi_of(spur, 0), cells).find("point 3 and point 5 are the same"),
              std::string::npos);
}

TEST(OutlineFile, of_imagej_without_an_outline_is_refused_by_the_name_of_its_type) {
    const std::vector<Vec2> disc = circle(20.0, 100);
    CellsCase cells;
    cells.pixel = Length{2e-7};
    const auto told = [&](const std::string& bytes, const std::string& word) {
        EXPECT_NE(faults_of(bytes, cells).find(word), std::string::npos) << faults_of(bytes, cells);
    };
    told(roi_of(disc, 1), "type rectangle");
    told(roi_of(disc, 2), "type oval");
    told(roi_of(disc, 5), "type segmented line");
    told(roi_of(disc, 10), "type points");
    told(roi_of(disc, 99), "unknown type");
    told(roi_of(disc, 0, 1), "fitted by a spline");
    std::string composite = roi_of(disc, 1);
    composite[39] = 8;
    told(composite, "type composite");
    const std::string whole = roi_of(disc, 0, 128);
    for (const std::size_t size : {4u, 63u, 64u, 300u, 464u, 1263u})
        told(whole.substr(0, size), "cut short");
    std::string huge = whole.substr(0, 64);
    huge[16] = huge[17] = 0;
    huge[18] = huge[19] = '\xFF';
    told(huge, "at most 100000 points");
    std::string nan = whole;
    nan[464] = nan[465] = '\x7F';
    nan[465] = '\xFF';
    told(nan, "point 1 is at no place");
    told("PK\x03\x04", "zip archive");
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

class ShapeFile : public TemporaryDirectory {
protected:
    /// A case with this outline in a box of 20 by 20 um.
    std::string case_with(const std::string& outline, const std::string& more = "") const {
        std::ofstream(path("o.csv")) << outline;
        std::ofstream(path("c.toml"))
            << "format = 1\n[domain]\nlength = \"20 um\"\nwidth = \"20 um\"\n[flow]\n"
               "drive = \"shear\"\nshear_rate = \"100 /s\"\n[cells]\nshape = \"file\"\n"
               "file = \"o.csv\"\n"
            << more << "[numerics]\ndx = \"0.2 um\"\n[time]\nend = \"1 ms\"\n";
        return path("c.toml").string();
    }
    State start(const std::string& outline, const std::string& more = "") const {
        const Case c = read_case(case_with(outline, more));
        return initial_state(c, discretise(c));
    }
    Outcome check(const std::string& outline, const std::string& more = "",
                  const std::vector<std::string>& words = {}) const {
        std::vector<std::string> all{"check", case_with(outline, more)};
        all.insert(all.end(), words.begin(), words.end());
        return run(all);
    }
};

TEST_F(ShapeFile, stands_with_its_centroid_where_the_cell_is_put) {
    std::string half_disc, rectangle = "0,0\n8,0\n";
    for (int k = 0; k <= 40; ++k)  // dense along the arc, the straight side by its ends alone
        half_disc += fmt::format("{},{}\n", 5.0 * std::sin(std::numbers::pi * k / 40),
                                 -4.0 * std::cos(std::numbers::pi * k / 40));
    for (int k = 1; k <= 39; ++k) rectangle += fmt::format("8,{}\n", 0.1 * k);
    rectangle += "8,4\n0,4\n0,2\n0,1\n0,0.5\n";
    for (const std::string& outline : {text_of(repeated(ellipse_60)), half_disc, rectangle}) {
        const State state = start(outline, "angle = \"30 deg\"\n");
        const Vec2 centroid = area_moments(tt::outline(state.cells, 0)).centroid;
        EXPECT_NEAR(centroid.x, 50.0, 1e-9);
        EXPECT_NEAR(centroid.y, 50.0, 1e-9);
    }
}

TEST_F(ShapeFile, is_the_size_of_the_cells_and_radius_is_not) {
    const std::string text = text_of(ellipse(6.0, 4.0, 200));
    const Case own = read_case(case_with(text));
    const Case other = read_case(case_with(text, "radius = \"8 um\"\n"));
    const double radius =
        std::sqrt(24e-12) * std::sqrt(area_of(ellipse(6.0, 4.0, 200)) / (24.0 * std::numbers::pi));
    EXPECT_NEAR(equivalent_radius(own).si, radius, 1e-15);
    EXPECT_EQ(equivalent_radius(other).si, equivalent_radius(own).si);
    EXPECT_EQ(choose(other).dt.si, choose(own).dt.si);
    const Json judged = Json::parse(check(text, "radius = \"8 um\"\n", {"--json"}).out);
    EXPECT_NEAR(judged["shear_number"].get<double>(), 1.2e-3 * 100.0 * radius / 6e-6, 1e-9);
    EXPECT_NEAR(judged["outline"]["area_m2"].get<double>(), std::numbers::pi * radius * radius,
                1e-20);
    EXPECT_NE(judged["advice"].dump().find("radius = 8 um in [cells] is not used"),
              std::string::npos);
}

TEST_F(ShapeFile, that_is_no_cell_is_refused_by_check) {
    const auto refused = [&](const std::string& outline, const std::string& cause) {
        const Outcome outcome = check(outline);
        EXPECT_EQ(outcome.code, 2) << outcome.out;
        EXPECT_NE(outcome.err.find(cause), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.err.find("overlap"), std::string::npos) << outcome.err;
        return outcome.err;
    };
    refused(text_of(ellipse_60) + text_of(ellipse_60), "o.csv:61:1: the outline is written twice");
    refused(text_of(ellipse(0.04, 0.03, 60)), "smaller than any cell and than dx = 0.2 um");
    refused(text_of(ellipse(50.0, 30.0, 60)), "100 um by 60 um, longer than the box");
    const std::string told =
        refused(text_of(ellipse(11.0, 3.0, 60)), "meets its own periodic image");
    EXPECT_NE(told.find("tanktread: 1 fault;"), std::string::npos) << told;
    refused("0,0\n1e8,0\n1e8,1\n1e8,2\n1e8,3\n5,3\n4,3\n0,3\n", "longer than the box");
    // Two halves that a neck joins, with a kink narrower than the nodes are apart.
    refused(
        "-4,-3\n0,-3\n4,-3\n4,-1\n0.01,-1\n0.01,-0.1\n0.31,0\n0.01,0.1\n0.01,1\n4,1\n4,3\n"
        "-4,3\n-4,1\n-0.01,1\n-0.01,0.1\n0.28,0\n-0.01,-0.1\n-0.01,-1\n-4,-1\n",
        "thinner than the grid");
    const Outcome missing =
        run({"check", case_with(text_of(ellipse_60)), "--set", "cells.file=none.csv"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_NE(missing.err.find("none.csv"), std::string::npos);
}

TEST_F(ShapeFile, is_told_by_check_and_in_the_log_of_the_run) {
    const std::string told = "60 points, counter-clockwise in the file; 6 x 4 um";
    EXPECT_NE(check(text_of(ellipse_60)).out.find("o.csv: 60 points"), std::string::npos);
    const Outcome outcome = run({"run", case_with(text_of(ellipse_60)), "--set", "time.end=2 us",
                                 "-o", path("results").string(), "--progress", "none"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::ifstream log(path("results/run.log"));
    const std::string lines{std::istreambuf_iterator<char>(log), {}};
    EXPECT_NE(lines.find(told), std::string::npos) << lines;
}

TEST_F(ShapeFile, is_kept_in_the_results_which_stand_alone) {
    const std::vector<Vec2> shape = ellipse(3.0, 2.0, 60);
    const std::string given = case_with(text_of(shape));
    const std::string whole = path("whole").string(), parts = path("parts").string();
    const std::vector<std::string> quiet{"--progress", "none", "--set", "time.end=0.1 ms"};
    const auto with = [&](std::vector<std::string> words) {
        words.insert(words.end(), quiet.begin(), quiet.begin() + (words[0] == "run" ? 4 : 2));
        return run(words);
    };
    ASSERT_EQ(with({"run", given, "-o", whole}).code, 0);
    ASSERT_EQ(with({"run", given, "-o", parts, "--until", "0.05 ms"}).code, 75);
    const Json provenance = read_json(path("parts/PROVENANCE.json"));
    ASSERT_EQ(provenance["inputs"].size(), 1u);
    EXPECT_EQ(provenance["inputs"][0]["file"], "inputs/o.csv");
    EXPECT_EQ(provenance["inputs"][0]["hash"], hexadecimal(checksum(text_of(shape))));
    EXPECT_EQ(read_file(path("parts/inputs/o.csv")), text_of(shape));

    // The same command, and other content at the same place.
    std::ofstream(path("o.csv")) << text_of(ellipse(3.0, 2.1, 60));
    EXPECT_EQ(with({"run", given, "-o", parts}).code, 4);
    // The content of before, elsewhere, is the same case.
    case_with(text_of(shape));
    std::filesystem::rename(path("o.csv"), path("renamed.csv"));
    EXPECT_EQ(with({"run", given, "--set", "cells.file=renamed.csv", "-o", whole}).code, 0);

    std::filesystem::remove(path("renamed.csv"));
    std::filesystem::remove(path("c.toml"));
    std::filesystem::create_directory(path("far"));
    std::filesystem::rename(parts, path("far/moved"));
    const std::string moved = path("far/moved").string();
    const Outcome resumed = with({"resume", moved});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    for (const char* name : {"series.csv", "cells.csv", "resolved.toml"})
        EXPECT_EQ(read_file(path(std::string("far/moved/") + name)),
                  read_file(path(std::string("whole/") + name)))
            << name;

    std::ofstream(path("whole/inputs/o.csv")) << text_of(ellipse(3.0, 2.1, 60));
    EXPECT_EQ(with({"resume", whole}).code, 4);
}

}  // namespace
