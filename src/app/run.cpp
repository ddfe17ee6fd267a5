#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/case_options.hpp"
#include "app/layout_progress.hpp"
#include "app/option_values.hpp"
#include "base/tell.hpp"
#include "app/run_request.hpp"
#include "app/verb.hpp"
#include "base/units.hpp"
#include "base/words.hpp"
#include "case/cures.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/trial.hpp"
#include "exchange/periodic.hpp"
#include "io/file.hpp"
#include "observe/run_case.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
    CaseOptions given;
    fs::path case_as_given;  ///< where it is not the file that is read
    std::optional<std::string> directory;
    std::optional<std::string> max_time, until;
    std::string progress = "auto";
    bool fresh = false;
};

/// Placing many cells takes a while; who asks for a stop does not wait for it.
LayoutWatch stoppable(LayoutWatch watch) {
    return [watch = std::move(watch)](int cells, double filled) {
        if (stop_requested())
            throw StoppedEarly(
                "stopped while cells were placed, before the first step; nothing was written, the "
                "same command begins again");
        watch(cells, filled);
    };
}

/// What to do next, and how the run was, for people; for programs the checks alone.
void tell_next(const RunRequest& request, const std::string& next,
               const std::vector<RunCheck>& checks) {
    std::fflush(stdout);  // before what goes to stderr
    if (request.progress != ProgressMode::json)
        tell_user("{}\n{}", next, describe_checks(checks));
    else if (!checks.empty())
        write_plainly(Json{{"checks", to_json(checks)}}.dump() + '\n');
}

int tell_outcome(const RunOutcome& outcome, const RunRequest& request) {
    const std::string directory = request.directory.string();
    switch (outcome.ending) {
        case RunOutcome::Ending::done:
            fmt::print("{}\n", directory);
            tell_next(request, "next:  tanktread report " + shell_word(directory), outcome.checks);
            return exit_code::done;
        case RunOutcome::Ending::was_done:
            fmt::print("{}\n", directory);
            tell_next(request,
                      wrapped(fmt::format("{} is finished, {} steps; a later time.end makes it "
                                          "longer, --fresh begins anew and keeps it beside",
                                          directory, outcome.steps),
                              79, 2),
                      outcome.checks);
            return exit_code::done;
        case RunOutcome::Ending::stopped:
            break;
    }
    tell_next(request, "next:  tanktread resume " + shell_word(directory), {});
    return exit_code::stopped_early;
}

int run(const RunOptions& options, const std::string& command_line) {
    const GivenCase given = read_given_case(options.given);
    const Case& c = given.c;
    const Choice choice = choose(c);
    expect_memory(c, choice);
    Model model = discretise(c, choice);
    model.threads = choose_threads(options.given.threads, c, choice).threads;
    RunRequest request = request_for(c, choice, model);
    request.directory =
        options.directory ? fs::path(*options.directory) : fs::path("results") / c.name;
    if (request.directory.empty()) throw CommandError("-o needs the name of a directory");
    request.case_toml =
        options.case_as_given.empty() ? given.text : read_file(options.case_as_given);
    request.command_line = command_line;
    request.progress = progress_mode(options.progress);
    request.start = options.fresh ? Start::fresh : Start::resume;
    if (options.max_time) request.max_time = parse_duration("--max-time", *options.max_time);
    if (options.until) {
        const Time until = parse_time("--until", *options.until);
        if (until > c.time.end)
            throw CommandError(fmt::format("--until {} is beyond the end of the case, {}",
                                           *options.until, to_text(c.time.end)));
        request.until = until;
    }
    const auto start = [&] {
        State initial = initial_state(c, model, stoppable(layout_progress(request.progress)));
        expect_stable(c, choice, model, initial);
        return initial;
    };
    request.remedies = [&] { return cures(c, model.threads); };
    Periodic exchange;
    const RunOutcome outcome = run_case(request, model, start, exchange);
    return tell_outcome(outcome, request);
}

void add_watching_options(CLI::App& verb, RunOptions& options) {
    verb.add_option("--max-time", options.max_time,
                    "stop after 55m, 90s, 1h30m on the clock; exit 75")
        ->type_name(value_kind::time);
    verb.add_option("--until", options.until, "stop at this simulated time, \"50 ms\"; exit 75")
        ->type_name(value_kind::time);
    add_progress_option(verb, options.progress);
}

}  // namespace

void add_run(CLI::App& app, Action& action, const std::string& command_line) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* verb =
        app.add_subcommand("run", "run a case, or go on with one that is not finished");
    add_case_options(*verb, options->given);
    verb->add_option("-o,--output", options->directory, "results directory; else results/NAME")
        ->type_name(value_kind::directory);
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
    verb->add_option("directory", options->directory, "the results directory")
        ->required()
        ->type_name(value_kind::directory);
    add_set_option(*verb, options->given);
    add_threads_option(*verb, options->given.threads);
    add_watching_options(*verb, *options);
    verb->footer(
        "To the same bits as if it had never stopped. A finished run is made longer with\n"
        "a later end; the name and the output may change too. One that blew up goes on\n"
        "from its last good state, with other numerics.\n\n"
        "  tanktread resume results/slow --set time.end=\"160 ms\"\n"
        "  tanktread resume results/slow --set numerics.dt=\"0.2 us\"");
    verb->callback([options, &action, &command_line] {
        action = [options, &command_line] {
            const fs::path directory = *options->directory;
            options->given.path = (directory / "resolved.toml").string();
            options->case_as_given = directory / "case.toml";
            if (!fs::exists(options->given.path) || !fs::exists(options->case_as_given))
                throw IoError(fmt::format(
                    "'{}' holds no run to go on with; give a directory that `tanktread run` wrote",
                    directory.string()));
            return run(*options, command_line);
        };
    });
}

}  // namespace tt
