#include "observe/progress.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "io/json.hpp"

namespace tt {
namespace {

Standing standing() {
    Standing s;
    s.name = "channel";
    s.step = 421;
    s.steps = 1000;
    s.time = 0.03368;
    s.end = 0.08;
    s.steps_per_second = 1234.4;
    s.mlups = 58.23;
    s.seconds_left = 192.4;
    s.lambda_C = 1.0861;
    s.cells = 12;
    return s;
}

/// Columns on a terminal: bytes of UTF-8 but for those that continue a letter.
int columns(const std::string& text) {
    int count = 0;
    for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
    return count;
}

TEST(ProgressLine, says_how_far_how_fast_and_how_long) {
    EXPECT_EQ(progress_line(standing()),
              " 42.1 %  33.68/80 ms  1.23k steps/s  58.2 MLUPS  λ_C 1.086  3:12 left");
}

TEST(ProgressLine, fits_eighty_columns_up_to_ten_million_steps_a_second) {
    Standing s = standing();
    for (const double rate : {0.0, 1e-3, 123456.0, 9.87e6}) {
        for (const double left : {0.0, 1e4, 1e9, std::numeric_limits<double>::infinity()}) {
            s.steps_per_second = rate;
            s.mlups = rate;
            s.seconds_left = left;
            s.time = 1.2345678;
            s.end = 12.345678;
            s.lambda_C = 2.68812;
            EXPECT_LT(columns(progress_line(s)), 80) << progress_line(s);
        }
    }
}

TEST(RemarkOnLength, hours_and_days_are_told_in_words) {
    EXPECT_FALSE(takes_long(3599.0));
    EXPECT_TRUE(takes_long(3600.0));
    EXPECT_FALSE(takes_long(std::numeric_limits<double>::infinity()));
    EXPECT_EQ(remark_on_length(111'600.0).substr(0, 21), "About 31.0 h to the e");
    EXPECT_EQ(duration_text(12.3), "12 s");
    EXPECT_EQ(duration_text(300.0), "5 min");
    EXPECT_EQ(duration_text(1e6), "11.6 days");
}

TEST(ProgressLine, is_valid_json_even_before_the_first_step) {
    Standing s = standing();
    s.seconds_left = std::numeric_limits<double>::infinity();
    const Json line = Json::parse(progress_json(s));
    EXPECT_EQ(line["step"], 421);
    EXPECT_TRUE(line["seconds_left"].is_null());
}

}  // namespace
}  // namespace tt
