#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "command.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "source_dir.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

const std::string plasma = TT_SOURCE_DIR "/cases/01-poiseuille/case.toml";

class Messages : public TemporaryDirectory {
protected:
    std::vector<std::string> small_run() const {
        return {"run", plasma, "-o", path("run").string(), "-j", "1", "--set", "time.end=10 us"};
    }
};

TEST_F(Messages, help_of_a_verb_may_be_asked_for_either_way) {
    EXPECT_EQ(run({"help", "run"}).out, run({"run", "--help"}).out);
    EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
    EXPECT_EQ(run({"help", "run", "and", "more"}).code, 0);
    EXPECT_EQ(run({"help", "rn"}).code, 2);
}

TEST_F(Messages, a_path_that_no_disk_can_hold_is_no_internal_error) {
    for (const char* verb : {"check", "run", "resume", "status", "report", "calibrate", "new"}) {
        const Outcome outcome = run({verb, std::string(5000, 'x')});
        EXPECT_EQ(outcome.code, 5) << verb;
        EXPECT_NE(outcome.err.find("File name too long"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(run({"run", plasma, "-o", std::string(300, 'x')}).code, 5);
    EXPECT_EQ(run({"run", plasma, "-o", ""}).code, 2);
    EXPECT_EQ(run({"new", ""}).code, 2);
    EXPECT_EQ(run({"check", "/dev/zero"}).code, 5);
}

TEST_F(Messages, letters_are_shown_whole) {
    const std::string error = run({"check", plasma, "--set", "domain.width=20 \xc3\xa4m"}).err;
    EXPECT_NE(error.find("'\xc3\xa4' is not expected in a unit"), std::string::npos) << error;
    EXPECT_NE(run({"\xc3\xa4"}).err.find("unknown verb '\xc3\xa4'"), std::string::npos);
    const std::string hostile = run({"check", plasma, "--set", "flow.drive=\x1b[31m"}).err;
    EXPECT_EQ(hostile.find('\x1b'), std::string::npos);
}

TEST_F(Messages, progress_as_json_is_nothing_else) {
    std::vector<std::string> words = small_run();
    words.insert(words.end(), {"--progress", "json"});
    for (int time = 0; time < 2; ++time) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 0);
        std::istringstream lines(outcome.err);
        int count = 0;
        for (std::string line; std::getline(lines, line); ++count)
            EXPECT_TRUE(Json::accept(line)) << line;
        if (time == 0) {
            EXPECT_GE(count, 2);
        }
        EXPECT_NE(outcome.err.find("\"checks\""), std::string::npos) << outcome.err;
    }
    words.insert(words.end(), {"--set", "domain.width=20 s"});
    const Outcome refused = run(words);
    EXPECT_EQ(refused.code, 2);
    std::istringstream lines(refused.err);
    for (std::string line; std::getline(lines, line);) EXPECT_TRUE(Json::accept(line)) << line;
}

TEST_F(Messages, a_value_of_set_may_be_quoted_whatever_its_letters) {
    for (const std::string value : {"20 \xc3\xa4m", "\"20 \xc3\xa4m\""})
        EXPECT_NE(run({"check", plasma, "--set", "domain.width=" + value})
                      .err.find("'\xc3\xa4' is not expected in a unit"),
                  std::string::npos)
            << value;
}

TEST_F(Messages, without_gnuplot_a_report_has_all_but_its_figures) {
    std::vector<std::string> words = small_run();
    words.insert(words.end(), {"--progress", "none"});
    ASSERT_EQ(run(words).code, 0);
    const std::string given = std::getenv("PATH");
    setenv("PATH", directory().c_str(), 1);
    const Outcome report = run({"report", path("run").string()});
    const Outcome png = run({"export", path("run").string(), "--to", "png"});
    setenv("PATH", given.c_str(), 1);
    EXPECT_EQ(report.code, 0) << report.err;
    EXPECT_NE(report.err.find("sudo apt install gnuplot-nox"), std::string::npos);
    const std::string page = read_file(path("run") / "report.html");
    EXPECT_NE(page.find("sudo apt install gnuplot-nox"), std::string::npos);
    EXPECT_NE(page.find("uPlot=function"), std::string::npos);
    EXPECT_EQ(page.find("<figure>"), std::string::npos);
    EXPECT_EQ(png.code, 5);
    EXPECT_NE(png.err.find("sudo apt install gnuplot-nox"), std::string::npos);
}

TEST_F(Messages, what_check_calls_unstable_does_not_start) {
    const Outcome outcome = run({"run", TT_SOURCE_DIR "/cases/04-cell-relaxing/case.toml", "-j",
                                 "1", "-o", path("stiff").string(), "--set", "numerics.dt=200 us"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("times too long to be stable: write dt = "), std::string::npos);
    EXPECT_FALSE(fs::exists(path("stiff") / "series.csv"));
}

TEST_F(Messages, numbers_far_from_those_of_the_field_are_told) {
    const std::string channel = TT_SOURCE_DIR "/cases/05-channel/case.toml";
    const auto told = [&](const std::vector<std::string>& settings) {
        std::vector<std::string> words{"check", channel, "-j", "1"};
        for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
        return run(words).out;
    };
    EXPECT_EQ(told({}).find("Unusual"), std::string::npos) << told({});
    const std::string fast = told({"flow.pseudo_shear_rate=5000 /s", "domain.width=200 um"});
    EXPECT_NE(fast.find("of the channel 170"), std::string::npos) << fast;
    EXPECT_EQ(fast.find("e+0"), std::string::npos) << fast;
    const std::vector<std::vector<std::string>> slips{{"membrane.shear_modulus=6 mN/m"},
                                                      {"membrane.bending_modulus=1.8e-16 J"},
                                                      {"plasma.viscosity=0.2 cP"},
                                                      {"cells.cytoplasm_viscosity=6 uPa s"},
                                                      {"flow.pseudo_shear_rate=0.05 /s"},
                                                      {"contact.decay=3.84 /nm"},
                                                      {"output.frames=5 us", "time.end=800 ms"}};
    for (const auto& slip : slips)
        EXPECT_NE(told(slip).find("Unusual: "), std::string::npos) << slip.front();
}

TEST_F(Messages, hours_are_told_before_and_at_the_start_of_a_run) {
    const std::string shear = TT_SOURCE_DIR "/cases/03-cell-in-shear/case.toml";
    const auto with_end = [&](std::vector<std::string> words, const std::string& end) {
        words.insert(words.end(), {shear, "-j", "1", "--set", "time.end=" + end});
        return run(words);
    };
    const std::string remark = "to the end at the speed measured";
    EXPECT_EQ(with_end({"check"}, "40 ms").out.find(remark), std::string::npos);
    EXPECT_NE(with_end({"check"}, "100000 s").out.find(remark), std::string::npos);
    const Outcome outcome =
        with_end({"run", "--max-time", "3s", "-o", path("long").string()}, "100000 s");
    EXPECT_EQ(outcome.code, 75);
    EXPECT_NE(outcome.err.find(remark), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace tt
