#include "app/run_pool.hpp"
#include "base/undefined.hpp"
#include "base/tell.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <list>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/case_options.hpp"
#include "app/run_request.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/processors.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/write.hpp"
#include "exchange/periodic.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "observe/failure.hpp"
#include "observe/run_case.hpp"
#include "observe/status.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
using SteadyClock = std::chrono::steady_clock;

double seconds_since(SteadyClock::time_point then) {
    return std::chrono::duration<double>(SteadyClock::now() - then).count();
}

/// Share of a run that is done, from its status.json.
double share_done(const fs::path& directory) {
    const Json status = recorded_status(directory);
    const double steps = number_of(status, "steps", 0.0);
    return steps > 0.0 ? std::min(number_of(status, "step", 0.0) / steps, 1.0) : 0.0;
}

/// A job and what it costs.
struct Task {
    const Job* job = nullptr;
    Choice choice;
    double work = 0.0;   ///< sites times steps
    double bytes = 0.0;  ///< of memory
    double share = 0.0;  ///< done as it started
    int refusals = 0;    ///< by a directory in which another process wrote
    SteadyClock::time_point not_before;
};

int run_job(const Task& task, int threads, const std::string& command_line) {
    const Case& c = task.job->c;
    Model model = discretise(c, task.choice);
    model.threads = threads;
    RunRequest request = request_for(c, task.choice, model);
    request.directory = task.job->directory;
    request.case_toml = to_toml(c);
    request.command_line = command_line;
    request.progress = ProgressMode::none;
    request.start = task.job->start;
    Periodic exchange;
    try {
        const RunOutcome outcome = run_case(
            request, model, [&] { return initial_state(c, model); }, exchange);
        return outcome.ending == RunOutcome::Ending::stopped ? exit_code::stopped_early
                                                             : exit_code::done;
    } catch (const SimulationError&) {
        return exit_code::unstable;  // told by the one who asked, from failure/why.txt
    } catch (const FailedBefore&) {
        return exit_code::unstable;
    }
}

class Pool {
public:
    Pool(std::span<const Job> jobs, const PoolOptions& options);
    ~Pool() { end_all(); }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    bool ended() const { return waiting_.empty() && running_.empty(); }
    void start();
    /// Takes the ends of children. False if one of them ends all: its code is then that of the
    /// pool.
    bool reap(int options);
    /// Asks all children to stop and waits for them.
    void end_all();
    PoolStanding standing() const;
    int code() const { return code_; }

private:
    std::list<Task>::iterator next();
    bool fits(const Task& task) const;
    void fork_run(Task task);
    bool take_end(Task task, int status);
    [[noreturn]] void be_child(const Task& task, pid_t parent) const;

    const PoolOptions& options_;
    const double memory_ = std::min(usable_memory(), free_memory());
    const SteadyClock::time_point begin_ = SteadyClock::now();
    int threads_ = 1;
    int jobs_ = 0;
    std::list<Task> waiting_;
    std::map<pid_t, Task> running_;
    double work_ = 0.0, work_left_ = 0.0;
    int code_ = exit_code::done;
};

Pool::Pool(std::span<const Job> jobs, const PoolOptions& options)
    : options_(options), jobs_(static_cast<int>(jobs.size())) {
    threads_ = std::max(1, usable_processors() / std::max(1, std::min(options.at_once, jobs_)));
    for (const Job& job : jobs) {
        Task task;
        task.job = &job;
        task.choice = job.choice ? *job.choice : choose(job.c);
        task.work = static_cast<double>(task.choice.nx) * task.choice.ny * job.c.time.end.si /
                    task.choice.dt.si;
        task.bytes = expected_bytes(task.choice);
        task.share = job.start == Start::fresh ? 0.0 : share_done(job.directory);
        work_left_ += task.work * (1.0 - task.share);
        waiting_.push_back(std::move(task));
    }
    work_ = work_left_;
}

/// One alone may always try.
bool Pool::fits(const Task& task) const {
    double bytes = task.bytes;
    for (const auto& [process, other] : running_) bytes += other.bytes;
    return running_.empty() || bytes <= memory_;
}

/// The first that can start now. Others go before one whose directory is in use.
std::list<Task>::iterator Pool::next() {
    constexpr auto pause = std::chrono::milliseconds(200);
    const auto now = SteadyClock::now();
    for (auto task = waiting_.begin(); task != waiting_.end(); ++task) {
        if (task->not_before > now) continue;
        if (!is_running(task->job->directory)) return fits(*task) ? task : waiting_.end();
        task->not_before = now + pause;
    }
    return waiting_.end();
}

void Pool::start() {
    while (static_cast<int>(running_.size()) < options_.at_once) {
        const auto task = next();
        if (task == waiting_.end()) return;
        Task started = std::move(*task);
        waiting_.erase(task);
        fork_run(std::move(started));
    }
}

void Pool::fork_run(Task task) {
    make_directory(task.job->directory.parent_path());
    std::fflush(nullptr);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0) throw IoError("cannot start another process");
    if (child == 0) be_child(task, parent);
    running_[child] = std::move(task);
}

/// What the child process does, and how it ends: with an exit code, whatever happens.
void Pool::be_child(const Task& task, pid_t parent) const {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(exit_code::stopped_early);
    setpgid(0, 0);  // Ctrl-C reaches the parent only, which asks once
    if (options_.in_child) options_.in_child();
    const int threads = std::min(threads_, choose_threads(0, task.job->c, task.choice).threads);
    const int code = perform([&] { return run_job(task, threads, options_.command_line); });
    std::fflush(nullptr);
    _exit(code);
}

bool Pool::reap(int options) {
    for (auto child = running_.begin(); child != running_.end();) {
        // Each child by its own number: others of this process are none of ours.
        int status = 0;
        if (waitpid(child->first, &status, options) != child->first) {
            ++child;
            continue;
        }
        Task task = std::move(child->second);
        child = running_.erase(child);
        if (!take_end(std::move(task), status)) return false;
    }
    return true;
}

bool Pool::take_end(Task task, int status) {
    constexpr int most_refusals = 3;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : exit_code::internal;
    const bool in_use = code == exit_code::directory_in_use;
    if (in_use && (is_running(task.job->directory) || ++task.refusals < most_refusals)) {
        waiting_.push_back(std::move(task));
        return true;
    }
    work_left_ -= task.work * (1.0 - task.share);
    if (!WIFEXITED(status))
        tell_user("tanktread: the run in '{}' was ended by signal {}\n",
                  task.job->directory.string(), WTERMSIG(status));
    if (options_.ended) options_.ended(*task.job, code);
    if (code == exit_code::done || code == exit_code::unstable) return true;
    code_ = code;
    return code != exit_code::stopped_early && code != exit_code::input_output;
}

void Pool::end_all() {
    for (const auto& [child, task] : running_) kill(child, SIGTERM);
    const int code = code_;
    while (!running_.empty()) reap(0);
    code_ = code;  // what they say to being stopped is nobody's fault
}

PoolStanding Pool::standing() const {
    double left = work_left_;
    for (const auto& [process, task] : running_)
        left -= task.work * std::max(share_done(task.job->directory) - task.share, 0.0);
    PoolStanding now;
    now.running = static_cast<int>(running_.size());
    now.waiting = static_cast<int>(waiting_.size());
    now.ended = jobs_ - now.running - now.waiting;
    now.seconds_left = work_ > left ? left * seconds_since(begin_) / (work_ - left) : undefined;
    return now;
}

}  // namespace

JobEnd end_of(const fs::path& directory) {
    if (has_summary(directory)) return JobEnd::done;
    return has_failed(directory) ? JobEnd::unstable : JobEnd::none;
}

std::string failure_of(const fs::path& directory) {
    const fs::path why = directory / "failure" / "why.txt";
    if (!fs::exists(why)) return "it failed";
    const std::string text = read_file(why);
    return text.substr(0, text.find('\n'));
}

double expected_bytes(const Choice& choice) {
    constexpr double per_site = 300.0, program = 3e7;  // 257 a site were measured
    return program + per_site * choice.nx * choice.ny;
}

int run_side_by_side(std::span<const Job> jobs, const PoolOptions& options) {
    catch_stop_signals();
    const auto begin = SteadyClock::now();
    auto shown = begin;
    Pool pool(jobs, options);
    while (!pool.ended()) {
        if (stop_requested() || seconds_since(begin) >= options.max_seconds) {
            pool.end_all();
            return exit_code::stopped_early;
        }
        pool.start();
        if (!pool.reap(WNOHANG)) {
            pool.end_all();
            return pool.code();
        }
        if (options.show && seconds_since(shown) >= options.interval) {
            options.show(pool.standing());
            shown = SteadyClock::now();
        }
        constexpr auto nap = std::chrono::milliseconds(5);
        if (!pool.ended()) std::this_thread::sleep_for(nap);
    }
    return pool.code();
}

}  // namespace tt
