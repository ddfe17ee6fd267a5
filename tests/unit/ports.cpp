#include "case/openings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "case/write.hpp"
#include "faults_of.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

const std::string fork = TT_SOURCE_DIR "/cases/07-fork/case.toml";

/// All that is told of the fork with these changes.
std::string told(const std::vector<std::string>& set) {
    return faults_of([&] { choose(read_case(fork, set)); });
}

void expect_told(const std::vector<std::string>& set, const std::string& part) {
    const std::string all = told(set);
    EXPECT_NE(all.find(part), std::string::npos) << part << "\nis not in\n" << all;
}

TEST(PortKeys, what_is_wrong_with_ports_is_told_with_what_to_write) {
    expect_told({R"(port.upper.at=["100 um", "0 um"])"}, "is on no piece of the drawing");
    expect_told({R"(port.upper.at=["80 um", "-25 um"])"}, "draw the channel with an end that does");
    expect_told({R"(port.upper.at=["170 um", "-36 um"])"}, "it lies where port 'lower' is");
    expect_told({"port.inlet.pressure=3 Pa"}, "pressure and mean_velocity are both given");
    expect_told({"port.lower.pressure=auto"}, "nothing is asked of this port");
    expect_told({"port.lower.pressure=auto", "port.lower.flow_rate=-1e-8 m^2/s",
                 "port.upper.pressure=auto", "port.upper.flow_rate=-2e-8 m^2/s"},
                "every port holds a flow");
    expect_told({"port.lower.pressure=3 um"}, "pressure");
    expect_told({"port.lower.presure=3 Pa"}, "did you mean 'pressure'");
    expect_told({"flow.drive=pressure", "flow.mean_velocity=1 mm/s"}, "means nothing with ports");
    expect_told({"domain.length=100 um"}, "the drawing takes 170 um; leave length out");
    expect_told({"geometry.fluid=outside"}, "has no channels between ports");
    expect_told({"numerics.equilibrium=full"}, "not possible with ports");
    expect_told({"geometry.unit=1 m"}, "look at the unit of its numbers");
    expect_told({"numerics.dx=3 um", "numerics.fluid_only=true"}, "the narrowest gap is");
    EXPECT_EQ(told({"numerics.dx=1 um", "numerics.fluid_only=true"}), "");
}

TEST(PortKeys, a_box_without_ports_still_takes_its_size) {
    try {
        parse_case("format = 1\n[numerics]\nfluid_only = true\n[time]\nend = \"1 ms\"\n", "test");
        FAIL();
    } catch (const CaseError& error) {
        std::string all;
        for (const Fault& fault : error.faults()) all += to_string(fault) + '\n';
        EXPECT_NE(all.find("length is missing from [domain]"), std::string::npos) << all;
        EXPECT_NE(all.find("width is missing from [domain]"), std::string::npos) << all;
    }
}

TEST(PortKeys, are_written_as_they_are_read) {
    const Case c = read_case(fork);
    ASSERT_EQ(c.ports.size(), 3u);
    EXPECT_EQ(c.ports[0].name, "inlet");
    EXPECT_DOUBLE_EQ(c.domain.length.si, 170e-6);
    EXPECT_DOUBLE_EQ(c.domain.width.si, 80e-6);
    const std::string text = to_toml(c);
    EXPECT_NE(text.find("[port.lower]"), std::string::npos);
    const Case again = parse_case(text, "again", {}, TT_SOURCE_DIR "/cases/07-fork");
    EXPECT_EQ(again.ports, c.ports);
    EXPECT_NE(key_lines(c).find("port.inlet.mean_velocity = \"1 mm/s\""), std::string::npos);
}

TEST(Openings, are_the_whole_straight_piece_whatever_points_lie_on_it) {
    Case c = read_case(fork);
    auto& drawn = std::get<DrawnShape>(c.geometry.shape);
    const auto before = port_places(c).openings;
    // Points in the middle of an end, and the loop begins at one of them.
    for (auto& loop : drawn.loops) {
        Loop more;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            more.push_back(loop[k]);
            more.push_back(0.5 * (loop[k] + loop[(k + 1) % loop.size()]));
        }
        std::rotate(more.begin(), more.end() - 1, more.end());
        loop = more;
    }
    const auto after = port_places(c).openings;
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t n = 0; n < before.size(); ++n) {
        EXPECT_NEAR(norm(after[n].from - before[n].from), 0.0, 1e-15);
        EXPECT_NEAR(norm(after[n].to - before[n].to), 0.0, 1e-15);
    }
    EXPECT_NEAR(width_of(before[1]), 8.5e-6, 1e-15);
}

TEST(CellsAtRandom, leave_the_ports_free) {
    // Both laid a cell into a port before ports were closed to them.
    for (int seed = 1; seed <= 2; ++seed) {
        const Case c = read_case(fork, {"numerics.dx=0.5 um", "cells.hematocrit=35 %",
                                        fmt::format("cells.seed={}", seed)});
        const Model model = discretise(c, choose(c));
        EXPECT_EQ(faults_of([&] { initial_state(c, model); }), "") << "seed " << seed;
    }
}

}  // namespace
}  // namespace tt
