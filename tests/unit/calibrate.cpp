#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/calibration.hpp"
#include "command.hpp"
#include "base/error.hpp"
#include "case/targets.hpp"
#include "io/json.hpp"
#include "observe/summary.hpp"
#include "simulation/stop.hpp"
#include "source_dir.hpp"
#include "temporary_directory.hpp"

namespace {

namespace fs = std::filesystem;

using tt::Outcome;
using tt::run;

class Calibrate : public tt::TemporaryDirectory {
protected:
    const std::string shear_case = std::string(TT_SOURCE_DIR) + "/cases/03-cell-in-shear/case.toml";
    /// A cell of four sites in a narrow box, not yet steady: a fraction of a second a run.
    const std::vector<std::string> coarse{
        "numerics.dx=1 um",   "domain.length=20 um",
        "domain.width=20 um", "membrane.hardening.apply_to=[shear, bending, area]",
        "time.end=5 ms",      "time.average_from=4 ms"};

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name)) << text;
        return path(name).string();
    }
    static std::string list(const std::vector<std::string>& items) {
        std::string text;
        for (const std::string& item : items) text += (text.empty() ? "\"" : ", \"") + item + "\"";
        return "[" + text + "]";
    }
    /// λ_C of the program itself at a pair.
    double lambda_C(const std::string& shear_number, const std::string& D,
                    const std::string& beta) const {
        const fs::path out = path("truth-" + shear_number);
        std::vector<std::string> words{"run", shear_case, "-o",         out.string(),
                                       "-j",  "1",        "--progress", "none"};
        for (const std::string& item : coarse) words.insert(words.end(), {"--set", item});
        for (const std::string& item :
             {"flow.shear_number=" + shear_number, "membrane.hardening.D=" + D,
              "membrane.hardening.beta=" + beta})
            words.insert(words.end(), {"--set", item});
        EXPECT_EQ(run(words).code, 0);
        return tt::read_json(out / "summary.json").at("lambda_C").at("mean").get<double>();
    }
    std::string targets(double at_low, double at_high, const std::string& search = "") const {
        const auto target = [](double value, const char* shear_number) {
            return "[[target]]\nquantity = \"lambda_C\"\nuncertainty = 0.0003\nvalue = " +
                   std::to_string(value) + "\nset = [\"flow.shear_number=" + shear_number + "\"]\n";
        };
        return "case = \"" + shear_case + "\"\nset = " + list(coarse) +
               "\n[search]\nD = [0.1, 2]\nbeta = [6, 25]\n" + search + target(at_low, "0.3") +
               target(at_high, "1");
    }
};

TEST_F(Calibrate, finds_the_pair_that_made_the_targets_and_runs_nothing_twice) {
    const std::string file = write(
        "t.toml",
        targets(lambda_C("0.3", "0.4", "12"), lambda_C("1", "0.4", "12"), "first_pairs = 8\n"));
    const std::vector<std::string> words{
        "calibrate", file, "-o", path("out").string(), "-j", "2", "--json", "--progress", "none"};
    const Outcome first = run(words);
    ASSERT_EQ(first.code, 0) << first.err;
    const tt::Json j = tt::Json::parse(first.out);
    EXPECT_TRUE(j.at("settled").get<bool>());
    EXPECT_LT(j.at("chi_squared").get<double>(), 2.0);
    for (const auto& [name, truth] : {std::pair{"D", 0.4}, std::pair{"beta", 12.0}}) {
        const double value = j.at(name).at("value"), sd = j.at(name).at("standard_uncertainty");
        EXPECT_NEAR(value, truth, 3.0 * sd) << name;
        EXPECT_LT(sd, 0.6 * truth) << name << ": an uncertainty that says something";
    }
    EXPECT_LT(j.at("correlation_of_logarithms").get<double>(), -0.5);
    EXPECT_TRUE(fs::exists(path("out") / "figures" / "valley.svg"));

    const auto runs = [&] {
        std::vector<fs::file_time_type> times;
        for (const auto& entry : fs::directory_iterator(path("out") / "runs"))
            times.push_back(fs::last_write_time(entry.path() / "summary.json"));
        return times;
    };
    const auto made = runs();
    EXPECT_EQ(made.size(), 2 * j.at("pairs").size());
    const Outcome again = run(words);
    EXPECT_EQ(again.out, first.out);
    EXPECT_EQ(runs(), made);
}

TEST_F(Calibrate, a_pair_that_blows_up_is_told_and_left_out) {
    // A time step that a strongly hardened membrane cannot have.
    std::string text = targets(1.05, 1.15, "first_pairs = 6\nmost_pairs = 6\n");
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace("\"time.end",
            "\"numerics.dt=8 us\", \"numerics.implicit_tension=false\", "
            "\"numerics.node_spacing=1\", \"cells.cytoplasm_viscosity=1.2 cP\", \"time.end");
    replace("D = [0.1, 2]", "D = [0.001, 2]");
    const Outcome outcome =
        run({"calibrate", write("t.toml", text), "-o", path("out").string(), "-j", "2"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find(" failed: unstable at step "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find("NOT SETTLED"), std::string::npos);
    EXPECT_NE(outcome.out.find("[membrane.hardening]"), std::string::npos);
}

TEST_F(Calibrate, asked_to_stop_it_ends_with_75_and_goes_on_with_the_same_command) {
    const std::vector<std::string> words{
        "calibrate", write("t.toml", targets(1.05, 1.15, "first_pairs = 4\nmost_pairs = 4\n")),
        "-o", path("out").string()};
    tt::request_stop();
    const Outcome stopped = run(words);
    tt::clear_stop_request();
    EXPECT_EQ(stopped.code, 75);
    EXPECT_NE(stopped.err.find("the same command goes on"), std::string::npos) << stopped.err;
    EXPECT_FALSE(fs::exists(path("out") / "calibration.json"));
    EXPECT_EQ(run(words).code, 0);
    EXPECT_TRUE(fs::exists(path("out") / "calibration.json"));
    write("t.toml", targets(1.06, 1.15, "first_pairs = 4\nmost_pairs = 4\n"));
    EXPECT_EQ(run(words).code, 0);
    EXPECT_TRUE(fs::exists(path("out") / "former-1" / "calibration.json"));
}

TEST_F(Calibrate, a_directory_of_other_things_is_never_touched) {
    fs::create_directory(path("run"));
    write("run/PROVENANCE.json", "{}");
    const std::string file = write("t.toml", targets(1.05, 1.15));
    EXPECT_EQ(run({"calibrate", file, "-o", path("run").string()}).code, 4);
    EXPECT_EQ(run({"calibrate", path("none.toml").string()}).code, 5);
    EXPECT_EQ(run({"calibrate", file, "-j", "0"}).code, 2);
    EXPECT_EQ(run({"calibrate", file, "-o", path("x").string(), "--progress", "loud"}).code, 2);
}

TEST_F(Calibrate, keeps_its_inputs_can_be_moved_and_knows_an_outline_that_changed) {
    const auto outline = [&](double radius) {
        std::string points;
        for (int k = 0; k < 60; ++k)
            points += fmt::format("{},{}\n", radius * std::cos(k * M_PI / 30),
                                  radius * std::sin(k * M_PI / 30));
        return write("in/shapes/cell.csv", points);
    };
    fs::create_directories(path("in/shapes"));
    fs::copy_file(shear_case, path("in/case.toml"));
    outline(4.2);
    std::string text = targets(1.05, 1.15, "first_pairs = 4\nmost_pairs = 4\n");
    text.replace(text.find(shear_case), shear_case.size(), "case.toml");
    text.replace(text.find("\"time.end"), 0,
                 "\"cells.shape=file\", \"cells.file=shapes/cell.csv\", ");
    const std::string file = write("in/t.toml", text);
    const auto stop_at_once = [&](const std::string& targets_file, const char* out) {
        tt::request_stop();
        const Outcome outcome = run({"calibrate", targets_file, "-o", path(out).string()});
        tt::clear_stop_request();
        return outcome;
    };
    const Outcome stopped = stop_at_once(file, "out");
    ASSERT_EQ(stopped.code, 75) << stopped.err;
    EXPECT_TRUE(fs::exists(path("out/inputs/case.toml")));
    EXPECT_TRUE(fs::exists(path("out/inputs/shapes/cell.csv")));

    fs::rename(path("in"), path("gone"));
    const tt::Targets again = tt::read_targets(path("out/targets.toml"));
    ASSERT_EQ(again.inputs.size(), 2u);
    EXPECT_EQ(again.inputs[1].name, "inputs/shapes/cell.csv");

    fs::rename(path("gone"), path("in"));
    outline(4.4);
    const Outcome changed = stop_at_once(file, "out");
    EXPECT_NE(changed.err.find("former-1"), std::string::npos) << changed.err;
    EXPECT_TRUE(fs::exists(path("out/former-1/inputs/shapes/cell.csv")));
}

class TargetsFile : public tt::TemporaryDirectory {
protected:
    std::string faults_of(const std::string& text) const {
        const fs::path file = path("t.toml");
        std::ofstream(file) << text;
        fs::copy_file(std::string(TT_SOURCE_DIR) + "/cases/05-channel/case.toml",
                      path("channel.toml"), fs::copy_options::overwrite_existing);
        try {
            tt::read_targets(file);
        } catch (const tt::CaseError& error) {
            std::string told = error.what();
            const std::string folder = directory().string() + "/";
            for (std::size_t at = 0; (at = told.find(folder)) != std::string::npos;)
                told.erase(at, folder.size());
            const std::string known = fmt::format("{}", fmt::join(tt::summary_quantities(), ", "));
            if (const std::size_t at = told.find(known); at != std::string::npos)
                told.replace(at, known.size(), "...");
            return told;
        }
        return "none";
    }
    const std::string good =
        "case = \"channel.toml\"\n"
        "[search]\nD = [0.1, 2]\nbeta = [8, 30]\nseeds = [1, 2]\n"
        "[[target]]\nquantity = \"lambda_C\"\nvalue = 1.08\nuncertainty = 0.01\n"
        "[[target]]\nquantity = \"cfl_gap\"\nvalue = \"2 um\"\nuncertainty = \"0.1 um\"\n";
};

TEST_F(TargetsFile, is_read_with_units_and_runs_each_condition_once) {
    EXPECT_EQ(faults_of(good), "none");
    const tt::Targets t = tt::read_targets(path("t.toml"));
    EXPECT_EQ(t.conditions.size(), 1u);
    ASSERT_EQ(t.targets.size(), 2u);
    EXPECT_EQ(t.targets[1].goal.value, 2e-6);
    EXPECT_EQ(t.targets[1].unit, "m");
    const tt::Case c = tt::case_at(t.conditions[0], 0.3, 11.0, 2);
    EXPECT_EQ(c.membrane.hardening.D, 0.3);
    EXPECT_EQ(c.membrane.hardening.beta, 11.0);
    EXPECT_EQ(c.cells.seed, 2);
    EXPECT_EQ(c.output.frames, c.time.end) << "the channel's own would fill the disk";
}

TEST_F(TargetsFile, every_fault_is_told_at_once_with_its_place_and_what_to_write) {
    EXPECT_EQ(faults_of("case = \"channel.toml\"\n"
                        "set = [\"numerics.dx=0.4\"]\n"
                        "[search]\nD = [2, 0.1]\nbetta = [8, 30]\n"
                        "[[target]]\nquantity = \"lamda_C\"\nvalue = 1.08\n"
                        "[[target]]\nquantity = \"cfl_gap\"\nvalue = 2\nuncertainty = \"3 s\"\n"
                        "set = [\"time.end=80 ms\", \"flow.pseudo_shear_rat=50 /s\"]\n"),
              "t.toml:2:8: dx = 0.4 has no unit; write dx = \"0.4 um\"\n"
              "t.toml:3:2: beta is missing from [search]; write beta = [5, 30]\n"
              "t.toml:4:5: D must be the lower and the upper end of its range, as in [0.1, 2]\n"
              "t.toml:5:1: unknown key 'betta' in [search]; did you mean 'beta'?\n"
              "t.toml:6:1: uncertainty is missing from [[target]]; write uncertainty = \"0.01\"\n"
              "t.toml:7:12: quantity = \"lamda_C\" is not one of ...; did you mean \"lambda_C\"?\n"
              "t.toml:11:9: value = 2 has no unit; write value = \"2 m\"\n"
              "t.toml:12:15: uncertainty is of the kind time, and length is wanted\n"
              "t.toml:13:26: unknown key 'pseudo_shear_rat' in [flow]; did you mean "
              "'pseudo_shear_rate'?");
}

TEST_F(TargetsFile, what_cannot_be_calibrated_is_refused) {
    EXPECT_NE(faults_of("").find("there is no target"), std::string::npos);
    EXPECT_NE(
        faults_of("case = \"nothing.toml\"\n" + good.substr(good.find('\n'))).find("t.toml:1:8: "),
        std::string::npos);
    EXPECT_NE(faults_of("set = [\"membrane.hardening.apply_to=[]\"]\n" + good)
                  .find("nothing hardens in this case"),
              std::string::npos);
    EXPECT_NE(faults_of("set = [\"cells.layout=single\", \"cells.count=1\"]\n" + good)
                  .find("uses no random numbers; take seeds out"),
              std::string::npos);
    EXPECT_NE(faults_of("target = 3\n" + good.substr(0, good.find("[[")))
                  .find("write [[target]] on a line of its own"),
              std::string::npos);
}

}  // namespace
