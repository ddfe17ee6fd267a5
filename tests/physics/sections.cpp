#include "simulation/sections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "membrane/outline.hpp"
#include "observe/run_measures.hpp"
#include "observe/section_series.hpp"
#include "simulation/health.hpp"
#include "simulation/run.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

using Changes = std::vector<std::string>;

template <class T>
std::size_t number_of(const std::vector<T>& named, const std::string& name) {
    for (std::size_t n = 0; n < named.size(); ++n)
        if (named[n].name == name) return n;
    throw std::out_of_range(name);
}

/// Plasma alone, after so many steps.
struct Plasma {
    Case c;
    Choice choice;
    Model model;
    State state;

    Plasma(const std::string& file, Changes changes, std::int64_t steps) {
        changes.insert(changes.end(), {"numerics.fluid_only=true", "numerics.precision=double"});
        c = read_case(TT_SOURCE_DIR "/cases/" + file + "/case.toml", changes);
        choice = choose(c);
        model = discretise(c, choice);
        model.threads = 2;
        state = initial_state(c, model, {});
        Periodic exchange;
        Health health({}, state);
        run_steps(model, state, exchange, health, steps, Clock::time_point::max());
    }
    double flow(const std::string& section) const {
        return flow_rate_at(model, state, number_of(model.sections, section));
    }
    double relative_viscosity(const std::string& stretch) const {
        return tt::relative_viscosity(model, state,
                                      model.stretches[number_of(model.stretches, stretch)]);
    }
};

Changes section(const std::string& name, const std::string& from, const std::string& to) {
    return {"section." + name + ".from=[" + from + "]", "section." + name + ".to=[" + to + "]"};
}

Changes joined(std::initializer_list<Changes> lists) {
    Changes all;
    for (const Changes& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

// Where walls lie between sites the sum of u over the sites is not the flow rate. What passes the
// links is what passes the ports.
TEST(Sections, tell_the_flow_of_the_ports_through_straight_and_slanting_channels) {
    const Plasma fork(
        "07-fork",
        joined({{"numerics.dx=0.5 um", "time.end=40 ms"},
                section("parent", R"("40 um", "-10 um")", R"("40 um", "10 um")"),
                section("upper_leg", R"("85 um", "11 um")", R"("85 um", "29 um")"),
                section("upper_end", R"("125 um", "27 um")", R"("125 um", "40 um")"),
                section("lower_leg", R"("80 um", "-13.5 um")", R"("80 um", "-25 um")"),
                {"fork.y.parent=parent", R"(fork.y.daughters=["upper_leg", "lower_leg"])"}}),
        2500);
    const double sampled = fork.model.boundaries.walls->sampled_flow();
    const auto port = [&](std::size_t n) { return fork.state.ports[n].mean_inflow() / sampled; };
    EXPECT_NEAR(fork.flow("parent") / port(0), 1.0, 1e-3);
    EXPECT_NEAR(fork.flow("upper_leg") / -port(2), 1.0, 1e-3);
    EXPECT_NEAR(fork.flow("upper_end") / -port(2), 1.0, 1e-3);
    EXPECT_NEAR(fork.flow("lower_leg") / port(1), 1.0, 1e-3)
        << "drawn downwards: forward is to the left";
    EXPECT_NEAR(fork.relative_viscosity("before"), 1.0, 1e-3);
}

TEST(Sections, tell_the_flow_and_no_resistance_of_cells_in_a_straight_channel) {
    for (const char* drive : {"pressure", "body-force"}) {
        const Plasma channel(
            "05-channel",
            joined({{std::string("flow.drive=") + drive, "numerics.dx=1 um", "time.end=1 ms"},
                    section("near", R"("20 um", "0 um")", R"("20 um", "20 um")"),
                    section("far", R"("61 um", "20 um")", R"("61 um", "0 um")"),
                    {"stretch.all.from=near", "stretch.all.to=far"}}),
            4000);
        const double exact = flux(channel.model, channel.state);
        EXPECT_NEAR(channel.flow("near") / exact, 1.0, 1e-4) << drive;
        EXPECT_NEAR(channel.flow("far") / exact, -1.0, 1e-4) << drive;
        EXPECT_NEAR(channel.relative_viscosity("all"), 1.0, 1e-4) << drive;
    }
}

TEST(Sections, tell_the_flow_in_a_narrowing_and_between_posts) {
    const Plasma stenosis("06-stenosis",
                          joined({{"numerics.dx=0.5 um", "time.end=1 ms"},
                                  section("wide", R"("10 um", "0 um")", R"("10 um", "20 um")"),
                                  section("throat", R"("60 um", "5 um")", R"("60 um", "15 um")"),
                                  {"stretch.all.from=wide", "stretch.all.to=throat"}}),
                          1000);
    const double exact = flux(stenosis.model, stenosis.state);
    for (const char* n : {"wide", "throat"}) EXPECT_NEAR(stenosis.flow(n) / exact, 1.0, 2e-3);
    EXPECT_NEAR(stenosis.relative_viscosity("all"), 1.0, 2e-3);
}

/// Whatever passes the section before a fork passes one of those behind it.
TEST(Sections, count_the_cells_that_leave_through_the_ports) {
    const Case c = read_case(
        TT_SOURCE_DIR "/cases/07-fork/case.toml",
        joined({{"numerics.dx=0.5 um", "cells.hematocrit=10 %"},
                section("upper_end", R"("140 um", "27 um")", R"("140 um", "40 um")"),
                section("lower_end", R"("140 um", "-40 um")", R"("140 um", "-31.5 um")")}));
    Model model = discretise(c);
    model.threads = 2;
    State state = initial_state(c, model, {});
    const auto beyond = [&](const State& s, double y) {
        std::int64_t count = 0;
        for (int cell = 0; cell < s.cells.cell_count(); ++cell) {
            const Vec2 middle = area_moments(outline(s.cells, cell)).centroid + model.origin;
            count += middle.x * model.scales.length > 140e-6 && (middle.y > 0.0) == (y > 0.0);
        }
        return count;
    };
    const std::int64_t upper = beyond(state, 1.0), lower = beyond(state, -1.0);
    Periodic exchange;
    Health health({}, state);
    run_steps(model, state, exchange, health, 4000, Clock::time_point::max());
    std::int64_t left[3] = {};
    for (const Departed& d : state.departed) ++left[d.exit];
    ASSERT_GT(left[2], 1);
    const SectionState& above = state.sections[number_of(model.sections, "upper_end")];
    const SectionState& below = state.sections[number_of(model.sections, "lower_end")];
    EXPECT_EQ(above.forward - above.backward, left[2] + beyond(state, 1.0) - upper);
    EXPECT_EQ(below.forward - below.backward, left[1] + beyond(state, -1.0) - lower);
}

}  // namespace
}  // namespace tt
