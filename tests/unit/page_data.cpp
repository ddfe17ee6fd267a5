#include "report/page_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "report/html.hpp"
#include "report/key_numbers.hpp"
#include "report/node_stretch.hpp"
#include "report/page_cells.hpp"
#include "unit/invented_results.hpp"

namespace tt {
namespace {

TEST(PageData, long_runs_are_thinned_and_positions_survive_rounding) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 9 --rows 300");
    const Results run = read_results(scratch / "run");
    PageLimits limits;
    limits.rows = 50;
    limits.frames = 4;
    limits.nodes_per_cell = 10;
    const Json player = player_data(run, limits);
    EXPECT_EQ(player["times"].size(), 4u) << "every third, and the last";
    EXPECT_DOUBLE_EQ(player["times"].back(), 80e-3);
    EXPECT_EQ(player["recorded"], 9);
    EXPECT_EQ(player["first"].back(), 40);
    EXPECT_EQ(player["nodes"].get<std::string>().size(), (4u * 40 * 4 + 2) / 3 * 4);
    EXPECT_EQ(player["stretch"]["bytes"].get<std::string>().size(), (4u * 40 + 2) / 3 * 4);
    EXPECT_LT(player["quantum"].get<double>(), 5e-9);
    EXPECT_EQ(player["flow"]["drive"], "channel");
    const Json series = series_data(run, limits);
    EXPECT_LE(series[0]["values"].size(), 51u);
    EXPECT_DOUBLE_EQ(series[0]["values"].back(), 80e-3);
}

TEST(PageData, cells_are_told_at_every_frame_and_between_as_often_as_fits) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 9 --rows 301");
    const Results run = read_results(scratch / "run");
    PageLimits limits;
    const Json all = cell_data(run, {10e-3, 50e-3}, limits);
    EXPECT_EQ(all["time"].size(), 301u);
    EXPECT_EQ(all["count"], 4);
    limits.cell_bytes = 20 * 4 * all["keys"].size() * sizeof(float);
    const Json few = cell_data(run, {10e-3, 50e-3}, limits);
    EXPECT_LE(few["time"].size(), 20u + 3);
    EXPECT_GE(few["time"].size(), 15u);
    for (const double frame : {10e-3, 50e-3, 80e-3}) {
        const auto& times = few["time"];
        EXPECT_TRUE(std::any_of(times.begin(), times.end(), [&](double t) {
            return std::abs(t - frame) <= 0.51 * 80e-3 / 300;
        })) << frame;
    }
    const std::size_t floats = few["time"].size() * 4 * few["keys"].size();
    EXPECT_EQ(few["values"].get<std::string>().size(), (4 * floats + 2) / 3 * 4);
}

TEST(PageData, stretch_is_of_the_membrane_between_the_nodes_that_are_embedded) {
    FramesHeader header;
    header.first = {0, 4};
    header.rest_length = {1.0, 1.0, 2.0, 1.0};
    Frame frame;
    frame.nodes = {0.0, 0.0, 1.5, 0.0, 3.0, 0.0, 3.0, 4.0};
    const auto all = chosen_stretches(header, frame, {0, 1, 2, 3}, {0, 4});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_DOUBLE_EQ(all[0], 1.5);
    EXPECT_DOUBLE_EQ(all[2], 2.0);
    EXPECT_DOUBLE_EQ(all[3], 5.0);
    const auto half = chosen_stretches(header, frame, {0, 2}, {0, 2});
    ASSERT_EQ(half.size(), 2u);
    EXPECT_DOUBLE_EQ(half[0], 1.5);
    EXPECT_DOUBLE_EQ(half[1], 3.0);
    header.rest_length.clear();
    EXPECT_TRUE(chosen_stretches(header, frame, {0, 1, 2, 3}, {0, 4}).empty());
}

TEST(PageData, tension_follows_the_law_and_the_hardening_of_the_case) {
    Results run;
    EXPECT_FALSE(membrane_law(run)) << "nothing is said of a membrane";
    run.settings = {{"membrane.law", "skalak"}, {"membrane.shear_modulus", "6 uN/m"}};
    EXPECT_NEAR(membrane_law(run)->tension(1.1), 6e-6 * 2.0 * 1.1 * 0.21, 1e-15) << "C is 1";
    run.settings["membrane.area_dilation_ratio"] = "10";
    EXPECT_NEAR(membrane_law(run)->tension(1.1), 6e-6 * 11.0 * 1.1 * 0.21, 1e-15);
    run.settings["membrane.law"] = "hookean";
    EXPECT_NEAR(membrane_law(run)->tension(1.1), 1.8e-6, 1e-15);
    run.settings.insert({{"membrane.hardening.apply_to", "bending, area"},
                         {"membrane.hardening.form", "exponential"},
                         {"membrane.hardening.compression", "symmetric"},
                         {"membrane.hardening.D", "0.5"},
                         {"membrane.hardening.beta", "10"}});
    EXPECT_NEAR(membrane_law(run)->tension(1.1), 1.8e-6, 1e-15) << "shear is not hardened";
    run.settings["membrane.hardening.apply_to"] = "bending, shear";
    const double alpha = 1.0 + 0.5 * (std::exp(1.0) - 1.0);
    EXPECT_NEAR(membrane_law(run)->tension(1.1), alpha * 1.8e-6, 1e-15);
    run.settings["membrane.hardening.form"] = "linear";
    EXPECT_FALSE(membrane_law(run)) << "a form this program does not know";
}

TEST(KeyNumbers, are_those_of_the_run_in_shear) {
    Results run;
    run.settings = {{"flow.drive", "shear"},           {"flow.shear_number", "0.2"},
                    {"plasma.density", "1025 kg/m^3"}, {"plasma.viscosity", "1.2 cP"},
                    {"domain.width", "40 um"},         {"membrane.shear_modulus", "6 uN/m"}};
    run.cells.names = {"area"};
    run.cells.columns = {{3.14159265358979 * 16e-12}};
    run.provenance["settings"] = {"chosen.density_scale = 20"};
    run.summary["shear_number"] = {{"value", 0.2}};
    const KeyNumbers n = key_numbers(run);
    EXPECT_NEAR(n.shear_rate, 250.0, 1e-9) << "k = G E_s / (mu a)";
    EXPECT_NEAR(n.cell_reynolds, 1025 * 250 * 16e-12 / 1.2e-3, 1e-9);
    EXPECT_NEAR(n.cell_reynolds_run, 20 * n.cell_reynolds, 1e-12);
    EXPECT_TRUE(std::isnan(n.mean_velocity)) << "there is no channel";
    const std::string text = key_numbers_section(std::array{run}, {"run"});
    EXPECT_NE(text.find(">shear number G<"), std::string::npos);
    EXPECT_EQ(text.find(">wall shear stress<"), std::string::npos) << "not known, not told";
    EXPECT_EQ(key_numbers_section(std::array{Results{}}, {"run"}), "");
}

TEST(Html, contents_list_links_to_every_heading) {
    const std::string page = heading("one", "First & last") + "<p>x</p>" + heading("two", "2");
    const std::string list = contents_list(page);
    EXPECT_NE(list.find("<li><a href=\"#one\">First &amp; last</a></li>"), std::string::npos);
    EXPECT_NE(list.find("<li><a href=\"#two\">2</a></li>"), std::string::npos);
    EXPECT_NE(page.find("<h2 id=\"two\">"), std::string::npos);
}

TEST(PageData, base64_is_that_of_rfc_4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace tt
