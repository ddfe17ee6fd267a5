#include "observe/section_summary.hpp"

#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/undefined.hpp"
#include "observe/partition.hpp"

namespace tt {
namespace {

/// With the same value as mean, so that tables of means show it.
Json told(double value, double error, const std::string& unit, const std::string& reason) {
    Json json{{"value", number(value)}, {"unit", unit}};
    if (!std::isfinite(value)) json["reason"] = reason;
    json["mean"] = number(value);
    json["standard_error"] = number(error);
    return json;
}

/// What passed a section within the window, net.
struct Passed {
    double cells = 0.0, area = 0.0, volume = 0.0;
    double hematocrit() const { return area / volume; }
};

class Sections {
public:
    Sections(const Table& table, const Window& window) : table_(table) {
        const auto& time = table.column("time");
        for (std::size_t k = 0; k < time.size(); ++k) {
            if (!window.holds(time[k])) continue;
            if (!any_) first_ = k;
            last_ = k;
            any_ = true;
        }
    }

    Passed passed(const std::string& name) const {
        return {difference(name, "cells_forward") - difference(name, "cells_backward"),
                difference(name, "cell_area"), difference(name, "volume")};
    }
    double at_end(const std::string& column) const {
        return table_.rows() > 0 ? table_.column(column).back() : undefined;
    }

private:
    double difference(const std::string& name, const char* quantity) const {
        const auto& column = table_.column(fmt::format("{}.{}", name, quantity));
        return any_ ? column[last_] - column[first_] : undefined;
    }

    const Table& table_;
    bool any_ = false;
    std::size_t first_ = 0, last_ = 0;
};

void add_section(const std::string& name, const Table& table, const Sections& sections,
                 const Averaging& average, Json& summary) {
    for (const char* quantity : {"flow_rate", "mean_velocity", "pressure", "hematocrit_tube",
                                 "hematocrit_discharge", "cfl_from", "cfl_to"}) {
        const std::string column = fmt::format("{}.{}", name, quantity);
        summary[column] = average(column, table, table.column(column));
    }
    Json& discharge = summary[name + ".hematocrit_discharge"];
    discharge["value"] = discharge["mean"] = number(sections.passed(name).hematocrit());
    for (const char* quantity : {"cells_forward", "cells_backward"}) {
        const std::string column = fmt::format("{}.{}", name, quantity);
        summary[column] = {{"value", number(sections.at_end(column))}, {"unit", ""}};
    }
}

double width_of(const Json& places, const std::string& name) {
    for (const Json& section : places["sections"])
        if (section["name"] == name) return section["width"].get<double>();
    return undefined;
}

void add_fork(const Json& fork, const Json& places, const Sections& sections, Json& summary) {
    const auto parent = fork["parent"].get<std::string>();
    const std::array daughters{fork["daughters"][0].get<std::string>(),
                               fork["daughters"][1].get<std::string>()};
    // Signs tell which way the sections were drawn.
    const auto passed = [&](const std::string& name) {
        Passed p = sections.passed(name);
        const double sign = p.volume < 0.0 ? -1.0 : 1.0;
        return Passed{sign * p.cells, sign * p.area, sign * p.volume};
    };
    const Passed in = passed(parent);
    const std::array out{passed(daughters[0]), passed(daughters[1])};
    const double volume = out[0].volume + out[1].volume, cells = out[0].cells + out[1].cells;
    for (const std::size_t n : {0u, 1u}) {
        const std::string start =
            fmt::format("{}.{}.", fork["name"].get<std::string>(), daughters[n]);
        const double flow = out[n].volume / volume;
        const double share = cells > 0.0 ? out[n].cells / cells : undefined;
        const double error = std::sqrt(share * (1.0 - share) / cells);
        summary[start + "flow_fraction"] = told(flow, undefined, "", "nothing flows");
        Json& of_cells = summary[start + "cell_fraction"] =
            told(share, error, "", "no cell passed the fork in the averaging window");
        of_cells["cells"] = number(out[n].cells);
        of_cells["of"] = number(cells);
        summary[start + "hematocrit_ratio"] =
            told(in.area > 0.0 ? out[n].hematocrit() / in.hematocrit() : undefined, undefined, "",
                 "no cells passed the section before the fork in the averaging window");
        const PriesLaw law(Length{width_of(places, parent)}, Length{width_of(places, daughters[n])},
                           Length{width_of(places, daughters[1 - n])}, in.hematocrit());
        summary[start + "pries_cell_fraction"] = told(law.cell_fraction(flow), undefined, "",
                                                      "the flow before the fork has no hematocrit");
    }
}

/// Of the cells that came in, by their numbers; the others were there at the start.
std::map<double, double> times_of_entry(const std::filesystem::path& results) {
    std::map<double, double> times;
    if (!std::filesystem::exists(results / "entered.csv")) return times;
    const Table entered = read_csv(results / "entered.csv");
    const auto &cell = entered.column("cell"), &time = entered.column("time");
    for (std::size_t k = 0; k < cell.size(); ++k) times[cell[k]] = time[k];
    return times;
}

}  // namespace

void summarise_sections(const std::filesystem::path& results, const Window& window,
                        const Averaging& average, Json& summary) {
    if (!std::filesystem::exists(results / "sections.csv")) return;
    const Json places = read_json(results / "places.json");
    const Table table = read_csv(results / "sections.csv");
    const Sections sections(table, window);
    for (const Json& section : places["sections"])
        add_section(section["name"].get<std::string>(), table, sections, average, summary);
    for (const Json& stretch : places["stretches"])
        for (const char* quantity : {"mu_rel", "mu_app"}) {
            const std::string column =
                fmt::format("{}.{}", stretch["name"].get<std::string>(), quantity);
            summary[column] = average(column, table, table.column(column));
        }
    for (const Json& fork : places["forks"]) add_fork(fork, places, sections, summary);
}

void summarise_residence(const std::filesystem::path& results, Json& summary) {
    if (!std::filesystem::exists(results / "left.csv")) return;
    const Json places = read_object(results / "places.json");
    if (!places.contains("ports")) return;
    const Table left = read_csv(results / "left.csv");
    const auto& time = left.column("time");
    const auto& port = left.column("port");
    const auto& cell = left.column("cell");
    const std::map<double, double> entered = times_of_entry(results);
    for (std::size_t n = 0; n < places["ports"].size(); ++n) {
        std::vector<double> times;
        for (std::size_t k = 0; k < time.size(); ++k)
            if (static_cast<std::size_t>(port[k]) == n) {
                const auto came = entered.find(cell[k]);
                times.push_back(time[k] - (came != entered.end() ? came->second : 0.0));
            }
        double mean = 0.0, squares = 0.0;
        const auto count = static_cast<double>(times.size());
        for (const double t : times) mean += t / count;
        for (const double t : times) squares += (t - mean) * (t - mean);
        const double error =
            times.size() > 1 ? std::sqrt(squares / (count - 1.0) / count) : undefined;
        Json& entry = summary[places["ports"][n]["name"].get<std::string>() + ".residence"] = told(
            times.empty() ? undefined : mean, error, "s", "no cell has left through this port");
        entry["samples"] = times.size();
    }
}

}  // namespace tt
