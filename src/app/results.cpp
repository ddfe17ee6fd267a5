#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/option_values.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/tell.hpp"
#include "observe/checks.hpp"
#include "observe/status.hpp"
#include "observe/sweep_record.hpp"
#include "report/export.hpp"
#include "report/figures.hpp"
#include "report/report.hpp"
#include "report/sweep_page.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

struct ResultsOptions {
    std::vector<fs::path> directories;
    fs::path out;
    std::string to;
    bool json = false;
};

int show_sweep(const ResultsOptions& options) {
    const fs::path& directory = options.directories.front();
    if (options.json)
        fmt::print("{}\n", read_json(directory / "sweep.json").dump(2));
    else
        fmt::print("{}", describe_sweep(read_sweep_record(directory)));
    return exit_code::done;
}

int show_status(const ResultsOptions& options) {
    if (is_sweep(options.directories.front())) return show_sweep(options);
    Json status = read_status(options.directories.front());
    const std::vector<RunCheck> checks = read_checks(options.directories.front());
    if (options.json) {
        status["checks"] = to_json(checks);
        fmt::print("{}\n", status.dump(2));
    } else {
        fmt::print("{}{}", describe_status(status), describe_checks(checks));
    }
    return exit_code::done;
}

int report(const ResultsOptions& options) {
    if (options.directories.size() == 1 && is_sweep(options.directories.front())) {
        fmt::print("{}\n", write_sweep_page(options.directories.front(), options.out).string());
        return exit_code::done;
    }
    fmt::print("{}\n", write_report(options.directories, options.out).string());
    std::fflush(stdout);  // before what goes to stderr
    if (!can_draw())
        tell_user("{}\nThe page has all else: checks, tables, charts, the player.\n", no_gnuplot);
    return exit_code::done;
}

int export_results(const ResultsOptions& options) {
    const fs::path& directory = options.directories.front();
    const fs::path out = options.out.empty() ? directory / options.to : options.out;
    if (options.to == "vtk") {
        export_vtk(directory, out);
    } else if (options.to == "csv") {
        export_csv(directory, out);
    } else {
        if (!can_draw()) throw IoError(std::string(no_gnuplot));
        const std::vector<Results> runs{read_results(directory)};
        for (const std::string& fault : runs.front().faults) tell_user("tanktread: {}\n", fault);
        draw_figures(runs, out);
    }
    fmt::print("{}\n", out.string());
    return exit_code::done;
}

}  // namespace

void add_status(CLI::App& app, Action& action) {
    auto options = std::make_shared<ResultsOptions>();
    CLI::App* verb = app.add_subcommand("status", "tell how far a run or a sweep is");
    verb->add_option("directory", options->directories, "the results directory")
        ->required()
        ->expected(1)
        ->type_name(value_kind::directory);
    verb->add_flag("--json", options->json, "as JSON");
    verb->callback([options, &action] { action = [options] { return show_status(*options); }; });
}

void add_report(CLI::App& app, Action& action) {
    auto options = std::make_shared<ResultsOptions>();
    CLI::App* verb =
        app.add_subcommand("report", "figures and a page to open, of a run, several or a sweep");
    verb->add_option("directories", options->directories, "results directories")
        ->required()
        ->type_name(value_kind::directory);
    verb->add_option("-o,--output", options->out, "where to; else into the directory itself")
        ->type_name(value_kind::directory);
    verb->footer(
        "Several directories make a comparison. A run that is not finished is reported\n"
        "as far as it came. Prints the path of the page, report.html, which needs no\n"
        "network.");
    verb->callback([options, &action] { action = [options] { return report(*options); }; });
}

void add_export(CLI::App& app, Action& action) {
    auto options = std::make_shared<ResultsOptions>();
    CLI::App* verb = app.add_subcommand("export", "the frames of a run for other programs");
    verb->add_option("directory", options->directories, "the results directory")
        ->required()
        ->expected(1)
        ->type_name(value_kind::directory);
    add_choice(*verb, "--to", options->to, {{"vtk", "ParaView"}, {"csv", ""}, {"png", "figures"}})
        ->required();
    verb->add_option("-o,--output", options->out, "where to; else a folder in the directory")
        ->type_name(value_kind::directory);
    verb->callback([options, &action] { action = [options] { return export_results(*options); }; });
}

}  // namespace tt
