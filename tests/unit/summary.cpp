#include "observe/summary.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "io/csv.hpp"
#include "io/file.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

class Summary : public TemporaryDirectory {
protected:
    bool tumbles = false;  ///< the second cell
    bool first_tumbles = false;
    bool one_way = true;
    double shear_rate = 10.0;

    /// Two cells, one in each half of a channel, at times 0 … 4 s: λ = 1 + t/10 ± 0.05; phase rates
    /// −2 and −4 /s; inclinations ±(20° + t); μ_rel = t.
    void write_tables() {
        std::string series = csv_header<RunMeasures>();
        std::string cells = csv_header<CellMeasures>();
        for (int t = 0; t <= 4; ++t) {
            RunMeasures run;
            run.time = Time{static_cast<double>(t)};
            run.mu_rel = t;
            run.mu_app = Viscosity{t == 3 ? std::nan("") : 2e-3};
            series += csv_row(run);
            for (int c = 0; c < 2; ++c) {
                CellMeasures cell;
                cell.time = run.time;
                cell.cell = c;
                cell.lambda_C = 1.0 + 0.1 * t + (c == 0 ? -0.05 : 0.05);
                cell.phase_rate = Rate{c == 0 ? -2.0 : -4.0};
                cell.x = Length{2.0 * t};
                cell.y = Length{c == 0 ? 1.0 : 3.0 + 0.2 * t};
                const double turning = 20.0 - 60.0 * t;
                cell.inclination_deg = c == 0    ? first_tumbles ? turning : 20.0 + t
                                       : tumbles ? turning
                                                 : -20.0 - t;
                cells += csv_row(cell);
            }
        }
        replace_file(path("series.csv"), series, Durability::process);
        replace_file(path("cells.csv"), cells, Durability::process);
    }
    Json summary() {
        write_tables();
        SummaryInput input;
        input.window = {Time{2.0}, Time{4.0}};
        input.mirror_height = Length{2.0};
        input.shear_rate = Rate{shear_rate};
        input.dx = Length{0.1};
        input.one_way = one_way;
        input.session.steps = 1000;
        input.session.wall_seconds = 1.0;
        input.session.pass_seconds.fill(0.1);
        return summarise(directory(), input);
    }
};

TEST_F(Summary, averages_over_the_window_and_tells_scatter_in_time_from_scatter_over_cells) {
    const Json lambda = summary()["lambda_C"];
    EXPECT_NEAR(lambda["mean"].get<double>(), 1.3, 1e-12);
    EXPECT_NEAR(lambda["sd_time"].get<double>(), 0.1, 1e-12);
    EXPECT_NEAR(lambda["sd_cells"].get<double>(), std::sqrt(2.0) * 0.05, 1e-12);
    EXPECT_NEAR(lambda["max"].get<double>(), 1.45, 1e-12);
    EXPECT_EQ(lambda["window"], Json::array({2.0, 4.0}));
    EXPECT_EQ(lambda["unit"], "");
}

TEST_F(Summary, the_tank_treading_period_is_that_of_the_mean_rate_of_each_cell) {
    const Json period = summary()["tank_treading_kT"];
    const double pi = std::numbers::pi;
    EXPECT_NEAR(period["mean"].get<double>(), 0.5 * (10.0 * 2 * pi / 2 + 10.0 * 2 * pi / 4), 1e-12);
}

TEST_F(Summary, a_cell_that_tumbles_or_hardly_turns_has_no_period) {
    const double pi = std::numbers::pi;
    tumbles = true;
    EXPECT_NEAR(summary()["tank_treading_kT"]["mean"].get<double>(), 10.0 * 2 * pi / 2, 1e-12);
    EXPECT_EQ(summary()["tank_treading_kT"]["samples"], 1);
    write_tables();
    SummaryInput input;
    input.window = {Time{4.0 - 1e-3}, Time{4.0}};  // 4 /s for a ms: a thousandth of a turn
    input.shear_rate = Rate{10.0};
    const Json period = summarise(directory(), input)["tank_treading_kT"];
    EXPECT_TRUE(period["value"].is_null());
    EXPECT_TRUE(period["mean"].is_null());
    EXPECT_EQ(period["reason"],
              "no cell turned its membrane by a fiftieth of a turn at an inclination that it kept");
}

TEST_F(Summary, the_halves_of_a_channel_are_mirrored_so_that_their_inclinations_do_not_cancel) {
    EXPECT_NEAR(summary()["inclination_deg"]["mean"].get<double>(), 23.0, 1e-12);
    EXPECT_NEAR(summary()["inclination_deg"]["sd_cells"].get<double>(), 0.0, 1e-12);
}

TEST_F(Summary, cells_that_tumble_have_no_mean_inclination) {
    tumbles = first_tumbles = true;
    const Json all = summary()["inclination_deg"];
    EXPECT_TRUE(all["value"].is_null());
    EXPECT_NE(all["reason"].get<std::string>().find("goes all round"), std::string::npos);
}

TEST_F(Summary, the_lateral_displacement_is_the_way_across_per_way_along) {
    const Json climb = summary()["lateral_displacement"];
    EXPECT_NEAR(climb["mean"].get<double>(), 0.05, 1e-12);  // 0 and 0.1
    EXPECT_EQ(climb["samples"], 2);
    one_way = false;
    EXPECT_TRUE(summary()["lateral_displacement"]["value"].is_null());
}

TEST_F(Summary, every_entry_has_a_value_with_its_unit_or_a_reason_why_there_is_none) {
    const Json all = summary();
    for (const auto& [name, entry] : all.items()) {
        if (name == "checks") continue;
        ASSERT_TRUE(entry.contains("value") && entry.contains("unit")) << name;
        EXPECT_EQ(entry["value"].is_null(), entry.contains("reason")) << name << entry;
        if (entry.contains("mean")) {
            EXPECT_EQ(entry["mean"], entry["value"]) << name;
            EXPECT_TRUE(entry.contains("standard_error")) << name;
        }
    }
    EXPECT_EQ(all["wall_seconds"]["unit"], "s");
    EXPECT_TRUE(all["checks"].is_array());
}

TEST_F(Summary, the_standard_error_is_that_of_ten_batches_of_the_looks) {
    std::string series = csv_header<RunMeasures>();
    for (int t = 0; t < 40; ++t) {
        RunMeasures run;
        run.time = Time{static_cast<double>(t)};
        run.mu_rel = t % 8 < 4 ? 1.0 : 2.0;  // batches of four looks: 1, 2, 1, 2, …
        series += csv_row(run);
    }
    replace_file(path("series.csv"), series, Durability::process);
    replace_file(path("cells.csv"), csv_header<CellMeasures>(), Durability::process);
    SummaryInput input;
    input.window = {Time{0.0}, Time{39.0}};
    const Json viscosity = summarise(directory(), input)["mu_rel"];
    EXPECT_NEAR(viscosity["standard_error"].get<double>(), std::sqrt(2.5 / 9.0 / 10.0), 1e-12);
    EXPECT_EQ(viscosity["samples"], 40);
}

TEST_F(Summary, a_measure_that_is_undefined_at_a_look_is_left_out_there) {
    const Json viscosity = summary()["mu_app"];
    EXPECT_NEAR(viscosity["mean"].get<double>(), 2e-3, 1e-15);
    EXPECT_EQ(viscosity["unit"], "Pa s");
    EXPECT_TRUE(viscosity["sd_cells"].is_null());
    EXPECT_NEAR(summary()["mu_rel"]["mean"].get<double>(), 3.0, 1e-12);
}

TEST_F(Summary, splits_the_time_of_a_step_over_its_passes_and_what_is_outside_of_them) {
    const Json step = summary()["step_us"];
    EXPECT_NEAR(step["value"].get<double>(), 1000.0, 1e-9);
    const Json split = step["passes"];
    for (const char* pass : StepTimes::names) EXPECT_NEAR(split[pass].get<double>(), 100.0, 1e-9);
    EXPECT_NEAR(split["outside"].get<double>(), 1000.0 - 100.0 * StepTimes::names.size(), 1e-9);
}

}  // namespace
}  // namespace tt
