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
    /// Two cells at times 0 … 4 s: λ = 1 + t/10 ± 0.05; phase rates −2 and −4 /s; μ_rel = t.
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
                cells += csv_row(cell);
            }
        }
        replace_file(path("series.csv"), series, Durability::process);
        replace_file(path("cells.csv"), cells, Durability::process);
    }
    Json summary() {
        write_tables();
        SummaryInput input;
        input.average_from = Time{2.0};
        input.average_to = Time{4.0};
        input.shear_rate = Rate{10.0};
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

TEST_F(Summary, a_measure_that_is_undefined_at_a_look_is_left_out_there) {
    const Json viscosity = summary()["mu_app"];
    EXPECT_NEAR(viscosity["mean"].get<double>(), 2e-3, 1e-15);
    EXPECT_EQ(viscosity["unit"], "Pa s");
    EXPECT_TRUE(viscosity["sd_cells"].is_null());
    EXPECT_NEAR(summary()["mu_rel"]["mean"].get<double>(), 3.0, 1e-12);
}

TEST_F(Summary, splits_the_time_of_a_step_over_its_passes_and_what_is_outside_of_them) {
    const Json split = summary()["step_us"];
    for (const char* pass : StepTimes::names) EXPECT_NEAR(split[pass].get<double>(), 100.0, 1e-9);
    EXPECT_NEAR(split["outside"].get<double>(), 1000.0 - 100.0 * StepTimes::names.size(), 1e-9);
}

}  // namespace
}  // namespace tt
