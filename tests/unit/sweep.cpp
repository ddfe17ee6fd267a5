#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/sweep_plan.hpp"
#include "command.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "observe/sweep_record.hpp"
#include "simulation/stop.hpp"
#include "temporary_directory.hpp"

namespace {

namespace fs = std::filesystem;
using tt::Outcome;
using Words = std::vector<std::string>;

/// A case of a cell of five sites; a run takes a fraction of a second.
std::string tiny_case() {
    return "format = 1\nname = \"tiny\"\n"
           "domain = { length = \"24 um\", width = \"12 um\" }\n"
           "flow = { drive = \"pressure\", pseudo_shear_rate = \"200 /s\" }\n"
           "cells = { count = 1, radius = \"2.7 um\", layout = \"single\" }\n"
           "numerics = { dx = \"0.6 um\" }\n"
           "time = { end = \"0.2 ms\" }\n"
           "output = { series = \"5 us\", frames = \"0.1 ms\" }\n";
}

class SweepRuns : public tt::TemporaryDirectory {
protected:
    void SetUp() override { write("tiny.toml", tiny_case()); }

    std::string write(const std::string& name, const std::string& text) const {
        fs::create_directories(path(name).parent_path());
        std::ofstream(path(name)) << text;
        return path(name).string();
    }
    Outcome sweep(Words words, const std::string& out = "results/G") const {
        words.insert(words.begin(), "sweep");
        words.insert(words.end(), {"-o", path(out).string(), "--progress", "none"});
        return tt::run(words);
    }
    Words over(const std::string& axis) const {
        return {path("tiny.toml").string(), "--over", axis};
    }
    std::vector<Words> table(const std::string& of = "results/G") const {
        std::vector<Words> rows;
        std::istringstream text(tt::read_file(path(of) / "table.csv"));
        for (std::string line; std::getline(text, line);) {
            rows.emplace_back();
            std::istringstream cells(line);
            for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
        }
        return rows;
    }
    /// When each run was finished.
    std::map<std::string, fs::file_time_type> made(const std::string& of = "results/G") const {
        std::map<std::string, fs::file_time_type> times;
        for (const auto& run : fs::directory_iterator(path(of) / "runs"))
            times[run.path().filename()] = fs::last_write_time(run.path() / "summary.json");
        return times;
    }
};

TEST_F(SweepRuns, are_named_by_their_values_and_make_a_row_each) {
    Words words = over("flow.pseudo_shear_rate=100,200 /s");
    words.insert(words.end(), {"--over", "cells.radius=2.4, 2.7 um"});
    const Outcome outcome = sweep(words);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, path("results/G").string() + "\n");
    const auto rows = table();
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[0][2], "flow.pseudo_shear_rate [/s]");
    EXPECT_EQ(rows[0][3], "cells.radius [m]");
    EXPECT_EQ(rows[2][0], "pseudo_shear_rate=100_per_s_radius=2.7um");
    EXPECT_EQ(rows[2][2], "100");
    EXPECT_EQ(rows[2][3], "2.7e-06");
    EXPECT_EQ(rows[2][4], "done");
    const tt::Json summary = tt::read_json(path("results/G") / rows[2][1] / "summary.json");
    for (const std::string name : {"lambda_C", "mean_velocity"})
        for (std::size_t c = 0; c < rows[0].size(); ++c) {
            const bool mean = rows[0][c].starts_with(name + " [") || rows[0][c] == name;
            const bool error = rows[0][c].starts_with(name + "_standard_error");
            if (!mean && !error) continue;
            EXPECT_EQ(std::stod(rows[2][c]),
                      summary[name][mean ? "mean" : "standard_error"].get<double>());
        }
    const auto before = made();
    const std::string text = tt::read_file(path("results/G/table.csv"));
    EXPECT_EQ(tt::run({"sweep", path("results/G").string(), "--progress", "none"}).code, 0);
    EXPECT_EQ(made(), before) << "nothing is made twice";
    EXPECT_EQ(tt::read_file(path("results/G/table.csv")), text);
    EXPECT_NE(tt::run({"status", path("results/G").string()}).out.find("4 of 4 runs done"),
              std::string::npos);
}

TEST_F(SweepRuns, keys_in_one_axis_change_together_from_a_file_as_well) {
    const std::string file = write("plan/pairs.toml",
                                   "case = \"../tiny.toml\"\nset = [\"time.end=0.1 ms\"]\n"
                                   "[[over]]\ncells.radius = [\"2.4 um\", \"2.7 um\"]\n"
                                   "flow.pseudo_shear_rate = \"100, 200 /s\"\n");
    const Outcome outcome = sweep({file});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = table();
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[1][0], "radius=2.4um_pseudo_shear_rate=100_per_s");
    EXPECT_EQ(rows[2][0], "radius=2.7um_pseudo_shear_rate=200_per_s");
    fs::rename(path("plan"), path("gone"));
    fs::rename(path("tiny.toml"), path("tiny.gone"));
    EXPECT_EQ(tt::run({"sweep", path("results/G").string(), "--progress", "none"}).code, 0)
        << "it stands alone";
}

TEST_F(SweepRuns, that_were_made_by_hand_or_in_another_sweep_are_found) {
    ASSERT_EQ(tt::run({"run", path("tiny.toml").string(), "--set", "cells.radius=2.4 um", "-o",
                       path("results/hand").string(), "--progress", "none", "--set", "name=other"})
                  .code,
              0);
    ASSERT_EQ(sweep(over("cells.radius=2.5,2.7 um"), "results/former").code, 0);
    const Outcome outcome = sweep(over("cells.radius=2.4,2.5,2.6,2.7 um"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(made().size(), 1u) << "only what nobody had made";
    const auto rows = table();
    EXPECT_EQ(rows[1][1], "../hand");
    EXPECT_EQ(rows[2][1], "../former/runs/radius=2.5um");
    EXPECT_EQ(rows[3][1], "runs/radius=2.6um");
    for (std::size_t r = 1; r < rows.size(); ++r) EXPECT_EQ(rows[r][3], "done");
    const Outcome anew =
        sweep({path("tiny.toml").string(), "--over", "cells.radius=2.4,2.6 um", "--fresh"});
    ASSERT_EQ(anew.code, 0) << anew.err;
    EXPECT_EQ(made().size(), 2u);
    EXPECT_TRUE(fs::exists(path("results/G.1/table.csv")));
}

TEST_F(SweepRuns, that_blow_up_are_listed_and_tried_again_on_request_only) {
    // A cell almost without viscosity, whose area is kept by a pressure just below what is refused.
    Words words = over("membrane.area_stiffness=1, 9.51 kPa");
    for (const char* item :
         {"flow.pseudo_shear_rate=80 /s", "cells.cytoplasm_viscosity=0.0745 cP",
          "membrane.hold_area=false", "domain.length=20 um", "numerics.dx=0.5 um",
          "numerics.jump_correction=true", "numerics.implicit_tension=false",
          "numerics.node_spacing=1", "numerics.relaxation_time=1.5", "time.end=1 ms"})
        words.insert(words.end(), {"--set", item});
    const Outcome outcome = sweep(words);
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("1 of 2 runs done, 1 failed"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("failed: area_stiffness=9.51kPa: unstable at step"),
              std::string::npos)
        << outcome.err;
    const fs::path failed = path("results/G/runs/area_stiffness=9.51kPa");
    const auto when = fs::last_write_time(failed / "status.json");
    EXPECT_EQ(sweep(words).code, 3);
    EXPECT_EQ(fs::last_write_time(failed / "status.json"), when);
    Words again = words;
    again.push_back("--retry");
    EXPECT_EQ(sweep(again).code, 3);
    EXPECT_NE(fs::last_write_time(failed / "status.json"), when);
    EXPECT_TRUE(fs::exists(path("results/G/runs/area_stiffness=9.51kPa.1")));
    EXPECT_EQ(table()[2][3], "failed");
}

TEST_F(SweepRuns, asked_to_stop_it_ends_with_75_and_the_same_command_goes_on) {
    tt::request_stop();
    EXPECT_EQ(sweep(over("cells.radius=2.4,2.7 um")).code, 75);
    tt::clear_stop_request();
    EXPECT_EQ(sweep(over("cells.radius=2.4,2.7 um")).code, 0);
    EXPECT_EQ(made().size(), 2u);
    // More values later: only those are made.
    const auto before = made();
    EXPECT_EQ(sweep(over("cells.radius=2.4:2.7:0.1 um")).code, 0);
    EXPECT_EQ(made().size(), 4u);
    for (const auto& [name, when] : before) EXPECT_EQ(made().at(name), when);
    EXPECT_EQ(table().size(), 5u);
}

TEST_F(SweepRuns, every_fault_of_every_axis_is_told_before_anything_starts) {
    Words words = over("flow.pseudo_shear_rate=100:200:30 /s");
    words.insert(words.end(), {"--over", "cells.radius=2 um, 3 s", "--over", "cells.rad=1,2",
                               "--set", "numerics.dx=3"});
    const Outcome outcome = sweep(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err.substr(0, outcome.err.find("tanktread:")),
              "--over cells.rad=1,2: unknown key 'rad' in [cells]; did you mean 'radius'?\n"
              "--over cells.radius=2 um, 3 s: radius = \"3 s\" is of the kind time, and length is "
              "wanted, as in \"4 um\"\n"
              "--over flow.pseudo_shear_rate=100:200:30 /s: the steps of 30 do not end at 200; "
              "write 190 or 220 for it\n"
              "--set numerics.dx=3: dx = 3 has no unit; write dx = \"3 um\"\n");
    EXPECT_FALSE(fs::exists(path("results")));
    const std::string file =
        write("bad.toml",
              "case = \"tiny.toml\"\nset = [\"numerics.dx=3\"]\n[[over]]\n"
              "cells.radius = [\"2 um\", \"2 s\"]\n[[over]]\ncells.seed = \"1:4:2\"\n");
    std::string told = sweep({file}).err;
    told = told.substr(0, told.find("tanktread:"));
    for (std::size_t at = 0; (at = told.find(file)) != std::string::npos;)
        told.erase(at, file.size());
    EXPECT_EQ(told,
              ":2:8: dx = 3 has no unit; write dx = \"3 um\"\n"
              ":4:25: radius = \"2 s\" is of the kind time, and length is wanted, as in \"4 um\"\n"
              ":6:14: the steps of 2 do not end at 4; write 3 or 5 for it\n");
}

TEST_F(SweepRuns, what_is_no_sweep_is_told_with_what_to_write) {
    const std::string tiny = path("tiny.toml").string();
    EXPECT_NE(sweep({write("typo.toml", "case = \"tiny.toml\n[[over]]\ncells.seed = [1]\n")})
                  .err.find("typo.toml:1:"),
              std::string::npos);
    EXPECT_NE(sweep({tiny}).err.find("nothing to go over; write for example --over"),
              std::string::npos);
    EXPECT_NE(sweep(over("cells.radius=2.7,2.70 um")).err.find("are the same run"),
              std::string::npos);
    EXPECT_NE(sweep({write("none.toml", "case = \"tiny.toml\"\n")}).err.find("there is no axis"),
              std::string::npos);
    EXPECT_NE(sweep({write("gone.toml", "case = \"gone\"\n[[over]]\ncells.seed = [1]\n")})
                  .err.find("gone.toml:1:8: there is no case file"),
              std::string::npos);
    // So is what would blow up.
    Words words = over("membrane.area_stiffness=1,30 kPa");
    words.insert(words.end(), {"--set", "membrane.hold_area=false"});
    const Outcome stiff = sweep(words);
    EXPECT_EQ(stiff.code, 2);
    EXPECT_TRUE(stiff.err.starts_with("area_stiffness=30kPa: area_stiffness = 30 kPa is stiffer"))
        << stiff.err;
    EXPECT_FALSE(fs::exists(path("results")));
    write("results/full/notes.txt", "mine");
    EXPECT_EQ(sweep(over("cells.radius=2.4,2.7 um"), "results/full").code, 4);
    ASSERT_EQ(sweep(over("cells.radius=2.4,2.7 um")).code, 0);
    const Outcome other =
        sweep({tiny, "--over", "cells.radius=2.4,2.7 um", "--set", "plasma.viscosity=1 cP"});
    EXPECT_EQ(other.code, 4);
    EXPECT_NE(other.err.find("plasma.viscosity"), std::string::npos) << other.err;
    EXPECT_EQ(tt::run({"sweep", tiny, "--over", "cells.radius=2.4,2.7 um", "--list", "-o",
                       path("results/G").string()})
                  .out,
              "done     radius=2.4um\ndone     radius=2.7um\n");
}

}  // namespace
