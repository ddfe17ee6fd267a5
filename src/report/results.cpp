#include "report/results.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Json read_json(const fs::path& path) {
    std::ifstream file(path);
    if (!file) return Json::object();
    Json json = Json::parse(file, nullptr, false);
    if (json.is_discarded()) throw IoError(path.string() + ": is not valid JSON");
    return json;
}

Table table_if_there(const fs::path& path) {
    if (!fs::exists(path) || fs::file_size(path) == 0) return {};
    return read_table(path);
}

std::string bare(std::string text) {
    const auto begin = text.find_first_not_of(" \t");
    const auto end = text.find_last_not_of(" \t\r");
    if (begin == std::string::npos) return {};
    text = text.substr(begin, end - begin + 1);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return text;
}

/// Removes a comment that starts outside a string.
std::string without_comment(const std::string& line) {
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (line[k] == '"') quoted = !quoted;
        if (line[k] == '#' && !quoted) return line.substr(0, k);
    }
    return line;
}

/// `[table]` and `key = value`, one a line, as tanktread itself writes resolved.toml. Values keep their text.
std::map<std::string, std::string> read_settings(const fs::path& path) {
    std::map<std::string, std::string> settings;
    std::ifstream file(path);
    std::string line, table;
    while (std::getline(file, line)) {
        line = bare(without_comment(line));
        if (line.size() > 2 && line.front() == '[') {
            table = line.substr(1, line.size() - 2) + ".";
        } else if (const auto equal = line.find('='); equal != std::string::npos) {
            settings[table + bare(line.substr(0, equal))] = bare(line.substr(equal + 1));
        }
    }
    return settings;
}

double number_or_nan(const Json& object, const char* key) {
    return object.contains(key) && object[key].is_number() ? object[key].get<double>() : nan;
}

/// Gathers every {mean, sd_time, sd_cells, window, unit} of the summary, whatever group it stands in.
void gather(const Json& json, Results& results) {
    for (const auto& [name, value] : json.items()) {
        if (!value.is_object()) continue;
        if (!value.contains("mean")) {
            gather(value, results);
            continue;
        }
        std::string unit = value.value("unit", "");
        if (unit == "1") unit.clear();
        results.quantities.push_back(
            {name, unit, number_or_nan(value, "mean"), number_or_nan(value, "sd_time"), number_or_nan(value, "sd_cells")});
        const auto window = value.find("window");
        if (window == value.end() || !window->is_array() || window->size() != 2) continue;
        if (!(*window)[0].is_number() || !(*window)[1].is_number()) continue;
        results.window_begin = (*window)[0].get<double>();
        results.window_end = (*window)[1].get<double>();
    }
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
    if (!fs::is_directory(directory)) throw IoError(directory.string() + ": no such results directory");
    Results r;
    r.directory = directory;
    const bool resolved = fs::exists(directory / "resolved.toml");
    r.settings = read_settings(directory / (resolved ? "resolved.toml" : "case.toml"));
    r.status = read_json(directory / "status.json");
    r.provenance = read_json(directory / "PROVENANCE.json");
    r.summary = read_json(directory / "summary.json");
    gather(r.summary, r);
    r.series = table_if_there(directory / "series.csv");
    r.cells = table_if_there(directory / "cells.csv");
    r.profiles = table_if_there(directory / "profiles.csv");
    if (fs::exists(directory / "frames.h5")) r.frames = std::make_shared<const FrameFile>(directory / "frames.h5");
    if (r.settings.empty() && r.series.columns.empty() && !r.frames)
        throw IoError(fmt::format("{}: holds no results (no case, no series.csv, no frames.h5); "
                                  "give a directory that `tanktread run` wrote", directory.string()));
    r.name = case_name(r);
    return r;
}

double setting_si(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str()) return nan;
    const std::string unit = bare(end);
    static constexpr std::array<std::pair<const char*, double>, 12> known{{
        {"", 1.0}, {"m", 1.0}, {"um", 1e-6}, {"nm", 1e-9}, {"mm", 1e-3}, {"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6},
        {"/s", 1.0}, {"1/s", 1.0}, {"Pa s", 1.0}, {"cP", 1e-3}}};
    for (const auto& [name, factor] : known)
        if (unit == name) return value * factor;
    return nan;
}

double window_mean(const Results& results, const std::string& column) {
    const std::vector<double>& time = results.series.values("time");
    const std::vector<double>& values = results.series.values(column);
    if (time.empty() || values.size() != time.size()) return nan;
    const bool stated = results.window_end > results.window_begin;
    const double from = stated ? results.window_begin : 0.5 * (time.front() + time.back());
    const double to = stated ? results.window_end : time.back();
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (time[k] < from || time[k] > to || !std::isfinite(values[k])) continue;
        sum += values[k];
        ++count;
    }
    return count > 0 ? sum / count : nan;
}

}  // namespace tt
