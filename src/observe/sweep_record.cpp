#include "observe/sweep_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/undefined.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
constexpr std::array words{"waiting", "stopped", "failed", "done"};

RunEnding ending_named(const std::string& word) {
    const auto at = std::find(words.begin(), words.end(), word);
    return at == words.end() ? RunEnding::waiting : static_cast<RunEnding>(at - words.begin());
}

/// A field of a table with commas between.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string number_field(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string with_unit(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

/// Names and units of the means of all runs, in the order in which they come.
std::vector<SummaryMean> columns_of(const std::vector<std::vector<SummaryMean>>& rows) {
    std::vector<SummaryMean> columns;
    for (const auto& row : rows)
        for (const SummaryMean& mean : row) {
            const auto same = [&](const SummaryMean& other) { return other.name == mean.name; };
            if (std::none_of(columns.begin(), columns.end(), same)) columns.push_back(mean);
        }
    return columns;
}

std::string table_of(const fs::path& directory, const SweepRecord& sweep) {
    std::vector<std::vector<SummaryMean>> rows;
    for (const SweptRun& run : sweep.runs)
        rows.push_back(run.ending == RunEnding::done ? summary_means(directory / run.directory)
                                                     : std::vector<SummaryMean>{});
    const std::vector<SummaryMean> columns = columns_of(rows);
    const std::vector<std::string> keys = sweep.keys();
    std::vector<std::optional<SweptNumbers>> numbers;
    std::string text = "run,directory";
    const auto put = [&](const std::string& cell) { (text += ',') += cell; };
    for (std::size_t k = 0; k < keys.size(); ++k) {
        numbers.push_back(numbers_of(sweep, k));
        put(with_unit(keys[k], numbers[k] ? si_unit(numbers[k]->dimension) : ""));
    }
    text += ",ending,checks";
    for (const SummaryMean& column : columns) {
        put(with_unit(column.name, column.unit));
        put(with_unit(column.name + "_standard_error", column.unit));
    }
    text += '\n';
    for (std::size_t r = 0; r < sweep.runs.size(); ++r) {
        const SweptRun& run = sweep.runs[r];
        const bool done = run.ending == RunEnding::done;
        text += field(run.name);
        put(field(run.directory.generic_string()));
        for (std::size_t k = 0; k < keys.size(); ++k)
            put(numbers[k] ? number_field(numbers[k]->si[r]) : field(run.values[k]));
        put(word_of(run.ending));
        put(done ? fmt::format("{}", fmt::join(raised_checks(directory / run.directory), " "))
                 : std::string{});
        for (const SummaryMean& column : columns) {
            const auto same = [&](const SummaryMean& mean) { return mean.name == column.name; };
            const auto mean = std::find_if(rows[r].begin(), rows[r].end(), same);
            const bool known = mean != rows[r].end();
            put(number_field(known ? mean->mean : undefined));
            put(number_field(known ? mean->standard_error : undefined));
        }
        text += '\n';
    }
    return text;
}

Json to_json(const SweepRecord& sweep) {
    Json runs = Json::array();
    const std::vector<std::string> keys = sweep.keys();
    for (const SweptRun& run : sweep.runs) {
        Json values;
        for (std::size_t k = 0; k < keys.size(); ++k) values[keys[k]] = run.values[k];
        Json entry{{"name", run.name},
                   {"directory", run.directory.generic_string()},
                   {"values", values},
                   {"ending", word_of(run.ending)}};
        if (!run.why.empty()) entry["why"] = run.why;
        runs.push_back(std::move(entry));
    }
    return {{"format", 1},
            {"name", sweep.name},
            {"program", "tanktread " + version_text()},
            {"case", sweep.case_file},
            {"axes", sweep.axes},
            {"runs", runs}};
}

}  // namespace

std::string word_of(RunEnding ending) { return words[static_cast<std::size_t>(ending)]; }

std::vector<std::string> SweepRecord::keys() const {
    std::vector<std::string> all;
    for (const auto& axis : axes) all.insert(all.end(), axis.begin(), axis.end());
    return all;
}

std::vector<std::string> short_keys(const std::vector<std::string>& keys) {
    const auto last = [](const std::string& key) { return key.substr(key.rfind('.') + 1); };
    std::vector<std::string> names;
    for (const std::string& key : keys) {
        const auto alike = [&](const std::string& other) { return last(other) == last(key); };
        names.push_back(std::count_if(keys.begin(), keys.end(), alike) > 1 ? key : last(key));
    }
    return names;
}

std::optional<SweptNumbers> numbers_of(const SweepRecord& sweep, std::size_t key) {
    SweptNumbers numbers;
    for (const SweptRun& run : sweep.runs) {
        try {
            const Measure value = parse_measure(run.values[key]);
            if (!numbers.si.empty() && !(value.dimension == numbers.dimension)) return std::nullopt;
            numbers.dimension = value.dimension;
            numbers.si.push_back(value.si);
        } catch (const UnitError&) {
            return std::nullopt;
        }
    }
    return numbers;
}

std::vector<SummaryMean> summary_means(const fs::path& results) {
    std::vector<SummaryMean> means;
    const Json summary = read_object(results / "summary.json");
    for (const auto& [name, entry] : summary.items()) {
        if (!entry.is_object()) continue;
        if (entry.contains("mean"))
            means.push_back({name, text_of(entry, "unit"), number_of(entry, "mean", undefined),
                             number_of(entry, "standard_error", undefined)});
        else if (name == "shear_number")
            means.push_back(
                {name, text_of(entry, "unit"), number_of(entry, "value", undefined), undefined});
    }
    return means;
}

std::vector<std::string> raised_checks(const fs::path& results) {
    std::vector<std::string> names;
    const Json summary = read_object(results / "summary.json");
    if (summary.contains("numerics_changed")) names.emplace_back("numerics_changed");
    const auto checks = summary.find("checks");
    if (checks == summary.end() || !checks->is_array()) return names;
    for (const Json& check : *checks)
        if (text_of(check, "verdict", "ok") != "ok") names.push_back(text_of(check, "name"));
    return names;
}

void write_sweep(const fs::path& directory, const SweepRecord& sweep) {
    replace_file(directory / "table.csv", table_of(directory, sweep), Durability::process);
    write_json(directory / "sweep.json", to_json(sweep), Durability::process);
}

bool is_sweep(const fs::path& directory) { return fs::exists(directory / "sweep.json"); }

SweepRecord read_sweep_record(const fs::path& directory) {
    const fs::path path = directory / "sweep.json";
    const Json json = read_json(path);
    try {
        SweepRecord sweep;
        sweep.name = json.at("name").get<std::string>();
        sweep.case_file = json.at("case").get<std::string>();
        sweep.axes = json.at("axes").get<std::vector<std::vector<std::string>>>();
        for (const Json& entry : json.at("runs")) {
            SweptRun run;
            run.name = entry.at("name").get<std::string>();
            run.directory = entry.at("directory").get<std::string>();
            for (const std::string& key : sweep.keys())
                run.values.push_back(entry.at("values").at(key).get<std::string>());
            run.ending = ending_named(entry.at("ending").get<std::string>());
            run.why = text_of(entry, "why");
            sweep.runs.push_back(std::move(run));
        }
        return sweep;
    } catch (const Json::exception&) {
        throw IoError(fmt::format("'{}' is damaged; the same `tanktread sweep` writes it anew",
                                  path.string()));
    }
}

std::string describe_sweep(const SweepRecord& sweep) {
    std::array<int, words.size()> count{};
    for (const SweptRun& run : sweep.runs) ++count[static_cast<std::size_t>(run.ending)];
    const auto of = [&](RunEnding ending) { return count[static_cast<std::size_t>(ending)]; };
    std::string text =
        fmt::format("{}: {} of {} runs done", sweep.name, of(RunEnding::done), sweep.runs.size());
    if (of(RunEnding::failed) > 0) text += fmt::format(", {} failed", of(RunEnding::failed));
    if (const int open = of(RunEnding::waiting) + of(RunEnding::stopped); open > 0)
        text += fmt::format(", {} to do", open);
    text += '\n';
    for (const SweptRun& run : sweep.runs)
        if (run.ending == RunEnding::failed)
            text += wrapped(fmt::format("failed: {}: {}", run.name, run.why), 79, 8) + '\n';
    return text;
}

}  // namespace tt
