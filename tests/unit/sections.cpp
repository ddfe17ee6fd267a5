#include "case/sections.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/discretise.hpp"
#include "case/read.hpp"
#include "case/write.hpp"
#include "observe/section_measures.hpp"
#include "membrane/shapes.hpp"
#include "faults_of.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

std::string told(const std::vector<std::string>& set, const std::string& file = "07-fork") {
    std::vector<std::string> all = set;
    all.insert(all.end(), {"numerics.dx=1 um", "numerics.fluid_only=true"});
    return faults_of(
        [&] { discretise(read_case(TT_SOURCE_DIR "/cases/" + file + "/case.toml", all)); });
}

void expect_told(const std::vector<std::string>& set, const std::string& part) {
    const std::string all = told(set);
    EXPECT_NE(all.find(part), std::string::npos) << part << "\nis not in\n" << all;
}

std::vector<std::string> between(const std::string& from, const std::string& to) {
    return {"section.a.from=[" + from + "]", "section.a.to=[" + to + "]"};
}

TEST(SectionKeys, what_is_wrong_with_a_section_is_told_with_what_to_write) {
    expect_told({R"(section.a.from=["40 um", "-10 um"])"}, "to is an end of the section");
    expect_told(between(R"("40 um", "0 um")", R"("40 um", "0 um")"), "it has no length");
    expect_told(between(R"("40 um", "0 um")", R"("50 um", "10 um")"),
                "runs at 45 deg; a section lies along x or y: write from = [\"45 um\", \"0 um\"]");
    expect_told(between(R"("200 um", "0 um")", R"("200 um", "10 um")"), "not inside of the box");
    expect_told(between(R"("40 um", "20 um")", R"("40 um", "30 um")"),
                "it meets no fluid; at x = 40 um there is some from -10 um to 10 um; write from");
    expect_told(between(R"("120 um", "-40 um")", R"("120 um", "40 um")"), "it crosses 2 channels");
    expect_told(between(R"("40 um", "-5 um")", R"("40 um", "10 um")"), "it ends within the fluid");
    expect_told(
        {"section.inlet.from=[\"40 um\", \"-10 um\"]", "section.inlet.to=[\"40 um\", \"10 um\"]"},
        "'inlet' is the name of a port");
    EXPECT_EQ(told(between(R"("40 um", "-10 um")", R"("40 um", "10 um")")), "");
}

TEST(SectionKeys, several_faults_are_told_at_once) {
    std::vector<std::string> set = between(R"("40 um", "-5 um")", R"("40 um", "10 um")");
    set.insert(set.end(),
               {"section.b.from=[\"40 um\", \"20 um\"]", "section.b.to=[\"40 um\", \"30 um\"]"});
    const std::string all = told(set);
    EXPECT_NE(all.find("section 'a': it ends within"), std::string::npos) << all;
    EXPECT_NE(all.find("section 'b': it meets no fluid"), std::string::npos) << all;
}

TEST(SectionKeys, forks_and_stretches_name_sections_each_once) {
    expect_told({"fork.y.parent=p", R"(fork.y.daughters=["q", "r"])"}, "there is no section 'p'");
    std::vector<std::string> set = between(R"("40 um", "-10 um")", R"("40 um", "10 um")");
    set.insert(set.end(),
               {"section.b.from=[\"125 um\", \"27 um\"]", "section.b.to=[\"125 um\", \"40 um\"]"});
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), set.begin(), set.end());
        return more;
    };
    expect_told(with({"fork.y.parent=a", R"(fork.y.daughters=["b"])"}), "a fork has two daughters");
    expect_told(with({"fork.y.parent=a", R"(fork.y.daughters=["b", "b"])"}), "'b' is named twice");
    expect_told(with({"fork.y.parent=a", R"(fork.y.daughters=["a", "b"])"}),
                "'a' is parent and daughter");
    expect_told(with({"stretch.s.from=a", "stretch.s.to=c"}), "there is no section 'c'");
    expect_told(with({"stretch.s.from=a", "stretch.s.to=a"}), "'a' is named twice");
    expect_told(with({"stretch.s.from=a", "stretch.s.to=b"}), "a channel branches off");
}

TEST(SectionKeys, of_a_straight_channel_and_of_posts) {
    const auto in = [](const std::string& file, const std::string& from, const std::string& to) {
        return told(between(from, to), file);
    };
    EXPECT_EQ(in("05-channel", R"("40 um", "0 um")", R"("40 um", "20 um")"), "");
    EXPECT_NE(in("05-channel", R"("20 um", "5 um")", R"("40 um", "5 um")").find("no wall ends"),
              std::string::npos);
}

/// A disc that stands on a line: half of it has passed, and its chord is what lies on it.
TEST(SectionCells, of_a_disc_on_the_line) {
    Model model;
    model.lattice = {60, 20, true};
    Section section;
    section.line = section_line(model.lattice, nullptr, true, 30, 0.0, 20.0);
    model.sections = {section};
    State state;
    std::vector<Vec2> disc;
    for (int k = 0; k < 400; ++k) {
        const double a = 2.0 * 3.14159265358979 * k / 400;
        disc.push_back(Vec2{90.0, 8.0} + 5.0 * Vec2{std::cos(a), std::sin(a)});  // an image on
    }
    add_cell(state.cells, disc);
    state.sections.resize(1);
    const SectionCells on = cells_on_section(section.line, model.lattice, state.cells);
    EXPECT_NEAR(on.share, 10.0 / 20.0, 1e-3);
    EXPECT_NEAR(on.from_begin, 3.0, 1e-3);
    EXPECT_NEAR(on.from_end, 7.0, 1e-3);
    EXPECT_NEAR(on.share_of_row[7], 1.0, 1e-12);
    EXPECT_NEAR(on.share_of_row[2], 0.0, 1e-12);
    const double half = 0.5 * 3.14159265 * 25.0;
    EXPECT_NEAR(std::fabs(carried_area(model, state, 0)), half, 0.01 * half);
}

}  // namespace
}  // namespace tt
