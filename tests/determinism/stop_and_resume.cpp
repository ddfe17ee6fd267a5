#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/random.hpp"
#include "io/archive.hpp"
#include "io/checksum.hpp"
#include "io/csv.hpp"
#include "io/frames.hpp"
#include "io/json.hpp"
#include "observe/status.hpp"
#include "runs.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

using StopAndResume = RunsTest;

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
    constexpr std::int64_t long_enough = 3 * small_steps;
    run_small(small_request(path("straight"), long_enough));
    const RunRequest request = small_request(path("stopped"), long_enough);
    const fs::path log = path("stopped") / "run.log";
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU}) {
        const auto logged = fs::exists(log) ? fs::file_size(log) : 0;
        const pid_t child = in_a_child([&] {
            const bool stopped = run_small(request).ending == RunOutcome::Ending::stopped;
            _exit(stopped ? 75 : 0);
        });
        // The handlers are in place once the run has logged something.
        const auto hears = [&] {
            return fs::exists(path("stopped") / "checkpoint/current") && fs::exists(log) &&
                   fs::file_size(log) > logged;
        };
        for (int wait = 0; wait < 20'000 && !hears(); ++wait)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
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
        for (const int signal : {SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGALRM, SIGVTALRM,
                                 SIGPROF, SIGPWR, SIGINT}) {
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
    run_small(small_request(path("straight"), small_steps));
    RunRequest request = small_request(path("pieces"), small_steps);
    request.max_time = Time{0.03};
    int pieces = 1;
    for (; run_small(request).ending == RunOutcome::Ending::stopped; ++pieces) {
        ASSERT_FALSE(stop_requested()) << "this process has been asked to stop";
        request.max_time->si *= 1.2;  // on a machine where 30 ms are spent on starting, too
    }
    EXPECT_GT(pieces, 1);
    expect_same_results(path("straight"), path("pieces"));
    EXPECT_EQ(read_json(path("pieces") / "PROVENANCE.json")["sessions"].size(),
              static_cast<std::size_t>(pieces));
    const Json whole = read_json(path("straight") / "summary.json");
    const Json sum = read_json(path("pieces") / "summary.json");
    EXPECT_EQ(whole["lambda_C"], sum["lambda_C"]);
    EXPECT_EQ(whole["mu_rel"], sum["mu_rel"]);
}

TEST_F(StopAndResume, a_damaged_checkpoint_is_passed_over_for_the_previous_one) {
    run_small(small_request(path("straight"), small_steps));
    const RunRequest request = small_request(path("damaged"), small_steps);
    stop_midway(request);
    const fs::path current = path("damaged") / "checkpoint/current";
    std::string bytes = read_file(current);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    replace_file(current, bytes, Durability::process);
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    expect_same_results(path("straight"), path("damaged"));
    EXPECT_NE(read_file(path("damaged") / "run.log").find("checksum does not match"),
              std::string::npos);
    EXPECT_TRUE(fs::exists(path("damaged") / "checkpoint/damaged"))
        << "else the next save makes it the previous one";
}

TEST_F(StopAndResume, a_checkpoint_that_cannot_be_read_is_passed_over_for_the_previous_one) {
    run_small(small_request(path("straight"), small_steps));
    const RunRequest request = small_request(path("unreadable"), small_steps);
    stop_midway(request);
    const fs::path current = path("unreadable") / "checkpoint/current";
    fs::remove(current);
    fs::create_directory(current);  // cannot be read, by whoever runs the test
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    expect_same_results(path("straight"), path("unreadable"));
    EXPECT_NE(read_file(path("unreadable") / "run.log").find("cannot read"), std::string::npos);
}

TEST_F(StopAndResume, without_any_sound_checkpoint_nothing_is_overwritten) {
    const RunRequest request = small_request(path("damaged"), small_steps);
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
    run_small(small_request(path("straight"), small_steps));
    RunRequest request = small_request(path("full"), small_steps);
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

/// The archive with the first element of a section, of eight bytes each, made another or taken out.
template <class T>
void forge(const fs::path& path, const std::string& section, std::optional<T> value) {
    std::string bytes = read_file(path);
    bytes.resize(bytes.size() - sizeof(std::uint64_t));
    const std::size_t count =
        bytes.find(section + (std::is_same_v<T, double> ? 'd' : 'l')) + section.size() + 1;
    const std::size_t element = count + sizeof(std::uint64_t);
    if (value) {
        bytes.replace(element, sizeof *value, reinterpret_cast<const char*>(&*value),
                      sizeof *value);
    } else {
        std::uint64_t number = 0;
        std::memcpy(&number, bytes.data() + count, sizeof number);
        --number;
        bytes.replace(count, sizeof number, reinterpret_cast<const char*>(&number), sizeof number);
        bytes.erase(element, sizeof(T));
    }
    const std::uint64_t sum = checksum(bytes);
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    replace_file(path, bytes, Durability::process);
}

/// What a checkpoint holds is looked at before anything is done by it.
TEST_F(StopAndResume, a_checkpoint_with_forged_numbers_is_passed_over) {
    const RunRequest request = small_request(path("forged"), small_steps);
    stop_midway(request);
    const fs::path current = path("forged") / "checkpoint/current";
    fs::copy(path("forged"), path("sound"), fs::copy_options::recursive);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    using Whole = std::int64_t;
    const std::vector<std::function<void()>> forgeries{
        [&] { forge<double>(current, "series.interval", 0.0); },
        [&] { forge<double>(current, "series.interval", inf); },
        [&] { forge<double>(current, "frames.interval", nan); },
        [&] { forge<double>(current, "frames.interval", -1.0); },
        [&] { forge<double>(current, "wall_seconds", nan); },
        [&] { forge<double>(current, "series.last_time", inf); },
        [&] { forge<double>(current, "series.phase", std::nullopt); },
        [&] { forge<double>(current, "series.last_rate", std::nullopt); },
        [&] { forge<double>(current, "frames.time", nan); },
        [&] { forge<double>(current, "frames.time", std::nullopt); },
        [&] { forge<Whole>(current, "frames.step", std::nullopt); },
        [&] { forge<Whole>(current, "frames.step", -4); },
        // The state itself, which is examined as after every hundred steps.
        [&] { forge<double>(current, "populations.3", nan); },
        [&] { forge<double>(current, "populations.1", 7.0); },
    };
    for (std::size_t k = 0; k < forgeries.size(); ++k) {
        fs::remove_all(path("forged"));
        fs::copy(path("sound"), path("forged"), fs::copy_options::recursive);
        forgeries[k]();
        RunRequest further = request;
        further.max_time = Time{0.0};
        EXPECT_EQ(run_small(further).ending, RunOutcome::Ending::stopped) << k;
        EXPECT_TRUE(fs::exists(path("forged") / "checkpoint/damaged")) << k;
    }
}

/// Sound as a file, with a right checksum: it counts as damaged none the less.
TEST_F(StopAndResume, a_checkpoint_with_impossible_content_is_passed_over) {
    run_small(small_request(path("straight"), small_steps));
    const RunRequest request = small_request(path("forged"), small_steps);
    stop_midway(request);
    const fs::path current = path("forged") / "checkpoint/current";
    const ArchiveReader whole(current);
    ArchiveWriter forged(current);
    forged.put_text("version", "0.0");
    forged.put_text("settings", request.settings);
    forged.put_value("step", whole.value<std::int64_t>("step"));
    forged.commit();
    EXPECT_EQ(run_small(request).ending, RunOutcome::Ending::done);
    expect_same_results(path("straight"), path("forged"));
    EXPECT_TRUE(fs::exists(path("forged") / "checkpoint/damaged"));
}

}  // namespace
}  // namespace tt
