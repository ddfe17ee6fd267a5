#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "command.hpp"
#include "io/checksum.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "membrane/outline.hpp"
#include "outline_text.hpp"
#include "temporary_directory.hpp"

using namespace tt;

namespace {

/// Two halves that a neck of this half width joins, with a kink in the middle.
std::string neck(double half, double kink) {
    return text_of({{-4, -3},
                    {0, -3},
                    {4, -3},
                    {4, -1},
                    {half, -1},
                    {half, -0.1},
                    {half + kink, 0},
                    {half, 0.1},
                    {half, 1},
                    {4, 1},
                    {4, 3},
                    {-4, 3},
                    {-4, 1},
                    {-half, 1},
                    {-half, 0.1},
                    {-half + kink, 0},
                    {-half, -0.1},
                    {-half, -1},
                    {-4, -1}});
}

class ShapeFile : public TemporaryDirectory {
protected:
    /// A case with this outline in a box of 20 by 20 um.
    std::string case_with(const std::string& outline, const std::string& more = "") const {
        std::ofstream(path("o.csv")) << outline;
        std::ofstream(path("c.toml"))
            << "format = 1\n[domain]\nlength = \"20 um\"\nwidth = \"20 um\"\n[flow]\n"
               "drive = \"shear\"\nshear_rate = \"100 /s\"\n[cells]\nshape = \"file\"\n"
               "file = \"o.csv\"\n"
            << more << "[numerics]\ndx = \"0.2 um\"\n[time]\nend = \"1 ms\"\n";
        return path("c.toml").string();
    }
    State start(const std::string& outline, const std::string& more = "") const {
        const Case c = read_case(case_with(outline, more));
        return initial_state(c, discretise(c));
    }
    Outcome check(const std::string& outline, const std::string& more = "",
                  const std::vector<std::string>& words = {}) const {
        std::vector<std::string> all{"check", case_with(outline, more)};
        all.insert(all.end(), words.begin(), words.end());
        return run(all);
    }
};

TEST_F(ShapeFile, stands_with_its_centroid_where_the_cell_is_put) {
    std::string half_disc, rectangle = "0,0\n8,0\n";
    for (int k = 0; k <= 40; ++k)  // dense along the arc, the straight side by its ends alone
        half_disc += fmt::format("{},{}\n", 5.0 * std::sin(std::numbers::pi * k / 40),
                                 -4.0 * std::cos(std::numbers::pi * k / 40));
    for (int k = 1; k <= 39; ++k) rectangle += fmt::format("8,{}\n", 0.1 * k);
    rectangle += "8,4\n0,4\n0,2\n0,1\n0,0.5\n";
    for (const std::string& outline : {text_of(repeated(ellipse_60)), half_disc, rectangle}) {
        const State state = start(outline, "angle = \"30 deg\"\n");
        const Vec2 centroid = area_moments(tt::outline(state.cells, 0)).centroid;
        EXPECT_NEAR(centroid.x, 50.0, 1e-9);
        EXPECT_NEAR(centroid.y, 50.0, 1e-9);
    }
}

TEST_F(ShapeFile, is_the_size_of_the_cells_and_radius_is_not) {
    const std::string text = text_of(ellipse(6.0, 4.0, 200));
    const Case own = read_case(case_with(text));
    const Case other = read_case(case_with(text, "radius = \"8 um\"\n"));
    const double radius =
        std::sqrt(24e-12) * std::sqrt(area_of(ellipse(6.0, 4.0, 200)) / (24.0 * std::numbers::pi));
    EXPECT_NEAR(equivalent_radius(own).si, radius, 1e-15);
    EXPECT_EQ(equivalent_radius(other).si, equivalent_radius(own).si);
    EXPECT_EQ(choose(other).dt.si, choose(own).dt.si);
    const Json judged = Json::parse(check(text, "radius = \"8 um\"\n", {"--json"}).out);
    EXPECT_NEAR(judged["shear_number"].get<double>(), 1.2e-3 * 100.0 * radius / 6e-6, 1e-9);
    EXPECT_NEAR(judged["outline"]["area_m2"].get<double>(), std::numbers::pi * radius * radius,
                1e-20);
    EXPECT_NE(judged["advice"].dump().find("radius = 8 um in [cells] is not used"),
              std::string::npos);
}

TEST_F(ShapeFile, that_is_no_cell_is_refused_by_check) {
    const auto refused = [&](const std::string& outline, const std::string& cause) {
        const Outcome outcome = check(outline);
        EXPECT_EQ(outcome.code, 2) << outcome.out;
        EXPECT_NE(outcome.err.find(cause), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.err.find("overlap"), std::string::npos) << outcome.err;
        return outcome.err;
    };
    refused(text_of(ellipse_60) + text_of(ellipse_60), "o.csv:61:1: the outline is written twice");
    refused(text_of(ellipse(0.04, 0.03, 60)), "smaller than any cell and than dx = 0.2 um");
    refused(text_of(ellipse(50.0, 30.0, 60)), "100 um by 60 um, longer than the box");
    const std::string told = refused(text_of(ellipse(11.0, 3.0, 60)), "it does not fit");
    EXPECT_NE(told.find("tanktread: 1 fault;"), std::string::npos) << told;
    refused("0,0\n1e8,0\n1e8,1\n1e8,2\n1e8,3\n5,3\n4,3\n0,3\n", "longer than the box");
    refused(neck(0.01, 0.29), "thinner than the grid");
    refused(neck(0.005, 0.0), "touches itself near");
    const Outcome narrow = check(neck(0.06, 0.0), "", {"--json"});
    EXPECT_EQ(narrow.code, 0) << narrow.err;
    EXPECT_NE(narrow.out.find("less than a site apart"), std::string::npos);
    EXPECT_EQ(check(neck(0.3, 0.0), "", {"--json"}).out.find("less than a site apart"),
              std::string::npos);
    const Outcome missing =
        run({"check", case_with(text_of(ellipse_60)), "--set", "cells.file=none.csv"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_NE(missing.err.find("none.csv"), std::string::npos);
}

TEST_F(ShapeFile, is_told_by_check_and_in_the_log_of_the_run) {
    const std::string told = "60 points, counter-clockwise in the file; 6 x 4 um";
    EXPECT_NE(check(text_of(ellipse_60)).out.find("o.csv: 60 points"), std::string::npos);
    const Outcome outcome = run({"run", case_with(text_of(ellipse_60)), "--set", "time.end=2 us",
                                 "-o", path("results").string(), "--progress", "none"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::ifstream log(path("results/run.log"));
    const std::string lines{std::istreambuf_iterator<char>(log), {}};
    EXPECT_NE(lines.find(told), std::string::npos) << lines;
}

TEST_F(ShapeFile, is_kept_in_the_results_which_stand_alone) {
    const std::vector<Vec2> shape = ellipse(3.0, 2.0, 60);
    const std::string given = case_with(text_of(shape));
    const std::string whole = path("whole").string(), parts = path("parts").string();
    const std::vector<std::string> quiet{"--progress", "none", "--set", "time.end=0.1 ms"};
    const auto with = [&](std::vector<std::string> words) {
        words.insert(words.end(), quiet.begin(), quiet.begin() + (words[0] == "run" ? 4 : 2));
        return run(words);
    };
    ASSERT_EQ(with({"run", given, "-o", whole}).code, 0);
    ASSERT_EQ(with({"run", given, "-o", parts, "--until", "0.05 ms"}).code, 75);
    const Json provenance = read_json(path("parts/PROVENANCE.json"));
    ASSERT_EQ(provenance["inputs"].size(), 1u);
    EXPECT_EQ(provenance["inputs"][0]["file"], "inputs/o.csv");
    EXPECT_EQ(provenance["inputs"][0]["hash"], hexadecimal(checksum(text_of(shape))));
    EXPECT_EQ(read_file(path("parts/inputs/o.csv")), text_of(shape));

    // The same command, and other content at the same place.
    std::ofstream(path("o.csv")) << text_of(ellipse(3.0, 2.1, 60));
    EXPECT_EQ(with({"run", given, "-o", parts}).code, 4);
    // The content of before, elsewhere, is the same case.
    case_with(text_of(shape));
    std::filesystem::rename(path("o.csv"), path("renamed.csv"));
    EXPECT_EQ(with({"run", given, "--set", "cells.file=renamed.csv", "-o", whole}).code, 0);

    std::filesystem::remove(path("renamed.csv"));
    std::filesystem::remove(path("c.toml"));
    std::filesystem::create_directory(path("far"));
    std::filesystem::rename(parts, path("far/moved"));
    const std::string moved = path("far/moved").string();
    const Outcome resumed = with({"resume", moved});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    for (const char* name : {"series.csv", "cells.csv", "resolved.toml"})
        EXPECT_EQ(read_file(path(std::string("far/moved/") + name)),
                  read_file(path(std::string("whole/") + name)))
            << name;

    std::ofstream(path("whole/inputs/o.csv")) << text_of(ellipse(3.0, 2.1, 60));
    EXPECT_EQ(with({"resume", whole}).code, 4);
}

}  // namespace
