#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "app/case_options.hpp"
#include "app/layout_progress.hpp"
#include "base/tell.hpp"
#include "app/run_request.hpp"
#include "app/verb.hpp"
#include "base/units.hpp"
#include "case/cures.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "exchange/periodic.hpp"
#include "io/file.hpp"
#include "observe/run_case.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
    CaseOptions given;
    std::string directory;
    std::string max_time, until;
    std::string progress = "auto";
    bool fresh = false;
};

int tell_outcome(const RunOutcome& outcome, const RunRequest& request) {
    const std::string directory = request.directory.string();
    switch (outcome.ending) {
        case RunOutcome::Ending::done:
            fmt::print("{}\n", directory);
            std::fflush(stdout);  // before what goes to stderr
            tell_user("next:  tanktread report {}\n", directory);
            return exit_code::done;
        case RunOutcome::Ending::was_done:
            fmt::print("{}\n", directory);
            std::fflush(stdout);
            tell_user("{} is finished, {} steps; --fresh begins anew and keeps it beside\n",
                      directory, outcome.steps);
            return exit_code::done;
        case RunOutcome::Ending::stopped:
            break;
    }
    tell_user("next:  tanktread resume {}\n", directory);
    return exit_code::stopped_early;
}

int run(const RunOptions& options, const std::string& command_line) {
    const Case c = read_given_case(options.given);
    const Choice choice = choose(c);
    Model model = discretise(c, choice);
    model.threads = thread_count(options.given.threads, model.lattice);
    RunRequest request = request_for(c, choice, model);
    request.directory =
        options.directory.empty() ? fs::path("results") / c.name : fs::path(options.directory);
    request.case_toml = read_file(options.given.path);
    request.command_line = command_line;
    request.progress = progress_mode(options.progress);
    request.start = options.fresh ? Start::fresh : Start::resume;
    if (!options.max_time.empty())
        request.max_time = parse_duration("--max-time", options.max_time);
    if (!options.until.empty()) {
        const Time until = parse_time("--until", options.until);
        if (until > c.time.end)
            throw CommandError(fmt::format("--until {} is beyond the end of the case, {}",
                                           options.until, to_text(c.time.end)));
        request.until = until;
    }
    request.remedies = [&] { return cures(c, model.threads); };
    Periodic exchange;
    const RunOutcome outcome = run_case(
        request, model, [&] { return initial_state(c, model, layout_progress(request.progress)); },
        exchange);
    return tell_outcome(outcome, request);
}

void add_watching_options(CLI::App& verb, RunOptions& options) {
    verb.add_option("--max-time", options.max_time,
                    "stop after 55m, 90s, 1h30m on the clock; exit 75");
    verb.add_option("--until", options.until, "stop at this simulated time, \"50 ms\"; exit 75");
    verb.add_option("--progress", options.progress, "auto, bar, log, json or none");
}

}  // namespace

void add_run(CLI::App& app, Action& action, const std::string& command_line) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* verb =
        app.add_subcommand("run", "run a case, or go on with one that is not finished");
    add_case_options(*verb, options->given);
    verb->add_option("-o,--output", options->directory, "results directory; else results/NAME");
    add_watching_options(*verb, *options);
    verb->add_flag("--fresh", options->fresh, "begin anew; former results are moved aside");
    verb->footer(
        "The same command goes on where the run was stopped: by Ctrl-C, TERM, HUP,\n"
        "USR1, USR2, XCPU, --max-time, or a crash. A second Ctrl-C, at least a second\n"
        "later, ends it at once. Results of another case are never touched.\n\n"
        "  tanktread run channel.toml --set flow.pseudo_shear_rate=\"150 /s\" -o slow");
    verb->callback([options, &action, &command_line] {
        action = [options, &command_line] { return run(*options, command_line); };
    });
}

void add_resume(CLI::App& app, Action& action, const std::string& command_line) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* verb = app.add_subcommand("resume", "go on with the run of a results directory");
    verb->add_option("directory", options->directory, "the results directory")->required();
    add_threads_option(*verb, options->given.threads);
    add_watching_options(*verb, *options);
    verb->footer("To the same bits as if it had never stopped.");
    verb->callback([options, &action, &command_line] {
        action = [options, &command_line] {
            options->given.path = (fs::path(options->directory) / "resolved.toml").string();
            return run(*options, command_line);
        };
    });
}

}  // namespace tt
