#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "outline_text.hpp"

using namespace tt;

namespace {

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

TEST(ImagejRoi, is_read_in_pixels_with_y_down) {
    std::vector<Vec2> disc = circle(20.0, 100);
    for (Vec2& p : disc) p += Vec2{321.25, 95.5};
    OutlineShape shape;
    EXPECT_EQ(faults_of(roi_of(disc, 7, 128)),
              "o.csv: its numbers are pixels; write pixel = \"0.1 um\", the side of one, in "
              "[cells]");
    shape.pixel = Length{2e-7};
    const CellOutline parts = read_outline(roi_of(disc, 7, 128), "o.roi", shape);
    EXPECT_TRUE(parts.remarks.empty());
    EXPECT_EQ(parts.given, 100);
    EXPECT_NEAR(measures_of(parts).area, 4e-14 * area_of(disc), 1e-17);
    // A square with one corner cut, the upper right one on the screen.
    const std::vector<Vec2> cut{{300, 70},  {310, 70},  {330, 90},  {330, 110},
                                {320, 110}, {310, 110}, {300, 110}, {300, 90}};
    for (const int type : {0, 8}) {
        const CellOutline whole = read_outline(roi_of(cut, type), "o.roi", shape);
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
    EXPECT_EQ(faults_of(roi_of({{300, 70}, {310, 80}, {320, 70}}, 0), shape),
              "o.csv: 3 points are too few for an outline; at least 8 are needed");
    std::vector<Vec2> spur = cut;
    spur.insert(spur.begin() + 3, {{340, 90}, {330, 90}});
    EXPECT_NE(faults_of(roi_of(spur, 0), shape).find("point 3 and point 5 are the same"),
              std::string::npos);
}

TEST(ImagejRoi, without_an_outline_is_refused_by_the_name_of_its_type) {
    const std::vector<Vec2> disc = circle(20.0, 100);
    OutlineShape shape;
    shape.pixel = Length{2e-7};
    const auto told = [&](const std::string& bytes, const std::string& word) {
        EXPECT_NE(faults_of(bytes, shape).find(word), std::string::npos) << faults_of(bytes, shape);
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

}  // namespace
