#include "command.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/selftest.hpp"
#include "case/read.hpp"
#include "case/reference.hpp"
#include "io/json.hpp"
#include "io/file.hpp"
#include "simulation/stop.hpp"
#include "source_dir.hpp"
#include "temporary_directory.hpp"

namespace {

namespace fs = std::filesystem;

using tt::Outcome;
using tt::run;

std::size_t longest_line(const std::string& text) {
    std::istringstream lines(text);
    std::size_t longest = 0;
    for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
    return longest;
}

std::string in_source(const std::string& path) { return std::string(TT_SOURCE_DIR) + "/" + path; }

TEST(CommandLine, bad_commands_end_with_2_and_say_what_to_write) {
    EXPECT_EQ(run({}).code, 2);
    EXPECT_EQ(run({"chek"}).code, 2);
    EXPECT_NE(run({"chek"}).err.find("did you mean 'check'?"), std::string::npos);
    EXPECT_EQ(run({"check"}).code, 2);
    EXPECT_EQ(run({"check", "--jsn", "x"}).code, 2);
    EXPECT_EQ(run({"new", "x", "--from", "chanel"}).code, 2);
    EXPECT_EQ(run({"keys", "nothing-like-it"}).code, 2);
    EXPECT_EQ(run({"--no-such-option"}).code, 2);
}

TEST(CommandLine, a_selftest_ends_with_1_if_one_check_fails_or_one_part_throws) {
    const tt::SelftestPart good{"good", [] {
                                    return std::vector<tt::Check>{{"x", 2.0, 2.1, 0.06}};
                                }};
    const tt::SelftestPart bad{"bad", [] { return std::vector<tt::Check>{{"y", 2.0, 1.8, 0.06}}; }};
    const tt::SelftestPart throws{
        "throws", []() -> std::vector<tt::Check> { throw std::runtime_error("blew up"); }};
    const auto outcome = [](std::vector<tt::SelftestPart> parts, bool json = false) {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        Outcome o;
        o.code = tt::run_selftest(parts, json);
        o.out = testing::internal::GetCapturedStdout();
        o.err = testing::internal::GetCapturedStderr();
        return o;
    };
    EXPECT_EQ(outcome({good}).code, 0);
    const Outcome failed = outcome({good, bad, good});
    EXPECT_EQ(failed.code, 1);
    EXPECT_NE(failed.out.find("FAILED"), std::string::npos);
    EXPECT_NE(failed.err.find("1 of 3 checks failed"), std::string::npos);
    const Outcome thrown = outcome({throws, good}, true);
    EXPECT_EQ(thrown.code, 1);
    const tt::Json list = tt::Json::parse(thrown.out);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_FALSE(list[0]["passed"].get<bool>());
    EXPECT_NE(list[0]["what"].get<std::string>().find("blew up"), std::string::npos);
    EXPECT_TRUE(list[1]["passed"].get<bool>());
}

TEST(CommandLine, a_file_that_cannot_be_read_ends_with_5) {
    const Outcome outcome = run({"check", "no-such-file.toml"});
    EXPECT_EQ(outcome.code, 5);
    EXPECT_NE(outcome.err.find("no-such-file.toml"), std::string::npos);
    EXPECT_EQ(run({"check", TT_SOURCE_DIR}).code, 5);
    const Outcome folder = run({"check", in_source("cases/05-channel")});
    EXPECT_EQ(folder.code, 5);
    EXPECT_NE(folder.err.find("did you mean " + in_source("cases/05-channel/case.toml?")),
              std::string::npos)
        << folder.err;
}

TEST(CommandLine, a_faulty_case_ends_with_2_and_leaves_stdout_empty) {
    const Outcome outcome =
        run({"check", in_source("cases/05-channel/case.toml"), "--set", "flow.drive=pull"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("--set flow.drive=pull: drive"), std::string::npos);
}

TEST(CommandLine, help_goes_to_stdout_and_fits_80_columns) {
    for (const char* verb :
         {"", "new", "check", "run", "resume", "status", "report", "export", "calibrate", "keys"}) {
        std::vector<std::string> words{"--help"};
        if (*verb != '\0') words.insert(words.begin(), verb);
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find("Usage: tanktread"), std::string::npos);
        EXPECT_LE(longest_line(outcome.out), 80u) << outcome.out;
    }
    EXPECT_EQ(run({"--version"}).out.substr(0, 10), "tanktread ");
}

TEST(CommandLine, the_page_of_keys_is_that_of_this_program) {
    std::ifstream file(in_source("docs/keys.md"));
    std::ostringstream page;
    page << file.rdbuf();
    EXPECT_TRUE(page.str() == tt::reference_markdown())
        << "run: tanktread keys --markdown > docs/keys.md";
    EXPECT_TRUE(run({"keys", "--markdown"}).out == tt::reference_markdown());
}

TEST(CommandLine, keys_are_found_by_table_and_by_part_of_their_name) {
    EXPECT_LE(longest_line(tt::reference_text()), 80u);
    const std::string flow = run({"keys", "flow"}).out;
    EXPECT_NE(flow.find("pseudo_shear_rate = \"500 /s\""), std::string::npos);
    EXPECT_EQ(flow.find("[cells]"), std::string::npos);
    EXPECT_NE(flow.find("domain.length"), std::string::npos);
    EXPECT_NE(run({"keys", "radius"}).out.find("[cells]"), std::string::npos);
    const std::string width = run({"keys", "domain.width"}).out;
    EXPECT_NE(width.find("width = \"20 um\""), std::string::npos);
    EXPECT_EQ(width.find("length ="), std::string::npos);
    EXPECT_NE(run({"keys", "Brownian motion"}).err.find("no key has"), std::string::npos);
    EXPECT_NE(run({"keys", "stress on the walls"}).out.find("wall_stress"), std::string::npos);
    EXPECT_NE(run({"keys", "SKALAK"}).out.find("law ="), std::string::npos);
}

class NewCase : public tt::TemporaryDirectory {};

TEST_F(NewCase, can_be_read_and_never_overwrites) {
    for (const char* from : {"channel", "shear", "relax", "poiseuille", "couette"}) {
        const std::string file = path(std::string("my-") + from + ".toml").string();
        EXPECT_EQ(run({"new", file, "--from", from}).code, 0);
        EXPECT_EQ(tt::read_case(file).name, std::string("my-") + from);
        const auto size = fs::file_size(file);
        EXPECT_EQ(run({"new", file, "--from", "shear"}).code, 5);
        EXPECT_EQ(fs::file_size(file), size);
    }
}

TEST(CommandLine, check_answers_which_dx_dt_and_tau) {
    const std::string path = in_source("cases/04-cell-relaxing/case.toml");
    const Outcome text = run({"check", path, "-j", "1"});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_LE(longest_line(text.out), 80u) << text.out;
    for (const char* word : {"grid ", "time step ", "relaxation time ", "margin", "memory ",
                             "time to finish ", "eady to run"})
        EXPECT_NE(text.out.find(word), std::string::npos) << word;
    const Outcome json = run({"check", path, "--json", "-j", "1"});
    const tt::Json j = tt::Json::parse(json.out);
    EXPECT_TRUE(j.at("ready").get<bool>());
    EXPECT_EQ(j.at("nx"), 100);
    EXPECT_NEAR(j.at("dx_m").get<double>(), 4e-7, 1e-15);
    // ν = (τ − ½)/3 · dx²/dt at S times the density.
    const double nu = (j.at("relaxation_time_plasma").get<double>() - 0.5) / 3.0 * 1.6e-13 /
                      j.at("dt_s").get<double>();
    EXPECT_NEAR(nu * j.at("density_scale").get<double>() * 1025.0, 1.2e-3, 1e-9);
}

TEST(CommandLine, check_refuses_what_cannot_be_stable_and_says_what_to_change) {
    const std::string path = in_source("cases/04-cell-relaxing/case.toml");
    const Outcome stiff =
        run({"check", path, "-j", "1", "--set", "membrane.area_stiffness=\"1 MPa\"", "--set",
             "membrane.hold_area=false"});
    EXPECT_EQ(stiff.code, 2);
    EXPECT_NE(stiff.out.find("  ! area_stiffness = 1 MPa is stiffer"), std::string::npos)
        << stiff.out;
    const Outcome fast = run({"check", path, "-j", "1", "--set", "numerics.dt=\"200 us\""});
    EXPECT_EQ(fast.code, 2);
    EXPECT_NE(fast.out.find("  ! The time step 0.2 ms is"), std::string::npos) << fast.out;
}

class RunVerb : public tt::TemporaryDirectory {
protected:
    /// A small plain channel of a few hundred steps.
    std::vector<std::string> small_run(const std::string& out) const {
        return {"run",        in_source("cases/01-poiseuille/case.toml"),
                "-o",         path(out).string(),
                "-j",         "1",
                "--set",      "time.end=10 us",
                "--progress", "none"};
    }
    std::string state_hash(const std::string& out) const {
        return tt::Json::parse(std::ifstream(path(out) / "PROVENANCE.json")).at("state_hash");
    }
};

TEST_F(RunVerb, prints_where_the_results_are_and_says_when_they_are_finished) {
    const Outcome first = run(small_run("a"));
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(first.out, path("a").string() + "\n");
    const Outcome second = run(small_run("a"));
    EXPECT_EQ(second.code, 0);
    EXPECT_NE(second.err.find("is finished"), std::string::npos) << second.err;
    EXPECT_EQ(run({"status", path("a").string()}).code, 0);
    EXPECT_EQ(tt::Json::parse(run({"status", path("a").string(), "--json"}).out).at("status"),
              "done");
}

TEST_F(RunVerb, report_leaves_out_figures_that_have_no_data_and_says_so) {
    ASSERT_EQ(run(small_run("plasma")).code, 0);
    const Outcome of_plasma = run({"report", path("plasma").string()});
    EXPECT_EQ(of_plasma.code, 0) << of_plasma.err;
    EXPECT_FALSE(fs::exists(path("plasma") / "figures" / "lambda_C.png"));
    EXPECT_TRUE(fs::exists(path("plasma") / "figures" / "mu_rel.png"));

    std::vector<std::string> relaxing = small_run("relaxing");
    relaxing[1] = in_source("cases/04-cell-relaxing/case.toml");
    relaxing[7] = "time.end=1 ms";
    ASSERT_EQ(run(relaxing).code, 0);
    const Outcome at_rest = run({"report", path("relaxing").string()});
    EXPECT_EQ(at_rest.code, 0) << at_rest.err;
    EXPECT_TRUE(fs::exists(path("relaxing") / "figures" / "lambda_C.png"));
    EXPECT_FALSE(fs::exists(path("relaxing") / "figures" / "mu_rel.png"));
    std::ostringstream page;
    page << std::ifstream(path("relaxing") / "report.html").rdbuf();
    EXPECT_NE(page.str().find("have no data for them: apparent viscosity"), std::string::npos);
    EXPECT_EQ(page.str().find("thinner films of plasma"), std::string::npos)
        << "no gap is judged where none was looked for";
}

TEST_F(RunVerb, status_of_a_run_that_was_killed_before_it_had_a_pace_is_told) {
    ASSERT_EQ(run(small_run("a")).code, 0);
    tt::Json status = tt::Json::parse(std::ifstream(path("a") / "status.json"));
    status["status"] = "running";
    status["seconds_left"] = nullptr;
    std::ofstream(path("a") / "status.json") << status;
    const Outcome outcome = run({"status", path("a").string()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("interrupted"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("? left"), std::string::npos) << outcome.out;
}

TEST_F(RunVerb, never_touches_results_of_another_case) {
    ASSERT_EQ(run(small_run("a")).code, 0);
    std::vector<std::string> other = small_run("a");
    other.insert(other.end(), {"--set", "plasma.viscosity=2 cP"});
    EXPECT_EQ(run(other).code, 4);
    other.push_back("--fresh");
    EXPECT_EQ(run(other).code, 0);
    EXPECT_TRUE(fs::exists(path("a.1") / "summary.json"));
}

TEST_F(RunVerb, stopped_and_resumed_ends_in_the_same_bits) {
    ASSERT_EQ(run(small_run("whole")).code, 0);
    std::vector<std::string> part = small_run("parts");
    part.insert(part.end(), {"--until", "4 us"});
    for (int time = 0; time < 2; ++time) {  // the second finds it there already
        const Outcome stopped = run(part);
        ASSERT_EQ(stopped.code, 75) << stopped.err;
        EXPECT_NE(stopped.err.find("next:  tanktread resume"), std::string::npos) << stopped.err;
        EXPECT_FALSE(fs::exists(path("parts") / "summary.json"));
        EXPECT_NE(run({"status", path("parts").string()}).out.find("stopped"), std::string::npos);
    }
    EXPECT_NE(state_hash("parts"), state_hash("whole"));
    const Outcome resumed =
        run({"resume", path("parts").string(), "-j", "1", "--progress", "none"});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(state_hash("parts"), state_hash("whole"));
    for (const char* table : {"series.csv", "cells.csv", "profiles.csv"})
        EXPECT_EQ(tt::read_file(path("parts") / table), tt::read_file(path("whole") / table))
            << table;
}

TEST_F(RunVerb, time_limit_ends_with_75) {
    std::vector<std::string> words = small_run("a");
    words[7] = "time.end=10 s";
    words.insert(words.end(), {"--max-time", "0.1s"});
    EXPECT_EQ(run(words).code, 75);
    EXPECT_EQ(run({"resume", path("a").string(), "--max-time", "0.05s"}).code, 75);
}

TEST_F(RunVerb, bad_options_end_with_2_before_anything_is_written) {
    for (const auto& [option, value] :
         std::vector<std::pair<std::string, std::string>>{{"--max-time", "soon"},
                                                          {"--until", "1 um"},
                                                          {"--until", "1 s"},
                                                          {"--progress", "loud"}}) {
        std::vector<std::string> words = small_run("a");
        words.insert(words.end(), {option, value});
        EXPECT_EQ(run(words).code, 2) << option;
    }
    EXPECT_FALSE(fs::exists(path("a")));
}

/// A random layout that has no room: told only when it has been tried.
TEST_F(RunVerb, a_refusal_leaves_every_directory_as_it_was) {
    const auto refused = [&](const std::string& out) {
        return std::vector<std::string>{
            "run",        in_source("cases/05-channel/case.toml"),
            "-o",         out,
            "-j",         "1",
            "--set",      "cells.layout=explicit",
            "--set",      "cells.positions=[[\"9 um\", \"9 um\"], [\"10 um\", \"9 um\"]]",
            "--set",      "cells.count=2",
            "--progress", "none"};
    };
    EXPECT_EQ(run(refused(path("none/here/run").string())).code, 2);
    EXPECT_FALSE(fs::exists(path("none")));
    fs::create_directory(path("empty"));
    EXPECT_EQ(run(refused(path("empty/run/").string())).code, 2);
    EXPECT_TRUE(fs::is_empty(path("empty")));

    ASSERT_EQ(run(small_run("results")).code, 0);
    std::vector<std::string> fresh = refused(path("results").string());
    fresh.push_back("--fresh");
    EXPECT_EQ(run(fresh).code, 2);
    EXPECT_TRUE(fs::exists(path("results/summary.json")));
    EXPECT_FALSE(fs::exists(path("results.1")));
}

TEST_F(RunVerb, a_stop_while_cells_are_placed_ends_it_at_once) {
    std::thread impatient([] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        tt::request_stop();
    });
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome =
        run({"run", in_source("cases/05-channel/case.toml"), "-o", path("a").string(), "-j", "1",
             "--set", "cells.layout=random", "--set", "cells.hematocrit=60 %", "--set",
             "domain.length=2 mm", "--set", "domain.width=0.2 mm", "--set", "numerics.dx=1 um",
             "--progress", "none"});
    impatient.join();
    tt::clear_stop_request();
    EXPECT_EQ(outcome.code, 75) << outcome.err;
    EXPECT_NE(outcome.err.find("while cells were placed"), std::string::npos) << outcome.err;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
    EXPECT_FALSE(fs::exists(path("a")));
}

TEST_F(RunVerb, verbs_on_results_that_are_not_there_end_with_5) {
    for (const char* verb : {"status", "resume", "report"})
        EXPECT_EQ(run({verb, path("nowhere").string()}).code, 5) << verb;
    EXPECT_EQ(run({"export", path("nowhere").string(), "--to", "csv"}).code, 5);
    EXPECT_EQ(run({"export", path("nowhere").string(), "--to", "gif"}).code, 2);
}

}  // namespace
