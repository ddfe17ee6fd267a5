#include "observe/checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "io/file.hpp"
#include "observe/measures.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

using Verdict = RunCheck::Verdict;

/// Forty rows, a second apart, of a run in which all is well; `change` spoils it.
template <class Change>
std::string rows(Change change) {
    std::string text = csv_header<RunMeasures>();
    for (int t = 0; t < 40; ++t) {
        RunMeasures m;
        m.time = Time{static_cast<double>(t)};
        m.lambda_C = 1.1;
        m.strain = 0.1;
        m.taylor_inertia = 0.3;
        m.mean_velocity = Velocity{0.01};
        m.pseudo_shear_rate = Rate{500.0};
        m.cfl_envelope = Length{2e-6};
        m.mach = 0.1;
        m.smallest_gap = Length{4e-7};
        m.turn_max_deg = 20.0;
        m.curvature_radius_sites = 3.0;
        change(m, t);
        text += csv_row(m);
    }
    return text;
}

class Checks : public TemporaryDirectory {
protected:
    CheckInput input{Length{2e-7}, true, {Time{20.0}, Time{39.0}}, true, Rate{500.0}};

    template <class Change>
    std::map<std::string, RunCheck> judged(Change change) {
        replace_file(path("series.csv"), rows(change), Durability::process);
        std::map<std::string, RunCheck> by_name;
        for (const RunCheck& check : judge(read_csv(path("series.csv")), input))
            by_name[check.name] = check;
        return by_name;
    }
    /// The one check that is not in order after `change`.
    template <class Change>
    RunCheck spoilt(Change change) {
        RunCheck found;
        for (const auto& [name, check] : judged(change)) {
            if (check.verdict == Verdict::ok) continue;
            EXPECT_EQ(found.name, "") << name;
            found = check;
        }
        return found;
    }
};

TEST_F(Checks, a_run_in_order_has_all_of_them_and_none_is_raised) {
    const auto checks = judged([](RunMeasures&, int) {});
    for (const char* name : {"overlap", "gap", "repulsion", "area", "mach", "resolution", "speed",
                             "window", "standard_error"}) {
        ASSERT_TRUE(checks.contains(name)) << name;
        EXPECT_EQ(checks.at(name).verdict, Verdict::ok) << checks.at(name).sentence;
    }
    EXPECT_EQ(checks.size(), 9u);
}

TEST_F(Checks, each_is_raised_by_what_it_watches_alone) {
    const auto is = [&](const char* name, Verdict verdict, double value, auto change) {
        const RunCheck check = spoilt(change);
        EXPECT_EQ(check.name, name);
        EXPECT_EQ(check.verdict, verdict) << name;
        EXPECT_NEAR(check.value, value, 1e-9 * std::abs(value)) << name;
    };
    using M = RunMeasures;
    is("overlap", Verdict::failed, 3, [](M& m, int t) { m.overlaps = t == 7 ? 3 : 0; });
    is("gap", Verdict::warning, 1e-7, [](M& m, int t) { m.smallest_gap.si = t == 7 ? 1e-7 : 1; });
    EXPECT_NE(spoilt([](M& m, int) { m.smallest_gap.si = 1e-7; }).sentence.find(" in 100 % of"),
              std::string::npos);
    is("repulsion", Verdict::warning, 9, [](M& m, int) { m.repulsion_count = 9; });
    is("area", Verdict::warning, 2e-3, [](M& m, int) { m.area_error_max = 2e-3; });
    is("area", Verdict::failed, 2e-2, [](M& m, int) { m.area_error_max = 2e-2; });
    is("mach", Verdict::warning, 0.16, [](M& m, int) { m.mach = 0.16; });
    EXPECT_NE(spoilt([](RunMeasures& m, int) { m.mach = 0.33; }).sentence.find("by about 11 %"),
              std::string::npos);
    is("mach", Verdict::failed, 0.31, [](M& m, int) { m.mach = 0.31; });
    is("resolution", Verdict::warning, 61, [](M& m, int t) { m.turn_max_deg = t == 7 ? 61 : 9; });
    is("resolution", Verdict::failed, 144, [](M& m, int t) { m.turn_max_deg = t == 7 ? 144 : 9; });
    is("resolution", Verdict::warning, 20, [](M& m, int) { m.curvature_radius_sites = 0.9; });
    is("resolution", Verdict::failed, 20, [](M& m, int) { m.curvature_radius_sites = 0.4; });
    is("speed", Verdict::warning, 0.02, [](M& m, int) { m.pseudo_shear_rate.si = 490; });
}

TEST_F(Checks, the_mach_number_of_autos_own_step_is_in_order) {
    for (const double mach : {0.10011, 0.12})
        EXPECT_EQ(judged([=](RunMeasures& m, int) { m.mach = mach; })["mach"].verdict, Verdict::ok);
}

TEST_F(Checks, a_flow_to_the_left_is_held_as_one_to_the_right) {
    input.held_rate = Rate{-500.0};
    const auto leftward = [](double rate) {
        return [=](RunMeasures& m, int) { m.pseudo_shear_rate.si = rate; };
    };
    EXPECT_EQ(judged(leftward(-500.0))["speed"].verdict, Verdict::ok);
    EXPECT_EQ(judged(leftward(-490.0))["speed"].verdict, Verdict::warning);
}

TEST_F(Checks, a_flow_that_no_controller_holds_must_be_steady) {
    input.held_rate = Rate{0.0};
    EXPECT_EQ(judged([](RunMeasures& m, int) { m.pseudo_shear_rate.si = 300; })["speed"].verdict,
              Verdict::ok);
    const RunCheck check =
        spoilt([](RunMeasures& m, int t) { m.mean_velocity.si = t < 30 ? 1 : 1.2; });
    EXPECT_EQ(check.name, "speed");
    EXPECT_NEAR(check.value, 0.2 / 1.1, 1e-9);
}

TEST_F(Checks, a_window_of_a_drift_is_too_short_and_says_of_what) {
    const RunCheck check = spoilt([](RunMeasures& m, int t) { m.strain = 0.1 + 0.01 * t; });
    EXPECT_EQ(check.name, "window");
    EXPECT_LT(check.value, 10.0);
    EXPECT_NE(check.sentence.find("strain"), std::string::npos);
}

TEST_F(Checks, fewer_than_twenty_rows_give_no_standard_error) {
    input.window.from = Time{30.0};
    const RunCheck check = spoilt([](RunMeasures&, int) {});
    EXPECT_EQ(check.name, "standard_error");
    EXPECT_EQ(check.value, 10.0);
    const auto drifting = judged([](RunMeasures& m, int t) { m.strain = 0.1 + 0.01 * t; });
    EXPECT_FALSE(drifting.contains("window")) << "nothing can be said of it";
}

TEST_F(Checks, a_run_without_cells_is_not_judged_by_them) {
    const auto checks = judged([](RunMeasures& m, int) { m.lambda_C = std::nan(""); });
    EXPECT_FALSE(checks.contains("overlap"));
    EXPECT_FALSE(checks.contains("gap"));
    EXPECT_TRUE(checks.contains("mach"));
}

TEST_F(Checks, what_the_summary_says_is_what_is_read_back_else_the_rows_are_judged) {
    const auto judged_now = judged([](RunMeasures& m, int) { m.overlaps = 2; });
    write_json(path("status.json"), {{"dx", 2e-7}}, Durability::process);
    const std::vector<RunCheck> so_far = read_checks(directory());
    EXPECT_EQ(so_far.size(), 6u) << "nothing of the averaging window";
    for (const RunCheck& check : so_far)
        EXPECT_EQ(check.sentence, judged_now.at(check.name).sentence);
    std::vector<RunCheck> told{so_far.front()};
    told.front().sentence = "in these words";
    write_json(path("summary.json"), {{"checks", to_json(told)}}, Durability::process);
    ASSERT_EQ(read_checks(directory()).size(), 1u);
    EXPECT_EQ(read_checks(directory()).front().sentence, "in these words");
    EXPECT_EQ(read_checks(directory()).front().verdict, Verdict::failed);
    EXPECT_EQ(to_json(read_checks(directory())), to_json(told));
}

TEST_F(Checks, the_last_line_of_a_run_that_is_not_resolved_says_so) {
    replace_file(path("series.csv"), rows([](RunMeasures& m, int) {
                     m.turn_max_deg = 144.0;
                     m.curvature_radius_sites = 0.176;
                     m.overlaps = 2;
                 }),
                 Durability::process);
    const std::string text = describe_checks(judge(read_csv(path("series.csv")), input));
    EXPECT_TRUE(
        text.ends_with("\nFAILED: Membranes not resolved (turn 144°, radius 0.18 sites): "
                       "refine dx.\n"))
        << text;
    EXPECT_EQ(describe_checks(judge(read_csv(path("series.csv")), {})).find("checks: all"),
              std::string::npos);
    EXPECT_EQ(describe_checks({}), "");
}

}  // namespace
}  // namespace tt
