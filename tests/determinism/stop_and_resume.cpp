#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <string>
#include <thread>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/random.hpp"
#include "io/archive.hpp"
#include "io/frames.hpp"
#include "io/json.hpp"
#include "simulation/stop.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

class StopAndResume : public TemporaryDirectory {
protected:
    StopAndResume() { clear_stop_request(); }
    ~StopAndResume() override { clear_stop_request(); }
};

/// Runs `work` in a process of its own; its exit status, or −signal.
template <class Work>
pid_t in_a_child(Work work) {
    const pid_t child = fork();
    if (child != 0) return child;
    int code = 0;
    try {
        work();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        code = 5;
    }
    _exit(code);
}

int ending_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

void expect_same_results(const fs::path& a, const fs::path& b) {
    EXPECT_EQ(read_json(a / "PROVENANCE.json")["state_hash"],
              read_json(b / "PROVENANCE.json")["state_hash"]);
    for (const char* name : {"series.csv", "cells.csv", "profiles.csv"}) {
        EXPECT_EQ(read_file(a / name), read_file(b / name)) << name;
    }
    const FramesReader of_a(a / "frames.h5");
    const FramesReader of_b(b / "frames.h5");
    ASSERT_EQ(of_a.count(), of_b.count());
    for (int k = 0; k < of_a.count(); ++k) {
        const Frame x = of_a.frame(k);
        const Frame y = of_b.frame(k);
        EXPECT_EQ(x.step, y.step);
        EXPECT_EQ(x.nodes, y.nodes);
        EXPECT_EQ(x.node_force, y.node_force);
        EXPECT_EQ(x.velocity, y.velocity);
        EXPECT_EQ(x.pressure, y.pressure);
        EXPECT_EQ(x.cytoplasm, y.cytoplasm);
    }
}

/// They take a tenth of a second and more; stops come after 20 to 50 ms.
constexpr std::int64_t steps = 6001;

TEST_F(StopAndResume, a_run_that_is_killed_again_and_again_ends_like_one_that_is_not) {
    // A hundred on demand: TANKTREAD_KILLS=100 test_determinism --gtest_filter='*killed*'
    const char* const asked = std::getenv("TANKTREAD_KILLS");
    const int kills = asked ? std::atoi(asked) : 8;
    const std::int64_t long_enough = 150 * kills + 1;
    const auto begin = std::chrono::steady_clock::now();
    run_small(small_request(path("straight"), long_enough));
    const double whole =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

    RunRequest request = small_request(path("killed"), long_enough);
    request.checkpoint = Time{whole / (5 * kills)};
    Random random(7);
    int killed = 0;
    for (;;) {
        const pid_t child = in_a_child([&] { run_small(request); });
        if (killed < kills) {
            std::this_thread::sleep_for(
                std::chrono::duration<double>(random.uniform(0.0, 2.0 * whole / kills)));
            kill(child, SIGKILL);
        }
        const int ending = ending_of(child);
        if (ending == 0) break;
        ASSERT_EQ(ending, -SIGKILL);
        ++killed;
    }
    std::printf("%d kills\n", killed);
    EXPECT_GT(killed, 0);
    expect_same_results(path("straight"), path("killed"));
}

TEST_F(StopAndResume, a_signal_stops_cleanly_and_the_next_call_goes_on) {
    run_small(small_request(path("straight"), steps));
    const RunRequest request = small_request(path("stopped"), steps);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU}) {
        const pid_t child = in_a_child([&] {
            const bool stopped = run_small(request).ending == RunOutcome::Ending::stopped;
            _exit(stopped ? 75 : 0);
        });
        // The handlers are in place once the run log is there.
        while (!fs::exists(path("stopped") / "checkpoint/current")) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        const auto asked = std::chrono::steady_clock::now();
        kill(child, signal);
        EXPECT_EQ(ending_of(child), 75);
        EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(1));
    }
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    expect_same_results(path("straight"), path("stopped"));
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::was_done);
}

/// As GNU parallel (TERM at 0, 0.2 and 0.3 s) and srun at its time limit do.
TEST_F(StopAndResume, signals_that_come_again_only_ask_again) {
    const pid_t child = in_a_child([] {
        catch_stop_signals();
        for (const int signal : {SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGINT}) {
            for (int time = 0; time < 3; ++time) std::raise(signal);
        }
        _exit(stop_requested() ? 75 : 1);
    });
    EXPECT_EQ(ending_of(child), 75);
}

TEST_F(StopAndResume, a_second_interrupt_a_second_later_ends_the_process_at_once) {
    const pid_t child = in_a_child([] {
        catch_stop_signals();
        std::raise(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds(1050));
        std::raise(SIGTERM);
        std::raise(SIGINT);
        _exit(2);
    });
    EXPECT_EQ(ending_of(child), -SIGINT);
}

TEST_F(StopAndResume, a_hang_up_that_the_caller_ignores_stays_ignored) {
    const pid_t child = in_a_child([] {
        std::signal(SIGHUP, SIG_IGN);
        catch_stop_signals();
        std::raise(SIGHUP);
        _exit(stop_requested() ? 1 : 0);
    });
    EXPECT_EQ(ending_of(child), 0);
}

TEST_F(StopAndResume, the_time_limit_stops_and_every_piece_adds_up) {
    run_small(small_request(path("straight"), steps));
    RunRequest request = small_request(path("pieces"), steps);
    request.max_time = Time{0.03};
    int pieces = 1;
    while (run_small(request).ending == RunOutcome::Ending::stopped && pieces < 10000) ++pieces;
    EXPECT_GT(pieces, 1);
    ASSERT_LT(pieces, 10000) << "every piece stops: has this process been asked to stop?";
    expect_same_results(path("straight"), path("pieces"));
    EXPECT_EQ(read_json(path("pieces") / "PROVENANCE.json")["sessions"].size(),
              static_cast<std::size_t>(pieces));
    const Json whole = read_json(path("straight") / "summary.json");
    const Json sum = read_json(path("pieces") / "summary.json");
    EXPECT_EQ(whole["lambda_C"], sum["lambda_C"]);
    EXPECT_EQ(whole["mu_rel"], sum["mu_rel"]);
}

/// Stops after the first checkpoints, so that current and previous exist.
void stop_midway(RunRequest request) {
    request.max_time = Time{0.0};
    run_small(request);
    request.max_time = Time{0.03};
    ASSERT_EQ(run_small(request).ending, RunOutcome::Ending::stopped);
    request.max_time = Time{0.02};
    ASSERT_EQ(run_small(request).ending, RunOutcome::Ending::stopped);
}

TEST_F(StopAndResume, a_damaged_checkpoint_is_passed_over_for_the_previous_one) {
    run_small(small_request(path("straight"), steps));
    const RunRequest request = small_request(path("damaged"), steps);
    stop_midway(request);
    const fs::path current = path("damaged") / "checkpoint/current";
    std::string bytes = read_file(current);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    replace_file(current, bytes, Durability::process);
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    expect_same_results(path("straight"), path("damaged"));
    EXPECT_NE(read_file(path("damaged") / "run.log").find("checksum does not match"),
              std::string::npos);
}

TEST_F(StopAndResume, without_any_sound_checkpoint_nothing_is_overwritten) {
    const RunRequest request = small_request(path("damaged"), steps);
    stop_midway(request);
    for (const char* name : {"current", "previous"}) {
        const fs::path file = path("damaged") / "checkpoint" / name;
        replace_file(file, read_file(file).substr(0, 1000), Durability::process);
    }
    const std::string series = read_file(path("damaged") / "series.csv");
    EXPECT_THROW(run_small(request), DamagedArchive);
    EXPECT_EQ(read_file(path("damaged") / "series.csv"), series);
}

TEST_F(StopAndResume, a_full_disk_destroys_nothing_and_the_run_goes_on_with_more_room) {
    run_small(small_request(path("straight"), steps));
    RunRequest request = small_request(path("full"), steps);
    request.checkpoint = Time{0.01};
    int failures = 0;
    // Sizes at which first a checkpoint, then a table does not fit.
    for (const rlim_t limit : {2000, 30000, 60000, 75000, 90000}) {
        const pid_t child = in_a_child([&] {
            const rlimit size{limit, RLIM_INFINITY};
            setrlimit(RLIMIT_FSIZE, &size);
            run_small(request);
        });
        const int ending = ending_of(child);
        EXPECT_TRUE(ending == 0 || ending == 5) << ending;
        failures += ending == 5 ? 1 : 0;
    }
    EXPECT_GE(failures, 2);
    run_small(request);
    expect_same_results(path("straight"), path("full"));
}

/// People delete checkpoint/, the largest part of what is finished.
TEST_F(StopAndResume, finished_results_without_a_checkpoint_are_left_as_they_are) {
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

TEST_F(StopAndResume, two_runs_never_write_to_one_directory) {
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

TEST_F(StopAndResume, results_of_another_case_and_foreign_files_are_left_alone) {
    RunRequest request = small_request(path("run"), 50);
    run_small(request);
    const std::string series = read_file(path("run") / "series.csv");
    request.resolved_toml += "other = true\n";
    EXPECT_THROW(run_small(request), DirectoryInUse);
    EXPECT_EQ(read_file(path("run") / "series.csv"), series);
    request.start = Start::fresh;
    run_small(request);
    EXPECT_EQ(read_file(path("run.1") / "series.csv"), series);

    fs::create_directory(path("thesis"));
    replace_file(path("thesis") / "chapter1.tex", "...", Durability::process);
    request.directory = path("thesis");
    EXPECT_THROW(run_small(request), DirectoryInUse);
}

}  // namespace
}  // namespace tt
