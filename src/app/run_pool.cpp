#include "app/run_pool.hpp"
#include "base/tell.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <limits>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/run_request.hpp"
#include "app/verb.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/write.hpp"
#include "exchange/periodic.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "observe/run_case.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
using SteadyClock = std::chrono::steady_clock;

int run_job(const Job& job, const std::string& command_line) {
    const Choice choice = choose(job.c);
    const Model model = discretise(job.c, choice);
    RunRequest request = request_for(job.c, choice, model);
    request.directory = job.directory;
    request.case_toml = to_toml(job.c);
    request.command_line = command_line;
    request.progress = ProgressMode::none;
    Periodic exchange;
    try {
        const RunOutcome outcome = run_case(
            request, model, [&] { return initial_state(job.c, model); }, exchange);
        return outcome.ending == RunOutcome::Ending::stopped ? exit_code::stopped_early
                                                             : exit_code::done;
    } catch (const SimulationError&) {
        return exit_code::unstable;  // told by the one who asked, from failure/why.txt
    }
}

/// What the child process does, and how it ends: with an exit code, whatever happens.
[[noreturn]] void be_child(const Job& job, const std::string& command_line, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(exit_code::stopped_early);
    setpgid(0, 0);  // Ctrl-C reaches the parent only, which asks once
    const int code = perform([&] { return run_job(job, command_line); });
    std::fflush(nullptr);
    _exit(code);
}

double work_of(const Case& c) {
    const Choice choice = choose(c);
    return static_cast<double>(choice.nx) * choice.ny * c.time.end.si / choice.dt.si;
}

/// Share of a run that is done, from its status.json.
double share_done(const fs::path& directory) {
    try {
        const Json status = read_json(directory / "status.json");
        return status.at("step").get<double>() / status.at("steps").get<double>();
    } catch (const std::exception&) {
        return 0.0;  // not there yet
    }
}

class Pool {
public:
    Pool(std::span<const Job> jobs, const std::string& command_line)
        : jobs_(jobs), command_line_(command_line), begin_(SteadyClock::now()) {
        for (std::size_t k = 0; k < jobs.size(); ++k) {
            if (end_of(jobs[k].directory) == JobEnd::none) {
                waiting_.push_back(k);
                work_left_ += work_of(jobs[k].c) * (1.0 - share_done(jobs[k].directory));
            }
        }
        std::reverse(waiting_.begin(), waiting_.end());
        work_ = work_left_;
    }
    ~Pool() { end_all(); }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    bool ended() const { return waiting_.empty() && running_.empty(); }
    void start(int at_once);
    /// Takes the ends of children. The exit code of one that went wrong, or done.
    int reap(int options);
    /// Asks all children to stop and waits for them.
    void end_all();
    PoolStanding standing() const;

private:
    struct Child {
        std::size_t job = 0;
        double share = 0.0;  ///< done as it started
    };
    std::span<const Job> jobs_;
    const std::string& command_line_;
    SteadyClock::time_point begin_;
    std::vector<std::size_t> waiting_;
    std::map<pid_t, Child> running_;
    double work_ = 0.0, work_left_ = 0.0;
};

void Pool::start(int at_once) {
    while (!waiting_.empty() && static_cast<int>(running_.size()) < at_once) {
        const Job& job = jobs_[waiting_.back()];
        make_directory(job.directory.parent_path());
        const double share = share_done(job.directory);
        std::fflush(nullptr);
        const pid_t parent = getpid();
        const pid_t child = fork();
        if (child < 0) throw IoError("cannot start another process");
        if (child == 0) be_child(job, command_line_, parent);
        running_[child] = {waiting_.back(), share};
        waiting_.pop_back();
    }
}

int Pool::reap(int options) {
    int status = 0;
    while (!running_.empty()) {
        // Each child by its own number: others of this process are none of ours.
        pid_t ended = 0;
        for (const auto& [child, what] : running_) {
            if (waitpid(child, &status, options) == child) {
                ended = child;
                break;
            }
        }
        if (ended == 0) return exit_code::done;
        const Child child = running_[ended];
        running_.erase(ended);
        work_left_ -= work_of(jobs_[child.job].c) * (1.0 - child.share);
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : exit_code::internal;
        if (!WIFEXITED(status))
            tell_user("tanktread: the run in '{}' was ended by signal {}\n",
                      jobs_[child.job].directory.string(), WTERMSIG(status));
        if (code != exit_code::done && code != exit_code::unstable) return code;
    }
    return exit_code::done;
}

void Pool::end_all() {
    for (const auto& [child, what] : running_) kill(child, SIGTERM);
    while (!running_.empty()) reap(0);
}

PoolStanding Pool::standing() const {
    double left = work_left_;
    for (const auto& [process, child] : running_) {
        const Job& job = jobs_[child.job];
        left -= work_of(job.c) * std::max(share_done(job.directory) - child.share, 0.0);
    }
    const double seconds = std::chrono::duration<double>(SteadyClock::now() - begin_).count();
    PoolStanding now;
    now.runs = static_cast<int>(jobs_.size());
    now.done = now.runs - static_cast<int>(waiting_.size() + running_.size());
    now.seconds_left =
        work_ > left ? left * seconds / (work_ - left) : std::numeric_limits<double>::quiet_NaN();
    return now;
}

}  // namespace

JobEnd end_of(const fs::path& directory) {
    if (fs::exists(directory / "summary.json")) return JobEnd::done;
    if (!fs::exists(directory / "status.json")) return JobEnd::none;
    const Json status = read_json(directory / "status.json");
    return status.value("status", std::string()) == "failed" ? JobEnd::unstable : JobEnd::none;
}

std::string failure_of(const fs::path& directory) {
    const fs::path why = directory / "failure" / "why.txt";
    if (!fs::exists(why)) return "it failed";
    const std::string text = read_file(why);
    return text.substr(0, text.find('\n'));
}

int run_side_by_side(std::span<const Job> jobs, int at_once, const std::string& command_line,
                     double interval, const std::function<void(const PoolStanding&)>& show) {
    catch_stop_signals();
    Pool pool(jobs, command_line);
    auto shown = SteadyClock::now();
    while (!pool.ended()) {
        if (stop_requested()) {
            pool.end_all();
            return exit_code::stopped_early;
        }
        pool.start(at_once);
        const int code = pool.reap(WNOHANG);
        if (code != exit_code::done) {
            pool.end_all();
            return code;
        }
        if (std::chrono::duration<double>(SteadyClock::now() - shown).count() >= interval) {
            show(pool.standing());
            shown = SteadyClock::now();
        }
        constexpr auto nap = std::chrono::milliseconds(5);
        if (!pool.ended()) std::this_thread::sleep_for(nap);
    }
    return exit_code::done;
}

}  // namespace tt
