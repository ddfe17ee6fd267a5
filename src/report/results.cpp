#include "report/results.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/undefined.hpp"
#include "base/units.hpp"
#include "io/file.hpp"
#include "io/table_sums.hpp"
#include "io/toml.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// A table that is damaged is told and left out.
Table read_table(const fs::path& directory, const char* name, std::vector<std::string>& faults) {
    const fs::path path = directory / name;
    std::string fault;
    try {
        fault = table_fault(directory, name);
        if (fault.empty()) return fs::exists(path) ? read_csv(path) : Table{};
    } catch (const IoError& error) {
        fault = fmt::format("{} is damaged: {}", path.string(), error.what());
    }
    faults.push_back(fault + "; it is left out");
    return {};
}

/// Likewise.
Json read_record(const fs::path& path, std::vector<std::string>& faults) {
    Json record = read_object(path);
    if (record.empty() && fs::exists(path))
        faults.push_back(path.string() + " is damaged; it is left out");
    return record;
}

/// nullptr if they are not there or cannot be read.
std::shared_ptr<const FramesReader> read_frames(const fs::path& path,
                                                std::vector<std::string>& faults) {
    if (!fs::exists(path)) return nullptr;
    try {
        auto frames = std::make_shared<const FramesReader>(path);
        faults.insert(faults.end(), frames->faults().begin(), frames->faults().end());
        return frames;
    } catch (const IoError& error) {
        faults.emplace_back(error.what());
        return nullptr;
    }
}

/// A value as a person would write it, without quotes.
std::string shown(const TomlNode& value) {
    using Kind = TomlNode::Kind;
    if (value.kind == Kind::integer) return fmt::format("{}", value.integer);
    if (value.kind == Kind::real) return fmt::format("{:g}", value.real);
    if (value.kind == Kind::boolean) return value.boolean ? "true" : "false";
    if (value.kind != Kind::array) return value.text;
    std::string list;
    for (const TomlNode& item : value.items) list += (list.empty() ? "" : ", ") + shown(item);
    return list;
}

/// Every key with its table before it, "flow.drive", and its value as text.
void gather(const TomlNode& table, const std::string& prefix,
            std::map<std::string, std::string>& out) {
    for (const TomlEntry& entry : table.entries) {
        if (entry.value.kind == TomlNode::Kind::table) {
            gather(entry.value, prefix + entry.key + ".", out);
        } else {
            out[prefix + entry.key] = shown(entry.value);
        }
    }
}

std::map<std::string, std::string> read_settings(const fs::path& path) {
    std::map<std::string, std::string> settings;
    if (fs::exists(path)) gather(parse_toml(read_file(path), path.string()).root, "", settings);
    return settings;
}

/// Gathers every average of the summary.
void gather(const Json& json, Results& results) {
    for (const auto& [name, value] : json.items()) {
        if (!value.is_object() || !value.contains("mean")) continue;
        results.quantities.push_back(
            {name, text_of(value, "unit"), number_of(value, "mean", undefined),
             number_of(value, "standard_error", undefined), number_of(value, "sd_time", undefined),
             number_of(value, "sd_cells", undefined), text_of(value, "reason")});
        const auto window = value.find("window");
        if (window == value.end() || !window->is_array() || window->size() != 2) continue;
        if (!(*window)[0].is_number() || !(*window)[1].is_number()) continue;
        results.window_begin = (*window)[0].get<double>();
        results.window_end = (*window)[1].get<double>();
    }
}

void read_failure(const fs::path& folder, Results& r) {
    r.failure = read_record(folder / "failure.json", r.faults);
    if (fs::exists(folder / "why.txt")) r.why = read_file(folder / "why.txt");
    r.failing = read_frames(folder / "frames.h5", r.faults);
    if (r.failing && r.failing->count() == 0) r.failing = nullptr;
}

std::string case_name(const Results& results) {
    if (const std::string name = results.setting("name"); !name.empty()) return name;
    return fs::absolute(results.directory / "").parent_path().filename().string();
}

}  // namespace

std::string Results::setting(const std::string& key, const std::string& otherwise) const {
    const auto found = settings.find(key);
    return found == settings.end() ? otherwise : found->second;
}

Results read_results(const fs::path& directory) {
    if (!fs::is_directory(directory))
        throw IoError(directory.string() + ": no such results directory");
    Results r;
    r.directory = directory;
    const bool resolved = fs::exists(directory / "resolved.toml");
    r.settings = read_settings(directory / (resolved ? "resolved.toml" : "case.toml"));
    r.status = read_record(directory / "status.json", r.faults);
    r.provenance = read_record(directory / "PROVENANCE.json", r.faults);
    r.summary = read_record(directory / "summary.json", r.faults);
    r.places = read_record(directory / "places.json", r.faults);
    gather(r.summary, r);
    r.checks = read_checks(directory);
    r.series = read_table(directory, "series.csv", r.faults);
    r.cells = read_table(directory, "cells.csv", r.faults);
    r.profiles = read_table(directory, "profiles.csv", r.faults);
    r.ports = read_table(directory, "ports.csv", r.faults);
    r.sections = read_table(directory, "sections.csv", r.faults);
    r.frames = read_frames(directory / "frames.h5", r.faults);
    read_failure(directory / "failure", r);
    if (r.series.names.empty() && r.status.empty() && !r.frames && r.failure.empty())
        throw IoError(
            fmt::format("{}: holds no results (no series.csv, no status.json, no frames.h5); "
                        "give a directory that `tanktread run` wrote",
                        directory.string()));
    r.name = case_name(r);
    return r;
}

const std::vector<double>& values(const Table& table, std::string_view name) {
    static const std::vector<double> nothing;
    return table.has(name) ? table.column(name) : nothing;
}

double setting_si(const std::string& text) {
    try {
        return parse_measure(text).si;
    } catch (const UnitError&) {
        return undefined;
    }
}

std::vector<double> settings_si(const std::string& list) {
    std::vector<double> all;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t comma = std::min(list.find(',', at), list.size());
        all.push_back(setting_si(list.substr(at, comma - at)));
        at = comma + 1;
    }
    return all;
}

double window_mean(const Results& results, const std::string& column) {
    const std::vector<double>& time = values(results.series, "time");
    const std::vector<double>& series = values(results.series, column);
    if (time.empty() || series.size() != time.size()) return undefined;
    const bool stated = results.window_end > results.window_begin;
    const double from = stated ? results.window_begin : 0.5 * (time.front() + time.back());
    const double to = stated ? results.window_end : time.back();
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (time[k] < from || time[k] > to || !std::isfinite(series[k])) continue;
        sum += series[k];
        ++count;
    }
    return count > 0 ? sum / count : undefined;
}

}  // namespace tt
