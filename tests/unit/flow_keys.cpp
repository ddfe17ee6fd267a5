#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "case/appraise.hpp"
#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "faults_of.hpp"
#include "observe/cell_measures.hpp"
#include "observe/run_measures.hpp"
#include "observe/snapshot.hpp"
#include "simulation/advance.hpp"
#include "source_dir.hpp"
#include "base/parallel.hpp"

namespace tt {
namespace {

const std::string channel = TT_SOURCE_DIR "/cases/05-channel/case.toml";

Choice choice_with(const std::string& setting) { return choose(read_case(channel, {setting})); }

/// 20 um wide, 1.2 cP: U = k H = 10 mm/s, largest 15 mm/s, U H = 0.2 mm²/s, 6 μ k = 3.6 Pa, 12 μ
/// k/H = 360 kPa/m.
TEST(FlowKeys, each_names_the_same_flow) {
    const Choice by_rate = choice_with("flow.pseudo_shear_rate=500 /s");
    for (const char* setting :
         {"flow.mean_velocity=10 mm/s", "flow.largest_velocity=15 mm/s",
          "flow.flow_rate=0.2 mm^2/s", "flow.wall_stress=3.6 Pa",
          "flow.pressure_gradient=360 kPa/m", "flow.wall_stress=36 dyn/cm^2"}) {
        const Choice choice = choice_with(setting);
        EXPECT_NEAR(choice.shear_rate.si, 500.0, 1e-9) << setting;
        EXPECT_NEAR(choice.largest_speed.si, 0.015, 1e-15) << setting;
        EXPECT_NEAR(choice.pressure_gradient.si, 3.6e5, 1e-6) << setting;
        EXPECT_NEAR(choice.dt.si / by_rate.dt.si, 1.0, 1e-12) << setting;
    }
}

TEST(FlowKeys, exactly_one_is_given) {
    const auto faults = [](const std::vector<std::string>& overrides) -> std::string {
        try {
            read_case(channel, overrides);
        } catch (const CaseError& error) {
            return error.what();
        }
        return "none";
    };
    // One override takes the place of the file's key, two do not go together.
    EXPECT_EQ(faults({"flow.wall_stress=1 Pa"}), "none");
    EXPECT_NE(faults({"flow.wall_stress=1 Pa", "flow.flow_rate=1 mm^2/s"})
                  .find("flow_rate and wall_stress are both given"),
              std::string::npos);
    EXPECT_NE(faults({"flow.mean_velocity=0 mm/s"}).find("1e-6 to 1000000 /s are possible"),
              std::string::npos);
    EXPECT_NE(faults({"flow.wall_stress=1e6 Pa"}).find("write wall_stress = \""),
              std::string::npos);
    EXPECT_NE(faults({"flow.hold=mean-velocity", "flow.wall_stress=1 Pa"}).find("what to hold"),
              std::string::npos);
    EXPECT_EQ(faults({"flow.hold=mean-velocity", "flow.mean_velocity=-1 mm/s"}), "none");
}

RunMeasures after(const Case& c, int steps) {
    const Choice choice = choose(c);
    const Model model = discretise(c, choice);
    State state = initial_state(c, model);
    Periodic exchange;
    with_team(1, [&] {
        for (int n = 0; n < steps; ++n) advance(model, state, exchange);
    });
    return measure_run(model, state, measure_cells(model, state));
}

/// The mirror image of the flow to the right, of one cell in the middle.
TEST(FlowKeys, a_flow_to_the_left_mirrors_that_to_the_right) {
    for (const char* drive : {"pressure", "body-force"})
        for (const char* hold : {"pressure-drop", "mean-velocity"}) {
            const auto run = [&](const char* rate) {
                return after(
                    read_case(channel,
                              {std::string("flow.drive=") + drive, std::string("flow.hold=") + hold,
                               std::string("flow.pseudo_shear_rate=") + rate, "cells.layout=single",
                               "cells.count=1", "numerics.dx=1 um", "domain.length=40 um",
                               "numerics.node_spacing=0.5"}),
                    200);
            };
            const RunMeasures right = run("500 /s"), left = run("-500 /s");
            const std::string what = std::string(drive) + ", " + hold;
            EXPECT_GT(right.mean_velocity.si, 5e-3) << what;
            const double flow = right.mean_velocity.si;
            EXPECT_NEAR(left.mean_velocity.si, -flow, 1e-3 * flow) << what;
            EXPECT_NEAR(left.pressure_gradient.si, -right.pressure_gradient.si,
                        1e-3 * std::abs(right.pressure_gradient.si))
                << what;
            EXPECT_NEAR(left.mu_rel, right.mu_rel, 1e-3 * right.mu_rel) << what;
            EXPECT_NEAR(left.hematocrit_discharge, right.hematocrit_discharge, 2e-3) << what;
            EXPECT_NEAR(left.lambda_C, right.lambda_C, 1e-4) << what;
        }
}

TEST(FlowKeys, what_is_judged_does_not_depend_on_the_direction) {
    const auto judged = [](const char* rate) {
        const Case c = read_case(channel, {std::string("flow.pseudo_shear_rate=") + rate});
        const Choice choice = choose(c);
        const Model model = discretise(c, choice);
        return appraise(c, choice, model, initial_state(c, model));
    };
    const Appraisal right = judged("500 /s"), left = judged("-500 /s");
    EXPECT_EQ(left.shear_number, right.shear_number);
    EXPECT_EQ(left.steps, right.steps);
    EXPECT_EQ(left.transits, right.transits);
    EXPECT_EQ(left.channel_reynolds, right.channel_reynolds);
    EXPECT_EQ(left.advice.size(), right.advice.size());
}

TEST(FlowKeys, several_cells_that_do_not_harden_are_told_where_they_broke) {
    const auto told = [](std::vector<std::string> set) {
        set.insert(set.end(), {"numerics.dx=0.5 um", "domain.length=40 um"});
        const Case c = read_case(channel, set);
        const Choice choice = choose(c);
        const Model model = discretise(c, choice);
        for (const Advice& advice : appraise(c, choice, model, initial_state(c, model)).advice)
            if (advice.text.find("several cells whose tension") != std::string::npos) return true;
        return false;
    };
    const std::string soft = "membrane.hardening.apply_to=[]", few = "cells.count=4";
    EXPECT_TRUE(told({soft, few, "flow.pseudo_shear_rate=1200 /s"}));
    EXPECT_FALSE(told({soft, few, "flow.pseudo_shear_rate=500 /s"}));
    EXPECT_FALSE(told({few, "flow.pseudo_shear_rate=1200 /s"}));
}

TEST(FlowKeys, flows_that_no_run_survives_are_refused_with_one_that_it_does) {
    const auto told = [](std::vector<std::string> set) {
        return faults_of([&] { read_case(channel, set); });
    };
    const auto follows = [&](std::vector<std::string> set, const std::string& advice,
                             const std::string& cure) {
        const std::string all = told(set);
        EXPECT_NE(all.find(advice), std::string::npos) << all;
        set.push_back(cure);
        EXPECT_EQ(told(set), "");
    };
    follows({"flow.pseudo_shear_rate=2e5 /s", "membrane.hardening.apply_to=[]"},
            "at most 2 is possible", "flow.pseudo_shear_rate=500 /s");
    const std::string in_shear = faults_of([&] {
        read_case(TT_SOURCE_DIR "/cases/03-cell-in-shear/case.toml",
                  {"flow.shear_rate=2e5 /s", "membrane.hardening.apply_to=[]"});
    });
    EXPECT_NE(in_shear.find("at most 3 is possible"), std::string::npos) << in_shear;
    follows({"membrane.law=surface-tension"}, "write apply_to = []",
            "membrane.hardening.apply_to=[]");
    follows({"flow.pseudo_shear_rate=1e5 /s", "plasma.viscosity=0.01 cP"}, "turbulent",
            "flow.pseudo_shear_rate=500 /s");
    follows({"flow.pseudo_shear_rate=2000 /s", "numerics.density_scale=10000"},
            "write density_scale = ", "numerics.density_scale=100");
}

}  // namespace
}  // namespace tt
