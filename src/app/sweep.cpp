#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/case_options.hpp"
#include "app/run_pool.hpp"
#include "app/run_request.hpp"
#include "app/sweep_directory.hpp"
#include "app/sweep_options.hpp"
#include "app/sweep_runs.hpp"
#include "app/sweep_scripts.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/processors.hpp"
#include "base/tell.hpp"
#include "observe/progress.hpp"
#include "report/sweep_page.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// One sweep, from its plan to its table.
class Sweep {
public:
    Sweep(SweepOptions options, const std::string& command_line)
        : options_(std::move(options)),
          plan_(read_plan(options_)),
          path_(options_.directory ? fs::path(*options_.directory)
                                   : fs::path("results") / plan_.name),
          progress_(progress_mode(options_.progress)) {
        if (options_.list + options_.gather + options_.parallel + options_.slurm > 1)
            throw CommandError("give one of --list, --gather, --parallel and --slurm");
        if (options_.retry && (options_.parallel || options_.slurm))
            throw CommandError(
                "--retry is for runs of this program; give it without --parallel or --slurm");
        if (path_.empty()) throw CommandError("-o needs the name of a directory");
        pool_.at_once = options_.jobs > 0 ? options_.jobs : usable_processors();
        pool_.command_line = command_line;
        if (options_.max_time)
            pool_.max_seconds = parse_duration("--max-time", *options_.max_time).si;
    }

    int run();

private:
    void list() const;
    std::function<void(int)> looking_at(std::string what, std::size_t all);
    std::vector<const SweepRun*> open() const;
    std::vector<Job> jobs() const;
    int hand_over();
    int count(RunEnding ending) const;
    void show(const PoolStanding& now);
    void note(const Job& job, int code);
    void write();
    int tell_outcome(int code);

    SweepOptions options_;
    SweepPlan plan_;
    fs::path path_;
    Progress progress_;
    PoolOptions pool_;
    std::vector<SweepRun> runs_;
    int done_before_ = 0, failed_ = 0;
    std::chrono::steady_clock::time_point write_after_;
};

int Sweep::count(RunEnding ending) const {
    return static_cast<int>(std::count_if(
        runs_.begin(), runs_.end(), [&](const SweepRun& run) { return ending_of(run) == ending; }));
}

void Sweep::list() const {
    for (const SweptRun& run : record_of(plan_, runs_, path_).runs)
        fmt::print("{:<8} {}{}\n", word_of(run.ending), run.name,
                   run.directory == fs::path("runs") / run.name
                       ? ""
                       : fmt::format("  (found: {})",
                                     (path_ / run.directory).lexically_normal().string()));
}

/// Shows how many cases were looked at, now and then.
std::function<void(int)> Sweep::looking_at(std::string what, std::size_t all) {
    auto shown = std::chrono::steady_clock::now();
    return [this, what = std::move(what), all, shown](int cases) mutable {
        const auto now = std::chrono::steady_clock::now();
        if (std::chrono::duration<double>(now - shown).count() < progress_.interval()) return;
        shown = now;
        progress_.show(fmt::format("{} of {} {}", cases, all, what),
                       Json{{"step", what}, {"cases", cases}, {"of", all}}.dump());
    };
}

/// Those that are not done, nor failed before unless they are to be tried again.
std::vector<const SweepRun*> Sweep::open() const {
    std::vector<const SweepRun*> open;
    for (const SweepRun& run : runs_) {
        const RunEnding ending = ending_of(run);
        if (ending == RunEnding::done || (ending == RunEnding::failed && !options_.retry)) continue;
        open.push_back(&run);
    }
    return open;
}

std::vector<Job> Sweep::jobs() const {
    std::vector<Job> jobs;
    for (const SweepRun* run : open()) {
        const bool failed = ending_of(*run) == RunEnding::failed;
        jobs.push_back(
            {run->directory, run->plan->c, failed ? Start::fresh : Start::resume, run->choice});
    }
    return jobs;
}

/// To engines of others: writes what they need and prints the lines to type.
int Sweep::hand_over() {
    constexpr double hour = 3600.0;
    const std::vector<const SweepRun*> left = open();
    write();
    if (left.empty()) {
        progress_.say("there is nothing to run");
        return exit_code::done;
    }
    const double seconds = options_.max_time ? pool_.max_seconds : hour;
    fmt::print("{}", options_.slurm ? write_slurm(plan_, left, path_,
                                                  static_cast<int>(std::ceil(seconds / 60.0)))
                                    : write_parallel(plan_, left, path_, pool_.at_once));
    std::fflush(stdout);  // before what goes to stderr
    if (options_.parallel) tell_user("after it: tanktread sweep {} --gather\n", path_.string());
    return exit_code::done;
}

void Sweep::show(const PoolStanding& now) {
    const int done = done_before_ + now.ended;
    progress_.show(
        fmt::format("{} of {} done, {} running, {} waiting, {} failed, {} left", done - failed_,
                    runs_.size(), now.running, now.waiting, failed_, clock_text(now.seconds_left)),
        Json{{"done", done - failed_},
             {"runs", runs_.size()},
             {"running", now.running},
             {"waiting", now.waiting},
             {"failed", failed_},
             {"seconds_left", now.seconds_left}}
            .dump());
}

/// The table is written as runs end, but not all the time.
void Sweep::note(const Job& job, int code) {
    if (code == exit_code::unstable) {
        ++failed_;
        progress_.say(fmt::format("{} failed: {}", job.directory.filename().string(),
                                  failure_of(job.directory)));
    }
    if (std::chrono::steady_clock::now() > write_after_) write();
}

/// The next not before twenty times as long has passed as this one took.
void Sweep::write() {
    const auto begin = std::chrono::steady_clock::now();
    write_sweep(path_, record_of(plan_, runs_, path_));
    const auto end = std::chrono::steady_clock::now();
    write_after_ =
        end + std::max<std::chrono::nanoseconds>(20 * (end - begin), std::chrono::seconds(5));
}

int Sweep::tell_outcome(int code) {
    const SweepRecord record = record_of(plan_, runs_, path_);
    fmt::print("{}\n", path_.string());
    std::fflush(stdout);  // before what goes to stderr
    if (progress_mode(options_.progress) != ProgressMode::json) {
        tell_user("{}", describe_sweep(record));
        if (code != exit_code::done)
            tell_user("{}the same command goes on\n",
                      code == exit_code::stopped_early ? "stopped; " : "");
        if (count(RunEnding::failed) > 0)
            tell_user("runs that failed are left as they are; --retry begins them anew\n");
    }
    if (code != exit_code::done) return code;
    return count(RunEnding::failed) > 0 ? exit_code::unstable : exit_code::done;
}

int Sweep::run() {
    SweepDirectory::expect_sweep(path_);
    catch_stop_signals();
    runs_ = locate_runs(plan_, path_, options_.fresh ? Found::ignored : Found::used,
                        looking_at("cases looked at", plan_.runs.size()));
    if (options_.list) {
        list();
        return exit_code::done;
    }
    if (!options_.gather)
        judge_new_runs(runs_, looking_at("starts judged", count(RunEnding::waiting)));
    SweepDirectory directory(path_, plan_, options_.fresh ? Start::fresh : Start::resume);
    if (!directory.moved_to().empty())
        progress_.say(fmt::format("moved the former sweep to '{}'", directory.moved_to().string()));
    if (options_.parallel || options_.slurm) return hand_over();
    const std::vector<Job> jobs = options_.gather ? std::vector<Job>{} : this->jobs();
    done_before_ = static_cast<int>(runs_.size() - jobs.size());
    failed_ = options_.retry ? 0 : count(RunEnding::failed);
    write();
    if (!jobs.empty())
        progress_.say(fmt::format("'{}': {} runs, {} to do, {} at once", plan_.name, runs_.size(),
                                  jobs.size(), std::min<std::size_t>(jobs.size(), pool_.at_once)));
    pool_.interval = progress_.interval();
    pool_.show = [this](const PoolStanding& now) { show(now); };
    pool_.ended = [this](const Job& job, int code) { note(job, code); };
    pool_.in_child = [&] { directory.leave_to_parent(); };
    const int code = run_side_by_side(jobs, pool_);
    write();
    write_sweep_page(path_);
    return tell_outcome(code);
}

}  // namespace

void add_sweep(CLI::App& app, Action& action, const std::string& command_line) {
    auto options = std::make_shared<SweepOptions>();
    CLI::App* verb = app.add_subcommand("sweep", "run a case over values of its keys");
    add_sweep_options(*verb, *options);
    verb->callback([options, &action, &command_line] {
        action = [options, &command_line] { return Sweep(*options, command_line).run(); };
    });
}

}  // namespace tt
