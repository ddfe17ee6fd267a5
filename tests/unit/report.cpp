#include "report/report.hpp"

#include <array>
#include <regex>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "report/export.hpp"
#include "report/page_data.hpp"
#include "report/words.hpp"
#include "small_run.hpp"
#include "unit/invented_results.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

bool asks_the_network(const std::string& page) {
    static const std::regex link("(src|href|url|action)\\s*[=(]\\s*[\"']?\\s*(https?:)?//",
                                 std::regex::icase);
    return std::regex_search(page, link) || page.find("fetch(") != std::string::npos ||
           page.find("XMLHttpRequest") != std::string::npos ||
           page.find("<link") != std::string::npos;
}

TEST(Report, page_of_one_run_is_whole_and_needs_no_network) {
    ScratchFolder scratch;
    invent_results(scratch / "run");
    const std::array<fs::path, 1> runs{scratch / "run"};
    const fs::path path = write_report(runs);
    EXPECT_EQ(path, scratch / "run" / "report.html");
    const std::string page = text_of(path);
    EXPECT_FALSE(asks_the_network(page));
    for (const char* part : {"<h1>channel-500-LD</h1>", "id=\"picture\"", "uPlot=function",
                             "resolved.toml", "data:image/svg+xml;base64,", "40 to 80 ms",
                             "pseudo-shear rate (mean velocity / width) of 500 /s"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(page.find("not finished"), std::string::npos);
    EXPECT_LT(page.size(), 1'500'000u);
    EXPECT_TRUE(asks_the_network("<img src=\"https://x\">")) << "the check itself can fail";
}

TEST(Report, comparison_has_runs_side_by_side_and_raises_overlaps) {
    ScratchFolder scratch;
    invent_results(scratch / "good");
    invent_results(scratch / "bad", "--overlaps 3");
    const std::array<fs::path, 2> runs{scratch / "good", scratch / "bad"};
    const std::string page = text_of(write_report(runs, scratch / "comparison"));
    EXPECT_NE(page.find("Comparison of channel-500-LD (good), channel-500-LD (bad)"),
              std::string::npos);
    EXPECT_NE(page.find("contact forces did not keep the cells apart"), std::string::npos);
    EXPECT_TRUE(fs::exists(scratch / "comparison" / "figures" / "lambda_C.svg"));
    EXPECT_FALSE(fs::exists(scratch / "good" / "report.html"));
}

TEST(Report, unfinished_runs_say_how_far_they_came) {
    ScratchFolder scratch;
    invent_results(scratch / "running", "--stage running");
    invent_results(scratch / "started", "--stage started");
    for (const char* name : {"running", "started"}) {
        const std::array<fs::path, 1> runs{scratch / name};
        EXPECT_NE(text_of(write_report(runs)).find("had reached 48 of 80 ms"), std::string::npos)
            << name;
    }
}

TEST(Report, missing_gnuplot_is_told_with_the_package_to_install) {
    ScratchFolder scratch;
    invent_results(scratch / "run");
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    const std::array<fs::path, 1> runs{scratch / "run"};
    std::string message;
    try {
        write_report(runs);
    } catch (const IoError& error) {
        message = error.what();
    }
    setenv("PATH", path.c_str(), 1);
    EXPECT_NE(message.find("apt install gnuplot-nox"), std::string::npos) << message;
}

TEST(Report, directory_that_a_run_wrote_is_understood) {
    ScratchFolder scratch;
    run_small(small_request(scratch / "run", 200));
    const Results run = read_results(scratch / "run");
    EXPECT_EQ(run.name, "small");
    EXPECT_TRUE(run.finished());
    EXPECT_EQ(unfinished_note(run), "");
    EXPECT_GT(run.window_end, run.window_begin);
    ASSERT_TRUE(run.frames);
    EXPECT_EQ(run.frames->count(), 9);

    const std::array<fs::path, 1> runs{scratch / "run"};
    const std::string page = text_of(write_report(runs));
    EXPECT_NE(page.find("cfl_profile"), std::string::npos);
    EXPECT_GE(run.checks.size(), 8u);
    for (const Check& check : run.checks)
        EXPECT_NE(page.find(check.sentence), std::string::npos) << check.name;
    for (const char* figure :
         {"flow", "lambda_C", "mu_rel", "velocity_profile", "hematocrit_profile"})
        EXPECT_TRUE(fs::exists(scratch / "run" / "figures" / (std::string(figure) + ".svg")))
            << figure;
    export_vtk(scratch / "run", scratch / "vtk");
    EXPECT_TRUE(fs::exists(scratch / "vtk" / "cells" / "cells_000008.vtp"));
}

TEST(PageData, long_runs_are_thinned_and_positions_survive_rounding) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 9 --rows 300");
    const Results run = read_results(scratch / "run");
    PageLimits limits;
    limits.rows = 50;
    limits.frames = 4;
    limits.nodes_per_cell = 10;
    const Json player = player_data(run, "run", limits);
    EXPECT_EQ(player["times"].size(), 3u);
    EXPECT_EQ(player["recorded"], 9);
    EXPECT_EQ(player["first"].back(), 40);
    EXPECT_EQ(player["nodes"].get<std::string>().size(), (3u * 40 * 4 + 2) / 3 * 4);
    EXPECT_LT(player["quantum"].get<double>(), 5e-9);
    const Json charts = chart_data(run, "run", limits);
    EXPECT_LE(charts["columns"][0]["values"].size(), 51u);
    EXPECT_DOUBLE_EQ(charts["columns"][0]["values"].back(), 80e-3);
}

TEST(PageData, base64_is_that_of_rfc_4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Words, numbers_are_written_as_people_write_them) {
    EXPECT_EQ(number_text(539800.0), "5.398 × 10⁵");
    EXPECT_EQ(number_text(-1.5e-7, 2), "−1.5 × 10⁻⁷");
    EXPECT_EQ(number_text(std::nan("")), "–");
    EXPECT_EQ(with_scatter(1.11428, 0.00742), "1.1143 ± 0.0074");
    EXPECT_EQ(with_scatter(3.997e-4, 8.6e-5), "(4.00 ± 0.86) × 10⁻⁴");
    EXPECT_EQ(with_scatter(-13.01, 2.5), "−13.0 ± 2.5");
    EXPECT_EQ(with_scatter(0.377, 5e-17), "0.377");
}

}  // namespace
}  // namespace tt
