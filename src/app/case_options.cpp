#include "app/case_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>

#include "app/option_values.hpp"
#include "case/kinds.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/processors.hpp"
#include "base/units.hpp"
#include "case/read.hpp"
#include "case/step_limits.hpp"
#include "io/file.hpp"

namespace tt {

void add_case_options(CLI::App& verb, CaseOptions& options) {
    verb.add_option("case", options.path, "the case file")
        ->required()
        ->type_name(value_kind::toml_file);
    add_set_option(verb, options);
    add_threads_option(verb, options.threads);
}

void add_set_option(CLI::App& verb, CaseOptions& options) {
    verb.add_option("--set", options.overrides, "KEY=VALUE in place of the file's; may be repeated")
        ->allow_extra_args(false)
        ->type_name(value_kind::setting);
}

GivenCase read_given_case(const CaseOptions& options) {
    namespace fs = std::filesystem;
    const fs::path given = options.path;
    if (!fs::exists(given) || fs::is_directory(given)) {
        for (const fs::path& meant : {fs::path(options.path + ".toml"), given / "case.toml"})
            if (fs::is_regular_file(meant))
                throw IoError(fmt::format("'{}' is not a case file; did you mean {}?", options.path,
                                          meant.string()));
    }
    GivenCase result;
    result.text = read_file(given, Author::user);
    result.c =
        parse_case(result.text, options.path, options.overrides, fs::absolute(given).parent_path());
    return result;
}

void expect_memory(const Case& c, const Choice& choice) {
    constexpr double bytes_per_site = 300.0;  // 257 of a run were measured
    const double bytes = usable_memory();
    expect_sites(c, choice, bytes / bytes_per_site,
                 fmt::format("fit into {:.2g} GB of memory", 1e-9 * bytes));
}

void add_threads_option(CLI::App& verb, int& threads) {
    verb.add_option("-j,--threads", threads, "threads; else all processors that are of use")
        ->check(CLI::Range(1, 1024))
        ->type_name(value_kind::count);
}

std::int64_t expected_nodes(const Case& c, const Choice& choice) {
    if (c.numerics.fluid_only) return 0;
    const double radius = largest_cell_radius(c).si, dx = choice.dx.si;
    const double box = choice.nx * dx * choice.ny * dx;
    const auto* layout = std::get_if<AtPositions>(&c.cells.layout);
    const auto count =
        layout ? static_cast<std::int64_t>(layout->positions.size()) : c.cells.count.value_or(1);
    const double cells = c.cells.hematocrit
                             ? *c.cells.hematocrit * box / (std::numbers::pi * radius * radius)
                             : static_cast<double>(count);
    return std::llround(cells * 2.0 * std::numbers::pi * radius /
                        (choice.kinds.front().node_spacing * dx));
}

ThreadChoice choose_threads(int asked, const Case& c, const Choice& choice) {
    if (asked > 0) return {asked, "as given"};
    const int usable = usable_processors();
    const int threads = threads_for(static_cast<std::int64_t>(choice.nx) * choice.ny,
                                    expected_nodes(c, choice), usable);
    if (threads == usable)
        return {threads, usable == 1 ? "the one processor that this process may use"
                                     : "all processors that this process may use"};
    return {threads, fmt::format("of {} processors that this process may use: with more, threads "
                                 "would wait for each other longer than they save",
                                 usable)};
}

Time parse_duration(std::string_view option, std::string_view text) {
    const auto refuse = [&] {
        throw CommandError(fmt::format(
            "{} {} is not a duration; write for example 55m, 90s or 1h30m", option, text));
    };
    double seconds = 0.0;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t length = number_length(rest);
        if (length == 0 || rest.front() == '-') refuse();
        double number = 0.0;
        try {
            number = parse_measure(rest.substr(0, length)).si;
        } catch (const UnitError&) {
            refuse();  // too large to be a number
        }
        rest.remove_prefix(length);
        const std::size_t end = std::min(rest.find_first_of("0123456789."), rest.size());
        std::string unit(rest.substr(0, end));
        unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
        rest.remove_prefix(end);
        if (unit == "h")
            seconds += 3600.0 * number;
        else if (unit == "m" || unit == "min")
            seconds += 60.0 * number;
        else if (unit == "s")
            seconds += number;
        else
            refuse();
    }
    if (!(seconds > 0.0)) refuse();
    return Time{seconds};
}

Time parse_time(std::string_view option, std::string_view text) {
    try {
        const Measure m = parse_measure(text);
        if (m.dimension == Time::dimension && m.si > 0.0) return Time{m.si};
    } catch (const UnitError&) {
    }
    throw CommandError(
        fmt::format("{} {} is not a time; write for example {} \"50 ms\"", option, text, option));
}

}  // namespace tt
