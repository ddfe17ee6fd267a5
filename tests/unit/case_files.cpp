#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "case/read.hpp"
#include "case/write.hpp"
#include "io/toml.hpp"
#include "source_dir.hpp"

namespace {

namespace fs = std::filesystem;
const fs::path source = TT_SOURCE_DIR;

std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// All faults of a text, one a line.
std::string faults_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        tt::parse_case(text, "case.toml", overrides, ".");
    } catch (const tt::CaseError& error) {
        return error.what();
    }
    return "none";
}

const std::string channel = content(source / "cases/05-channel/case.toml");

/// `text` with the first `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(CaseFile, nesting_is_followed_only_as_deep_as_a_case_may_need) {
    const auto keys = [](int levels) {
        std::string key = "k";
        for (int k = 1; k < levels; ++k) key += ".k";
        return key;
    };
    const auto lists = [](int levels) {
        return "x = " + std::string(levels, '[') + std::string(levels, ']');
    };
    const std::string deep = "nest deeper than 16 levels";
    for (const std::string& text :
         {keys(18) + " = 1", "[" + keys(18) + "]", "[[" + keys(18) + "]]",
          "x = {" + keys(18) + "=1}", lists(17), "x = " + std::string(17, '{')})
        EXPECT_NE(faults_of(text).find(deep), std::string::npos) << text;
    EXPECT_EQ(faults_of(keys(17) + " = 1").find(deep), std::string::npos);
    EXPECT_EQ(faults_of(lists(16)).find(deep), std::string::npos);
    EXPECT_EQ(faults_of("x = \"" + keys(99) + "\" # " + keys(99)).find(deep), std::string::npos);
    EXPECT_EQ(faults_of("x = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, "
                        "1.4, 1.5, 1.6, 1.7, 1.8]")
                  .find(deep),
              std::string::npos);
}

TEST(CaseFile, each_case_that_comes_with_the_program_can_be_read) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(source / "cases")) {
        if (!fs::exists(entry.path() / "case.toml")) continue;
        EXPECT_NO_THROW(tt::read_case(entry.path() / "case.toml")) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 1);
}

TEST(CaseFile, bad_cases_are_told_what_to_write) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(source / "tests/unit/cases_bad")) {
        if (entry.path().extension() != ".toml") continue;
        const fs::path golden = fs::path(entry.path()).replace_extension(".txt");
        EXPECT_EQ(faults_of(content(entry.path())) + "\n", content(golden)) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 20);
}

TEST(CaseFile, what_is_written_reads_back_to_the_same_case) {
    for (const auto& entry : fs::directory_iterator(source / "cases")) {
        if (!fs::exists(entry.path() / "case.toml")) continue;
        const tt::Case c = tt::read_case(entry.path() / "case.toml");
        EXPECT_EQ(tt::parse_case(tt::to_toml(c), "resolved.toml", {}, entry.path()), c)
            << entry.path();
    }
}

TEST(CaseFile, the_same_physics_in_other_units_is_the_same_case) {
    std::string other = channel;
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"\"80 um\"", "\"0.08 mm\""},
                                                          {"\"20 um\"", "\"2e-5 m\""},
                                                          {"\"500 /s\"", "\"0.5 1/ms\""},
                                                          {"\"1.2 cP\"", "\"1.2 mPa s\""},
                                                          {"\"1025 kg/m^3\"", "\"1.025 g/cm^3\""},
                                                          {"\"4 um\"", "\"4000 nm\""},
                                                          {"\"6 cP\"", "\"0.06 P\""},
                                                          {"\"6e-3 dyn/cm\"", "\"6 µN/m\""},
                                                          {"\"1.8e-12 dyn cm\"", "\"1.8e-19 J\""},
                                                          {"\"0.49 um\"", "\"490 nm\""},
                                                          {"\"3.84 /um\"", "\"3.84e6 /m\""},
                                                          {"\"1.3e-7 J/m^2\"", "\"0.13 uN/m\""},
                                                          {"\"80 ms\"", "\"0.08 s\""},
                                                          {"\"5 min\"", "\"300 s\""}})
        other = with(other, from, to);
    EXPECT_EQ(tt::parse_case(other, "case.toml"), tt::parse_case(channel, "case.toml"));
}

/// Swaps two letters of each key in turn, drops one, doubles one.
TEST(CaseFile, every_key_misspelt_once_is_rejected) {
    const std::string all = tt::to_toml(tt::parse_case(channel, "case.toml"));
    ASSERT_EQ(faults_of(all), "none");
    std::istringstream lines(all);
    int keys = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t end = line.find_first_of(" ]", line[0] == '[' ? 1 : 0);
        const std::size_t begin = line[0] == '[' ? 1 : 0;
        if (line.empty() || line[0] == '#') continue;
        const std::string key = line.substr(begin, end - begin);
        std::vector<std::string> typos{key + key.back()};
        if (key.size() > 1) typos.push_back(key.substr(1));
        for (const std::string& typo : typos) {
            const std::string text =
                with("\n" + all, "\n" + line.substr(0, end), "\n" + line.substr(0, begin) + typo);
            EXPECT_NE(faults_of(text).find("unknown "), std::string::npos) << typo << '\n'
                                                                           << faults_of(text);
        }
        ++keys;
    }
    EXPECT_GT(keys, 40);
}

TEST(CaseFile, a_fault_stands_where_the_product_page_says) {
    const std::string text = with(channel, "\npseudo_shear_rate", "\npseudo_shear");
    EXPECT_NE(
        faults_of(text).find("case.toml:15:1: unknown key 'pseudo_shear' in [flow]; did you mean "
                             "'pseudo_shear_rate'?"),
        std::string::npos)
        << faults_of(text);
}

TEST(CaseFile, overrides_follow_the_rules_of_the_file) {
    const tt::Case c =
        tt::parse_case(channel, "case.toml",
                       {"flow.pseudo_shear_rate=150 /s", "membrane.hardening.apply_to=[]", "name=7",
                        "numerics.dx=\"0.25 um\"", "cells.hematocrit=38 %"});
    EXPECT_EQ(c.flow.channel()->pseudo_shear_rate->si, 150.0);
    EXPECT_TRUE(c.membrane.hardening.apply_to.empty());
    EXPECT_EQ(c.name, "7");
    EXPECT_EQ(c.numerics.dx->si, 2.5e-7);
    EXPECT_FALSE(c.cells.count.has_value());
    EXPECT_EQ(c.cells.hematocrit, 0.38);
    const tt::Case two =
        tt::parse_case(channel, "case.toml", {"membrane.hardening.apply_to=[shear, area]"});
    EXPECT_EQ(two.membrane.hardening.apply_to,
              (std::vector{tt::Modality::shear, tt::Modality::area}));
    EXPECT_EQ(faults_of(channel, {"flow.pseudo_shear_rate=150"}),
              "--set flow.pseudo_shear_rate=150: pseudo_shear_rate = 150 has no unit; write "
              "pseudo_shear_rate = \"150 /s\"");
    EXPECT_EQ(faults_of(channel, {"output.frames=0"}),
              "--set output.frames=0: frames = 0 has no unit; write frames = \"1 ms\"");
    EXPECT_EQ(faults_of(channel, {"flow.shear=1 /s"}),
              "--set flow.shear=1 /s: unknown key 'shear' in [flow]; did you mean 'shear_rate'?");
    EXPECT_NE(faults_of(channel, {"nonsense"}).find("write --set table.key=value"),
              std::string::npos);
    EXPECT_NE(faults_of(channel, {"name.x=1"}), "none");
    EXPECT_NE(faults_of(channel, {"a.b.c.d.e=1"}), "none");
    EXPECT_NE(faults_of(channel, {"=1"}), "none");
    EXPECT_NE(faults_of(channel, {"flow=1"}), "none");
}

TEST(CaseFile, auto_is_the_same_as_leaving_out) {
    EXPECT_EQ(
        tt::parse_case(with(channel, "dx             = \"0.2 um\"", "dx = \"auto\""), "case.toml"),
        tt::parse_case(with(channel, "dx             = \"0.2 um\"", ""), "case.toml"));
}

TEST(CaseFile, fields_can_be_switched_off) {
    const tt::Case c = tt::parse_case(channel, "case.toml", {"output.fields=never"}, ".");
    EXPECT_TRUE(std::isinf(c.output.fields.value().si));
    EXPECT_NE(tt::to_toml(c).find("fields = \"never\""), std::string::npos);
    EXPECT_EQ(tt::parse_case(tt::to_toml(c), "resolved.toml"), c);
}

TEST(CaseFile, name_is_that_of_the_folder_if_none_is_given) {
    const std::string text = with(channel, "name   = \"channel\"", "");
    EXPECT_EQ(tt::parse_case(text, "cases/05-channel/case.toml").name, "05-channel");
    EXPECT_EQ(tt::parse_case(text, "my.toml").name, "my");
}

TEST(CaseFile, byte_order_mark_and_carriage_returns_do_not_matter) {
    std::string text = "\xef\xbb\xbf" + channel;
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
        text.insert(at, "\r");
    EXPECT_EQ(tt::parse_case(text, "case.toml"), tt::parse_case(channel, "case.toml"));
}

TEST(CaseFile, no_text_crashes_the_reader) {
    const std::vector<std::string> texts{"",
                                         "\n",
                                         "[@ase]",
                                         "[cas\xc3\xa9]\n",
                                         "\xc3\xa9 = 1",
                                         "\"\\u00e9\" = 1",
                                         "\"\" = 1",
                                         "x",
                                         "=",
                                         "[",
                                         "[[",
                                         "[[flow]]",
                                         "x = \"\"\"",
                                         "x = '",
                                         "a.b.c = 1\na.b = 2",
                                         "x = {",
                                         "x = [1, ",
                                         std::string("x = \0", 5),
                                         "\xff\xfe",
                                         "\xff",
                                         "flow = [[[[[[[[[[[[[[[",
                                         std::string(2000, '['),
                                         "x = " + std::string(5000, '['),
                                         "flow.drive.x = 1",
                                         "x = 1979-05-27",
                                         "time.end = inf",
                                         "domain.length = nan",
                                         "x = 99999999999999999999",
                                         "# \xe2\x82\xac comment only",
                                         "\"\\uD800\" = 1",
                                         "\"a\\",
                                         "[a]\n[a]",
                                         "[domain]\nlength=\"\\u00b5m\"",
                                         "cells = {count = 1}",
                                         "x = 1 # \xff"};
    for (const std::string& text : texts) EXPECT_NE(faults_of(text), "none") << text;
    EXPECT_NE(faults_of(std::string(2000000, 'x')).find("has 2 MB"), std::string::npos);
}

TEST(CaseFile, shorn_and_scrambled_texts_never_crash_the_reader) {
    for (std::size_t i = 0; i < channel.size(); i += 7) {
        faults_of(channel.substr(0, i));
        std::string text = channel;
        text[i] = static_cast<char>("\"[]{}=.#\\'\n\xc2\x00\xff@"[i % 15]);
        faults_of(text);
    }
}

}  // namespace
