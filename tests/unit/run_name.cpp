#include "case/run_name.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "case/read.hpp"

namespace tt {
namespace {

const std::string rest =
    "format = 1\n[domain]\nlength = \"20 um\"\nwidth = \"12 um\"\n[cells]\nradius = \"3 um\"\n"
    "[time]\nend = \"1 ms\"\n";

std::string faults_of_case(const std::string& text,
                           const std::vector<std::string>& overrides = {}) {
    try {
        parse_case(text, "case.toml", overrides);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "none";
}

TEST(RunName, one_that_leaves_results_or_no_disk_can_hold_is_refused_with_one_that_will_do) {
    const std::string long_name(101, 'n');
    for (const std::string& name :
         {std::string(), std::string("/tmp/x"), std::string("../x"), std::string("a/b"),
          std::string(".."), std::string("."), std::string(".x"), std::string("a..b"),
          std::string("-rf"), std::string(" x"), std::string("x "), std::string("a\nb"),
          std::string("a\x7f"), std::string("caf\xc3\xa9"), std::string("\xff"), long_name,
          std::string("a\0b", 3), std::string("a\\b")}) {
        EXPECT_TRUE(fault_of_name(name)) << name;
        EXPECT_FALSE(fault_of_name(name_from(name))) << name_from(name);
        EXPECT_NE(faults_of_case(rest, {"name=\"" + name + "\""}), "none") << name;
    }
    EXPECT_EQ(faults_of_case("name = \"../up\"\n" + rest),
              "case.toml:1:1: name may hold letters of ASCII, digits, spaces and marks, but no "
              "'/' and no '\\'; write name = \"run.__up\"");
    EXPECT_EQ(name_from("\xc3\xa9"), "run");
    EXPECT_EQ(name_from("caf\xc3\xa9"), "caf_");
    for (const char* name : {"channel-500-LD", "G=0.2, x2", "_", "7", "a.b <i> & 'c'"}) {
        EXPECT_FALSE(fault_of_name(name)) << name;
        EXPECT_EQ(name_from(name), name);
    }
}

TEST(RunName, one_made_of_the_name_of_a_file_will_do) {
    EXPECT_EQ(parse_case(rest, "../kan\xc3\xa4le/1 \n.toml").name, "1 _");
    EXPECT_EQ(parse_case(rest, "-x/case.toml").name, "run-x");
    EXPECT_EQ(parse_case(rest, std::string(250, 'x') + ".toml").name, std::string(100, 'x'));
}

}  // namespace
}  // namespace tt
