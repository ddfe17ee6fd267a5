#include "app/sweep_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/option_values.hpp"
#include "app/run_request.hpp"
#include "app/verb.hpp"
#include "io/file.hpp"

namespace tt {

void add_sweep_options(CLI::App& verb, SweepOptions& options) {
    verb.add_option("file", options.path, "a case file with --over, or the file of a sweep")
        ->required()
        ->type_name(value_kind::toml_file);
    verb.add_option("--over", options.over, "KEY=VALUES, an axis; may be repeated")
        ->allow_extra_args(false)
        ->type_name(value_kind::axis);
    verb.add_option("--set", options.set, "KEY=VALUE for every run; may be repeated")
        ->allow_extra_args(false)
        ->type_name(value_kind::setting);
    verb.add_option("-o,--output", options.directory, "directory; else results/NAME")
        ->type_name(value_kind::directory);
    verb.add_option("-j,--jobs", options.jobs, "runs side by side; else a processor each")
        ->check(CLI::Range(1, 1024))
        ->type_name(value_kind::count);
    verb.add_option("--max-time", options.max_time,
                    "stop after 55m, 90s, 1h30m on the clock; exit 75")
        ->type_name(value_kind::time);
    add_progress_option(verb, options.progress);
    verb.add_flag("--list", options.list, "tell the runs and how they stand; run nothing");
    verb.add_flag("--gather", options.gather, "make table and page of what there is; run nothing");
    verb.add_flag("--parallel", options.parallel, "print the line for GNU parallel; run nothing");
    verb.add_flag("--slurm", options.slurm,
                  "write a job array for Slurm, each task --max-time long or an hour; run nothing");
    verb.add_flag("--retry", options.retry, "begin failed runs anew");
    verb.add_flag("--fresh", options.fresh, "begin all anew; the former sweep is moved aside");
    verb.footer(
        "VALUES are a list or a range FROM:TO:STEP; a unit behind the last is of all.\n"
        "Each axis goes with each other; keys that change together stand in one, with\n"
        "';' between.\n\n"
        "  tanktread sweep shear.toml --over flow.shear_number=0.1:1:0.1\n"
        "  tanktread sweep channel.toml --over \"flow.pseudo_shear_rate=50,150,500 /s\" \\\n"
        "      --over cells.seed=1:3:1 -o results/rates\n"
        "  tanktread sweep channel.toml \\\n"
        "      --over \"domain.width=20,40 um; domain.length=80,160 um\"\n\n"
        "The same command goes on where it was stopped. A run that is there already, of\n"
        "this sweep, of another or made by hand, is not made again. The directory holds\n"
        "runs/, table.csv (a row a run), report.html (the page) and sweep.toml, which can\n"
        "be given in place of the case. Exit code 3 if a run failed.");
}

SweepPlan read_plan(SweepOptions& options) {
    std::filesystem::path path = options.path;
    if (std::filesystem::exists(path / "sweep.toml")) {
        if (!options.directory) options.directory = options.path;
        path /= "sweep.toml";
    }
    const std::string text = read_file(path, Author::user);
    if (is_sweep_file(text)) {
        if (!options.over.empty())
            throw CommandError(fmt::format(
                "{} is the file of a sweep; write the axis into it as [[over]]", options.path));
        return read_sweep(path, options.set);
    }
    if (options.over.empty())
        throw CommandError(
            "nothing to go over; write for example --over flow.shear_number=0.1:1:0.1");
    return sweep_over(path, options.set, options.over);
}

}  // namespace tt
