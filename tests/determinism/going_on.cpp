#include <csignal>
#include <map>
#include <string>
#include <thread>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/csv.hpp"
#include "observe/provenance.hpp"
#include "observe/status.hpp"
#include "runs.hpp"

namespace tt {
namespace {

/// What a second call of `run` makes of a directory.
using GoingOn = RunsTest;

TEST_F(GoingOn, finished_results_without_a_checkpoint_are_left_as_they_are) {
    const RunRequest request = small_request(path("done"), 100);
    run_small(request);
    fs::remove_all(path("done") / "checkpoint");
    std::map<std::string, std::string> before;
    for (const char* name : {"series.csv", "cells.csv", "frames.h5", "summary.json",
                             "PROVENANCE.json", "status.json"}) {
        before[name] = read_file(path("done") / name);
    }
    const RunOutcome outcome = run_small(request);
    EXPECT_EQ(outcome.ending, RunOutcome::Ending::was_done);
    EXPECT_EQ(outcome.steps, 100);
    for (const auto& [name, text] : before) EXPECT_EQ(read_file(path("done") / name), text) << name;
}

TEST_F(GoingOn, two_runs_never_write_to_one_directory) {
    const RunRequest request = small_request(path("run"), 100000000);
    const pid_t child = in_a_child([&] { run_small(request); });
    while (!fs::exists(path("run") / "status.json")) std::this_thread::yield();
    EXPECT_TRUE(is_running(path("run")));
    EXPECT_THROW(run_small(request), DirectoryInUse);
    RunRequest fresh = request;
    fresh.start = Start::fresh;
    EXPECT_THROW(run_small(fresh), DirectoryInUse);
    kill(child, SIGKILL);
    ending_of(child);
    EXPECT_FALSE(is_running(path("run")));
}

TEST_F(GoingOn, results_of_another_case_and_foreign_files_are_left_alone) {
    RunRequest request = small_request(path("run"), 50);
    run_small(request);
    const std::string series = read_file(path("run") / "series.csv");
    request.settings = "flow.shear_rate = \"80 /s\"\nmembrane.law = \"hookean\"\n";
    try {
        run_small(request);
        FAIL() << "another case was taken";
    } catch (const DirectoryInUse& error) {
        const std::string told = error.what();
        EXPECT_NE(told.find("  flow.shear_rate: \"75 /s\" there, \"80 /s\" here\n"),
                  std::string::npos)
            << told;
        EXPECT_NE(told.find("  membrane.law: not known there, \"hookean\" here\n"),
                  std::string::npos)
            << told;
    }
    EXPECT_EQ(read_file(path("run") / "series.csv"), series);
    request.start = Start::fresh;
    run_small(request);
    EXPECT_EQ(read_file(path("run.1") / "series.csv"), series);

    fs::create_directory(path("thesis"));
    replace_file(path("thesis") / "chapter1.tex", "...", Durability::process);
    request.directory = path("thesis");
    EXPECT_THROW(run_small(request), DirectoryInUse);
}

/// A request for `steps` that says so, as a case file does.
RunRequest longer_request(const fs::path& directory, std::int64_t steps) {
    RunRequest request = small_request(directory, steps);
    request.settings += "time.end = \"" + std::to_string(steps) + " us\"\n";
    return request;
}

TEST_F(GoingOn, a_finished_run_made_longer_ends_like_one_that_was_as_long_from_the_start) {
    run_small(longer_request(path("straight"), 2011));
    run_small(longer_request(path("longer"), 1007));
    EXPECT_EQ(read_csv(path("longer") / "series.csv").column("step").back(), 1007);
    EXPECT_EQ(run_small(longer_request(path("longer"), 2011)).ending, RunOutcome::Ending::done);
    expect_same_results(path("straight"), path("longer"));
    EXPECT_EQ(read_json(path("straight") / "summary.json")["lambda_C"],
              read_json(path("longer") / "summary.json")["lambda_C"]);
    EXPECT_THROW(run_small(longer_request(path("longer"), 1007)), DirectoryInUse);
}

TEST_F(GoingOn, the_summary_of_a_shorter_run_does_not_outlive_it) {
    run_small(longer_request(path("run"), 1007));
    RunRequest longer = longer_request(path("run"), 2011);
    longer.until = Time{1500 * small_model().scales.time};
    EXPECT_EQ(run_small(longer).ending, RunOutcome::Ending::stopped);
    EXPECT_FALSE(fs::exists(path("run") / "summary.json"));
    EXPECT_EQ(read_status(path("run")).at("status"), "stopped");
}

TEST_F(GoingOn, another_cadence_and_another_name_hold_from_there_on) {
    RunRequest request = longer_request(path("run"), 1000);
    run_small(request);
    request = longer_request(path("run"), 2000);
    request.series = Time{50 * small_model().scales.time};
    request.frames.reset();  // auto: as before
    request.name = "longer";
    request.settings += "name = \"longer\"\n";
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    const auto step = read_csv(path("run") / "series.csv").column("step");
    ASSERT_EQ(step.size(), 101u + 20u);
    EXPECT_EQ(step[100], 1000);
    EXPECT_EQ(step[101], 1050);
    EXPECT_EQ(FramesReader(path("run") / "frames.h5").count(), 81);
    EXPECT_EQ(FramesReader(path("run") / "frames.h5").header().name, "longer");
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::was_done);
    request.settings += "output.fields = \"never\"\n";  // of a finished run, no step to go
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    EXPECT_EQ(recorded_settings(path("run")), request.settings);
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::was_done);
}

TEST_F(GoingOn, a_run_without_its_summary_is_ended_once_more_to_the_same_files) {
    const RunRequest request = small_request(path("again"), 1007);
    run_small(small_request(path("straight"), 1007));
    run_small(request);
    fs::remove(path("again") / "summary.json");
    EXPECT_EQ(read_status(path("again")).at("status"), "interrupted");
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::was_done);
    replace_file(path("again") / "summary.json", "{\"lamb", Durability::process);
    EXPECT_EQ(read_status(path("again")).at("status"), "interrupted");
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    EXPECT_EQ(read_status(path("again")).at("status"), "done");
    expect_same_results(path("straight"), path("again"));
    EXPECT_EQ(read_json(path("straight") / "summary.json")["lambda_C"],
              read_json(path("again") / "summary.json")["lambda_C"]);
}

/// A disk that was full at the very end of a run.
TEST_F(GoingOn, frames_that_could_not_be_put_together_are_so_by_the_next_call) {
    const RunRequest request = small_request(path("apart"), 500);
    run_small(small_request(path("straight"), 500));
    rlimit limit{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit small{200'000, limit.rlim_max};  // enough for a checkpoint and for each frame
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto ending = run_small(request).ending;
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_EQ(ending, RunOutcome::Ending::done);
    EXPECT_TRUE(fs::exists(path("apart") / "frames"));
    EXPECT_TRUE(fs::exists(path("apart") / "summary.json"));
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    EXPECT_FALSE(fs::exists(path("apart") / "frames"));
    expect_same_results(path("straight"), path("apart"));
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::was_done);
}

TEST_F(GoingOn, a_row_and_a_frame_stand_once_at_the_end) {
    RunRequest request = small_request(path("run"), 100);
    const double dt = small_model().scales.time;
    request.end = Time{100.4 * dt};
    request.series = Time{50.2 * dt};
    request.frames = Time{33.4667 * dt};
    run_small(request);
    const std::vector<double> rows{0, 50, 100};
    EXPECT_EQ(read_csv(path("run") / "series.csv").column("step"), rows);
    EXPECT_EQ(FramesReader(path("run") / "frames.h5").count(), 4);
}

TEST_F(GoingOn, what_a_start_leaves_behind_does_not_keep_the_next_one_away) {
    const RunRequest request = small_request(path("run"), 50);
    fs::create_directory(path("run"));
    for (const char* name : {".lock", "run.log", "PROVENANCE.json.tmp"})
        replace_file(path("run") / name, "", Durability::process);
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
}

TEST_F(GoingOn, a_run_killed_before_its_first_checkpoint_says_where_it_begins) {
    EXPECT_NE(describe_status({{"status", "interrupted"}, {"checkpoint_step", -1}})
                  .find("run again; it begins at step 0\n"),
              std::string::npos);
}

TEST_F(GoingOn, results_whose_checkpoints_are_gone_are_not_written_over) {
    RunRequest request = small_request(path("run"), 1000);
    stop_midway(request);
    fs::remove_all(path("run") / "checkpoint");
    const std::string series = read_file(path("run") / "series.csv");
    EXPECT_THROW(run_small(request), DirectoryInUse);
    const std::string told = describe_status(read_status(path("run")));
    EXPECT_NE(told.find("its checkpoint is gone"), std::string::npos) << told;
    EXPECT_EQ(told.find("run again"), std::string::npos) << told;
    for (const char* name : {"status.json", "PROVENANCE.json"}) {
        fs::remove(path("run") / name);
        EXPECT_THROW(run_small(request), DirectoryInUse) << name;
    }
    EXPECT_EQ(read_file(path("run") / "series.csv"), series);
}

TEST_F(GoingOn, a_damaged_provenance_does_not_stop_a_run) {
    run_small(small_request(path("straight"), small_steps));
    const RunRequest request = small_request(path("damaged"), small_steps);
    stop_midway(request);
    const fs::path file = path("damaged") / "PROVENANCE.json";
    for (const char* text : {"{\"name\": ", "[]", "", "{\"sessions\": 1}"}) {
        replace_file(file, text, Durability::process);
        RunRequest piece = request;
        piece.max_time = Time{0.0};
        EXPECT_EQ(run_small(piece).ending, RunOutcome::Ending::stopped);
    }
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    expect_same_results(path("straight"), path("damaged"));
}

}  // namespace
}  // namespace tt
