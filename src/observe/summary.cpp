#include "observe/summary.hpp"

#include <algorithm>
#include <set>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

#include "base/undefined.hpp"
#include "io/csv.hpp"
#include "observe/cell_summary.hpp"
#include "observe/section_summary.hpp"

namespace tt {
namespace {

constexpr std::array shapes{"taylor_inertia", "taylor_extent", "inclination_deg", "strain",
                            "lambda_C"};
constexpr std::string_view period = "tank_treading_kT";
constexpr std::string_view climb = "lateral_displacement";
constexpr std::array flows{"area_error_max",
                           "mean_velocity",
                           "pseudo_shear_rate",
                           "flux",
                           "pressure_gradient",
                           "mu_app",
                           "mu_rel",
                           "cfl_gap",
                           "cfl_envelope",
                           "cfl_profile",
                           "cfl_core",
                           "hematocrit_tube",
                           "hematocrit_discharge",
                           "mach",
                           "smallest_gap",
                           "overlaps",
                           "repulsion_count",
                           "turn_max_deg",
                           "curvature_radius_sites"};
constexpr std::array stresses{"shear_number_star_traction", "shear_number_star_principal",
                              "membrane_dissipation"};

template <std::size_t count>
bool has(const std::array<const char*, count>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Why a quantity may have no value.
std::string reason_for(std::string_view name, bool rows, bool cells) {
    const auto starts = [&](std::string_view start) {
        return name.substr(0, start.size()) == start;
    };
    const bool of_cells =
        name == period || name == climb || has(shapes, name) || has(stresses, name);
    if (of_cells && !cells) return "there are no cells";
    if (!rows) return "no row of the tables lies in the averaging window";
    if (name == "shear_number") return "no cells, or nothing that drives the flow";
    constexpr std::array along{"mean_velocity", "pseudo_shear_rate", "flux", "pressure_gradient"};
    if (has(along, name))
        return "channels between ports have no one direction; ports.csv has their flow";
    if (starts("mu_")) return "nothing drives the flow, nothing flows, or it goes through ports";
    if (!cells) return "there are no cells";
    if (name == period)
        return "no cell turned its membrane by a fiftieth of a turn at an inclination that it kept";
    if (starts("cfl_")) return "there are no straight walls along the flow";
    if (name == "hematocrit_discharge") return "no mean flow carries the cells";
    if (name == "smallest_gap") return "no two cells were within the reach of contact forces";
    if (name == "inclination_deg")
        return "the cells are circles, which have no long axis, or their long axis goes all round";
    if (name == climb) return "no cell came along the flow by ten sites, or it goes through ports";
    return "it was not defined at any row in the averaging window";
}

/// `{value, unit}`, and the reason where there is no value.
Json entry(double value, const std::string& unit, const std::string& reason = "") {
    Json json{{"value", number(value)}, {"unit", unit}};
    if (!std::isfinite(value) && !reason.empty()) json["reason"] = reason;
    return json;
}

Json averaged(const std::string& name, const Samples& samples, const std::string& unit, bool cells,
              const SummaryInput& input) {
    const WindowStatistics all = window_statistics(samples.all);
    const WindowStatistics looks = window_statistics(samples.look_means);
    std::vector<double> of_cells;
    for (const auto& cell : samples.cells) of_cells.push_back(window_statistics(cell).mean);
    const double interval = looks.samples > 1
                                ? input.window.length() / static_cast<double>(looks.samples - 1)
                                : undefined;
    Json json = entry(all.mean, unit, reason_for(name, !samples.all.empty(), cells));
    json["mean"] = number(all.mean);
    json["standard_error"] = number(looks.standard_error);
    json["sd_time"] = number(looks.sd);
    json["sd_cells"] = number(window_statistics(of_cells).sd);
    json["min"] = number(all.smallest);
    json["max"] = number(all.largest);
    json["samples"] = looks.samples;
    json["effective_samples"] = number(looks.effective_samples);
    json["correlation_time"] = number(looks.correlation_time * interval);
    json["window"] = {input.window.from.si, input.window.to.si};
    return json;
}

Json step_us(const SessionTimes& session) {
    if (session.steps == 0) {
        return entry(undefined, "us", "no step was made in the last session");
    }
    const double us = 1e6 / static_cast<double>(session.steps);
    Json json = entry(us * session.wall_seconds, "us");
    double inside = 0.0;
    for (std::size_t k = 0; k < StepTimes::names.size(); ++k) {
        json["passes"][StepTimes::names[k]] = us * session.pass_seconds[k];
        inside += session.pass_seconds[k];
    }
    json["passes"]["outside"] = us * (session.wall_seconds - inside);
    return json;
}

CheckInput check_input(const SummaryInput& input) {
    CheckInput result;
    result.dx = input.dx;
    result.window = input.window;
    result.channel = std::isfinite(input.mirror_height.si) && input.shear_rate.si != 0.0;
    result.held_rate = input.held_rate;
    return result;
}

template <class Row>
std::optional<Dimension> dimension_in(std::string_view name) {
    std::optional<Dimension> result;
    for_each_field<Row>([&](const auto& entry) {
        using T = std::remove_cvref_t<decltype(Row{}.*entry.member)>;
        if (entry.key != name) return;
        result = Dimension{};
        if constexpr (requires { T::dimension; }) result = T::dimension;
    });
    return result;
}

/// What is averaged over cells.
void summarise_cells(const Table& cells, const SummaryInput& input, Json& summary) {
    const bool any = cells.rows() > 0;
    for (const std::string name : shapes) {
        const std::vector<double> column =
            name == "inclination_deg" ? inclinations(cells, input) : cells.column(name);
        summary[name] = averaged(name, gather(cells, column, input), cells.unit(name), any, input);
    }
    const auto put_of_cells = [&](std::string_view name, const Samples& each) {
        Json json = averaged(std::string(name), each, "", any, input);
        if (each.all.empty()) json["reason"] = reason_for(name, any, any);
        json["samples"] = each.all.size();
        summary[std::string(name)] = json;
    };
    put_of_cells(period, tank_treading_periods(cells, input));
    put_of_cells(climb, lateral_displacements(cells, input));
}

/// The same of each kind, by its name.
Json summary_of_kinds(const Table& cells, const SummaryInput& input) {
    Json kinds = Json::object();
    for (std::size_t n = 0; n < input.kinds.size(); ++n) {
        const Table some = rows_of_kind(cells, static_cast<int>(n));
        Json& kind = kinds[input.kinds[n]];
        std::set<double> numbers(some.column("cell").begin(), some.column("cell").end());
        kind["cells"] = entry(static_cast<double>(numbers.size()), "");
        summarise_cells(some, input, kind);
        for (const std::string name : {"velocity", "wall_distance"})
            kind[name] = averaged(name, gather(some, some.column(name), input), some.unit(name),
                                  some.rows() > 0, input);
        for (const char* name : stresses)
            kind[name] = averaged(name, gather(some, some.column(name), input), some.unit(name),
                                  some.rows() > 0, input);
    }
    return kinds;
}

}  // namespace

std::vector<std::string_view> summary_quantities() {
    std::vector<std::string_view> names(shapes.begin(), shapes.end());
    names.push_back(period);
    names.insert(names.end(), flows.begin(), flows.end());
    names.insert(names.end(), stresses.begin(), stresses.end());
    return names;
}

std::optional<Dimension> summary_dimension(std::string_view name) {
    const auto names = summary_quantities();
    if (std::find(names.begin(), names.end(), name) == names.end()) return std::nullopt;
    if (name == period) return Dimension{};
    const auto of_one_cell = dimension_in<CellMeasures>(name);
    return of_one_cell ? of_one_cell : dimension_in<RunMeasures>(name);
}

Json summarise(const std::filesystem::path& results, const SummaryInput& input) {
    const Table series = read_csv(results / "series.csv");
    const Table cells = read_csv(results / "cells.csv");
    const bool any = cells.rows() > 0;
    Json summary;
    const auto put = [&](const std::string& name, const Table& table,
                         const std::vector<double>& column) {
        summary[name] = averaged(name, gather(table, column, input), table.unit(name), any, input);
    };
    summarise_cells(cells, input, summary);
    if (input.kinds.size() > 1) summary["kinds"] = summary_of_kinds(cells, input);
    for (const char* name : flows) put(name, series, series.column(name));
    if (std::filesystem::exists(results / "ports.csv")) {
        const Table ports = read_csv(results / "ports.csv");
        for (const std::string& name : ports.names)
            if (name.find(".cells_") != std::string::npos)
                summary[name] = entry(ports.rows() > 0 ? ports.column(name).back() : undefined, "");
            else if (name != "time" && name != "step")
                put(name, ports, ports.column(name));
    }
    summarise_sections(
        results, input.window,
        [&](const std::string& name, const Table& table, const std::vector<double>& column) {
            return averaged(name, gather(table, column, input), table.unit(name), any, input);
        },
        summary);
    summarise_residence(results, summary);
    summary["shear_number"] =
        entry(input.shear_number.value_or(undefined), "", reason_for("shear_number", true, any));
    for (const char* name : stresses) put(name, cells, cells.column(name));
    summary["steps"] = entry(static_cast<double>(input.steps), "");
    summary["threads"] = entry(input.threads, "");
    summary["wall_seconds"] = entry(input.wall_seconds, "s");
    summary["mlups"] = entry(input.mlups, "10^6/s");
    summary["cell_steps_per_second"] = entry(input.cell_steps_per_second, "1/s");
    summary["step_us"] = step_us(input.session);
    summary["checks"] = to_json(judge(series, check_input(input)));
    return summary;
}

}  // namespace tt
