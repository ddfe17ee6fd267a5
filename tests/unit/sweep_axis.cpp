#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/sweep_axis.hpp"

namespace {

/// What the values of an axis come to, or the fault.
std::string read(const std::string& text) {
    std::vector<tt::Fault> faults;
    const tt::SweepAxis axis = tt::axis_of_option(text, faults);
    if (!faults.empty()) return faults.front().message;
    std::string all;
    for (const tt::SweptKey& swept : axis.keys) {
        all += (all.empty() ? "" : "; ") + swept.key + ":";
        for (const tt::SweepValue& value : swept.values) all += " " + value.text + " |";
    }
    return all;
}

TEST(SweepAxis, is_a_list_a_range_or_keys_that_change_together) {
    EXPECT_EQ(read("flow.shear_number=0.1,0.5, 1"), "flow.shear_number: 0.1 | 0.5 | 1 |");
    EXPECT_EQ(read("flow.shear_number=0.1:0.5:0.1"),
              "flow.shear_number: 0.1 | 0.2 | 0.3 | 0.4 | 0.5 |");
    EXPECT_EQ(read("a.b=3:1:-1"), "a.b: 3 | 2 | 1 |");
    EXPECT_EQ(read("a.b=0.01:10:*10"), "a.b: 0.01 | 0.1 | 1 | 10 |");
    EXPECT_EQ(read("a.b=1:3:1,10"), "a.b: 1 | 2 | 3 | 10 |");
    EXPECT_EQ(read("a.b=20, 40 um"), "a.b: 20 um | 40 um |");
    EXPECT_EQ(read("a.b=50:150:50 /s"), "a.b: 50 /s | 100 /s | 150 /s |");
    EXPECT_EQ(read("a.b=50 /s:150 /s:50 /s"), "a.b: 50 /s | 100 /s | 150 /s |");
    EXPECT_EQ(read("a.b=[], shear, [shear, area]"), "a.b: none | shear | shear, area |");
    EXPECT_EQ(read("a.b=1,2 um; c.d=3,4"), "a.b: 1 um | 2 um |; c.d: 3 | 4 |");
}

TEST(SweepAxis, says_what_to_write_where_it_cannot_be_read) {
    EXPECT_EQ(read("shear_number=1"),
              "write --over table.key=VALUES, as in --over flow.shear_number=0.1:1:0.1");
    EXPECT_EQ(read("a.b=0.1:1:0.4"), "the steps of 0.4 do not end at 1; write 0.9 or 1.3 for it");
    EXPECT_NE(read("a.b=1:2").find("write a list, as in"), std::string::npos);
    EXPECT_NE(read("a.b=1:2:0").find("no steps of 0 lead from 1 to 2"), std::string::npos);
    EXPECT_NE(read("a.b=1:2:*0.5").find("no steps of *0.5 lead from 1 to 2"), std::string::npos);
    EXPECT_NE(read("a.b=1 um:2 mm:1 um").find("of one unit; write 1:2:1 um"), std::string::npos);
    EXPECT_NE(read("a.b=0:1:1e-9").find("at most 10000 will do"), std::string::npos);
    EXPECT_NE(read("a.b=1,,2").find("a value is missing"), std::string::npos);
    EXPECT_NE(read("a.b=1,2; c.d=3").find("a.b has 2 values and c.d has 1"), std::string::npos);
    EXPECT_NE(read("a.b=1,2; a.b=3,4").find("a.b is written twice"), std::string::npos);
}

TEST(SweepAxis, of_the_command_line_reads_back_from_its_file) {
    std::vector<tt::Fault> faults;
    for (const char* text : {"flow.shear_number=0.1:0.3:0.1", "a.b=[], shear, [shear, area]",
                             "a.b=1,2 um; c.d=on,off"}) {
        const tt::SweepAxis axis = tt::axis_of_option(text, faults);
        const tt::TomlText toml = tt::parse_toml(tt::to_toml(axis), "t");
        ASSERT_TRUE(toml.faults.empty()) << tt::to_toml(axis);
        const tt::SweepAxis back =
            tt::axis_of_table(toml.root.find("over")->value.items.front(), "t", faults);
        EXPECT_TRUE(faults.empty());
        ASSERT_EQ(back.keys.size(), axis.keys.size());
        for (std::size_t k = 0; k < axis.keys.size(); ++k) {
            EXPECT_EQ(back.keys[k].key, axis.keys[k].key);
            for (std::size_t v = 0; v < axis.size(); ++v)
                EXPECT_EQ(back.keys[k].values[v].text, axis.keys[k].values[v].text);
        }
    }
}

}  // namespace
