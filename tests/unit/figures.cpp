#include "report/figures.hpp"
#include "report/frames.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "unit/invented_results.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

bool drew(const std::vector<Figure>& figures, const std::string& name) {
    for (const Figure& figure : figures)
        if (figure.name == name) return true;
    return false;
}

TEST(Figures, each_has_png_svg_data_and_script) {
    ScratchFolder scratch;
    invent_results(scratch / "run");
    const std::vector<Results> runs{read_results(scratch / "run")};
    const std::vector<Figure> figures = draw_figures(runs, scratch / "figures");
    for (const char* name :
         {"flow", "lambda_C", "deformation", "inclination", "mu_rel", "cell_free_layer",
          "area_error", "velocity_profile", "hematocrit_profile"})
        EXPECT_TRUE(drew(figures, name)) << name;
    for (const Figure& figure : figures) {
        const fs::path stem = scratch / "figures" / figure.name;
        EXPECT_EQ(text_of(stem.string() + ".png").substr(1, 3), "PNG") << figure.name;
        EXPECT_GT(fs::file_size(stem.string() + ".png"), 5000u) << figure.name;
        EXPECT_NE(text_of(stem.string() + ".svg").find("</svg>"), std::string::npos) << figure.name;
        EXPECT_GT(fs::file_size(stem.string() + ".gp"), 0u);
        const std::string data = figure.name == "flow" ? "flow_1_speed.dat" : figure.name + ".dat";
        EXPECT_GT(fs::file_size(scratch / "figures" / data), 100u) << figure.name;
        EXPECT_FALSE(figure.caption.empty());
    }
}

TEST(Figures, one_that_cannot_be_drawn_costs_no_other) {
    std::vector<Figure> drawn;
    add_figure(
        {"first", "", ""}, [] { throw IoError("gnuplot could not draw first.gp"); }, drawn);
    add_figure(
        {"second", "", ""}, [] {}, drawn);
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_EQ(drawn[0].fault, "gnuplot could not draw first.gp");
    EXPECT_EQ(drawn[1].fault, "");
}

TEST(Figures, of_a_run_with_one_number_at_its_end_are_drawn) {
    // 200.0063 us was beyond an axis that ended at 200.006.
    ScratchFolder scratch;
    LineFigure figure;
    figure.name = "late";
    figure.commands = {"set xrange [0:200.0063]"};
    figure.curves = {{"", "using 1:2 with points", {{0.0, 200.0063}, {std::nan(""), 1.0}}}};
    write_style(scratch / "");
    EXPECT_NO_THROW(draw(figure, scratch / ""));
}

TEST(Figures, several_runs_are_overlaid_with_their_names) {
    ScratchFolder scratch;
    invent_results(scratch / "first");
    invent_results(scratch / "second", "--lambda-C 1.3");
    const std::vector<Results> runs{read_results(scratch / "first"),
                                    read_results(scratch / "second")};
    const std::vector<Figure> figures = draw_figures(runs, scratch / "figures");
    EXPECT_TRUE(drew(figures, "lambda_C"));
    EXPECT_FALSE(drew(figures, "flow"));
    const std::string script = text_of(scratch / "figures" / "lambda_C.gp");
    EXPECT_NE(script.find("'channel-500-LD (first)'"), std::string::npos);
    EXPECT_NE(script.find("'channel-500-LD (second)'"), std::string::npos);
}

TEST(Figures, unfinished_run_gives_what_there_is) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--stage running --frames 5");
    const Results run = read_results(scratch / "run");
    EXPECT_FALSE(run.finished());
    EXPECT_EQ(run.series.rows(), 59u) << "the line cut short is left out";
    EXPECT_EQ(run.frames->count(), 4);
    const std::vector<Figure> figures = draw_figures({&run, 1}, scratch / "figures");
    EXPECT_TRUE(drew(figures, "flow"));
    EXPECT_TRUE(drew(figures, "lambda_C"));
    EXPECT_FALSE(drew(figures, "velocity_profile"));
}

TEST(Figures, run_that_just_started_has_no_figures) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--stage started");
    const Results run = read_results(scratch / "run");
    EXPECT_TRUE(draw_figures({&run, 1}, scratch / "figures").empty());
}

TEST(Results, directory_without_results_is_refused_by_name) {
    ScratchFolder scratch;
    fs::create_directory(scratch / "empty");
    fs::create_directory(scratch / "case");
    replace_file(scratch / "case/case.toml", "name = \"channel\"\n", Durability::process);
    for (const char* folder : {"empty", "case"}) {
        try {
            read_results(scratch / folder);
            FAIL();
        } catch (const IoError& error) {
            EXPECT_NE(std::string(error.what()).find("holds no results"), std::string::npos);
        }
    }
    EXPECT_THROW(read_results(scratch / "absent"), IoError);
}

TEST(Results, summary_window_and_settings_are_read) {
    ScratchFolder scratch;
    invent_results(scratch / "run");
    const Results run = read_results(scratch / "run");
    EXPECT_EQ(run.name, "channel-500-LD");
    EXPECT_EQ(run.setting("flow.drive"), "pressure");
    EXPECT_DOUBLE_EQ(setting_si(run.setting("domain.length")), 80e-6);
    EXPECT_DOUBLE_EQ(run.window_begin, 40e-3);
    EXPECT_DOUBLE_EQ(run.window_end, 80e-3);
    const double stretch = window_mean(run, "lambda_C");
    for (const SummaryLine& line : run.quantities)
        if (line.name == "lambda_C") {
            EXPECT_NEAR(line.mean, stretch, 1e-8);
        }
    EXPECT_TRUE(std::isnan(window_mean(run, "no such column")));
}

TEST(Results, all_figure_times_are_drawn_in_whatever_unit_they_are_given) {
    ScratchFolder scratch;
    invent_results(scratch / "run");  // nine frames in 80 ms
    Results run = read_results(scratch / "run");
    run.settings["output.figure_times"] = "0 ms, 0.02 s, 40000 us, 80 ms";
    EXPECT_EQ(chosen_frames(run), (std::vector<int>{0, 2, 4, 8}));
    EXPECT_DOUBLE_EQ(setting_si("6e-3 dyn/cm"), 6e-6);  // any unit of a case file
    EXPECT_TRUE(std::isnan(setting_si("developed")));
}

TEST(ReportFrames, wrapping_moves_a_whole_cell_into_the_box) {
    FramesHeader header;
    header.length = header.width = 10.0;
    header.first = {0, 3};
    Frame frame;
    frame.nodes = {25.0, 11.0, 27.0, 12.0, 26.0, 13.0};  // periodic both ways
    const std::vector<Vec2> nodes = wrapped_nodes(header, frame);
    EXPECT_EQ(nodes[0], (Vec2{5.0, 1.0}));
    EXPECT_EQ(nodes[1], (Vec2{7.0, 2.0}));
}

TEST(ReportFrames, nearest_frame_with_fields_in_time_is_found) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 9");
    const Results run = read_results(scratch / "run");
    EXPECT_EQ(nearest_field(*run.frames, 21e-3), 2);
    EXPECT_EQ(chosen_frames(run), (std::vector<int>{0, 2, 4, 8}));
}

}  // namespace
}  // namespace tt
