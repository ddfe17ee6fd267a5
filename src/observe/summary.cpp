#include "observe/summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

#include "io/csv.hpp"

namespace tt {
namespace {

constexpr std::array shapes{"taylor_inertia", "taylor_extent", "inclination_deg", "strain",
                            "lambda_C"};
constexpr std::string_view period = "tank_treading_kT";
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
                           "repulsion_count"};
constexpr std::array stresses{"shear_number_star_traction", "shear_number_star_principal"};

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Mean and spread of the numbers that are numbers: a measure that is not defined at some look is
/// left out there.
struct Sample {
    std::vector<double> values;

    void add(double value) {
        if (std::isfinite(value)) values.push_back(value);
    }
    double mean() const {
        if (values.empty()) return none;
        double sum = 0.0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    }
    /// With n − 1; not defined for fewer than two.
    double deviation() const {
        if (values.size() < 2) return none;
        const double centre = mean();
        double sum = 0.0;
        for (const double value : values) sum += (value - centre) * (value - centre);
        return std::sqrt(sum / static_cast<double>(values.size() - 1));
    }
    double smallest() const {
        return values.empty() ? none : *std::min_element(values.begin(), values.end());
    }
    double largest() const {
        return values.empty() ? none : *std::max_element(values.begin(), values.end());
    }
};

/// NaN is not JSON.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json quantity(const Sample& all, const Sample& over_time, const Sample* over_cells,
              const SummaryInput& input, const std::string& unit) {
    return Json{{"mean", number(all.mean())},
                {"sd_time", number(over_time.deviation())},
                {"sd_cells", over_cells ? number(over_cells->deviation()) : Json(nullptr)},
                {"min", number(all.smallest())},
                {"max", number(all.largest())},
                {"window", {input.average_from.si, input.average_to.si}},
                {"unit", unit}};
}

bool in_window(double time, const SummaryInput& input) {
    // Times are steps · dt: the last one may exceed the end by rounding, and must not fall out.
    const double slack = 1e-9 * std::abs(input.average_to.si);
    return time >= input.average_from.si - slack && time <= input.average_to.si + slack;
}

Json of_run(const Table& series, const std::string& name, const SummaryInput& input) {
    Sample sample;
    const auto& time = series.column("time");
    const auto& column = series.column(name);
    for (std::size_t k = 0; k < column.size(); ++k) {
        if (in_window(time[k], input)) sample.add(column[k]);
    }
    return quantity(sample, sample, nullptr, input, series.unit(name));
}

/// The column `name` of cells.csv in the window, sorted by look and by cell.
struct CellSamples {
    Sample all;
    Sample look_means;
    std::vector<Sample> cells;
};

CellSamples gather(const Table& cells, const std::string& name, const SummaryInput& input) {
    CellSamples result;
    const auto& time = cells.column("time");
    const auto& cell = cells.column("cell");
    const auto& column = cells.column(name);
    Sample look;
    for (std::size_t k = 0; k < column.size(); ++k) {
        if (!in_window(time[k], input)) continue;
        result.all.add(column[k]);
        look.add(column[k]);
        const auto number = static_cast<std::size_t>(cell[k]);
        if (result.cells.size() <= number) result.cells.resize(number + 1);
        result.cells[number].add(column[k]);
        if (k + 1 == column.size() || time[k + 1] != time[k]) {
            result.look_means.add(look.mean());
            look.values.clear();
        }
    }
    return result;
}

Json of_cells(const Table& cells, const std::string& name, const SummaryInput& input) {
    const CellSamples samples = gather(cells, name, input);
    Sample means;
    for (const Sample& cell : samples.cells) means.add(cell.mean());
    return quantity(samples.all, samples.look_means, &means, input, cells.unit(name));
}

Json tank_treading(const Table& cells, const SummaryInput& input) {
    Sample periods;
    for (const Sample& cell : gather(cells, "phase_rate", input).cells) {
        periods.add(std::abs(input.shear_rate.si) * 2.0 * std::numbers::pi / std::abs(cell.mean()));
    }
    return quantity(periods, Sample{}, &periods, input, "");
}

Json split(const SessionTimes& session) {
    if (session.steps == 0) return nullptr;
    const double us = 1e6 / static_cast<double>(session.steps);
    Json split;
    double inside = 0.0;
    for (std::size_t k = 0; k < StepTimes::names.size(); ++k) {
        split[StepTimes::names[k]] = us * session.pass_seconds[k];
        inside += session.pass_seconds[k];
    }
    split["outside"] = us * (session.wall_seconds - inside);
    return split;
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
    Json summary;
    for (const char* name : shapes) summary[name] = of_cells(cells, name, input);
    summary[std::string(period)] = tank_treading(cells, input);
    for (const char* name : flows) summary[name] = of_run(series, name, input);
    summary["shear_number"] = input.shear_number ? number(*input.shear_number) : Json(nullptr);
    for (const char* name : stresses) summary[name] = of_cells(cells, name, input);
    summary["steps"] = input.steps;
    summary["threads"] = input.threads;
    summary["wall_seconds"] = input.wall_seconds;
    summary["mlups"] = number(input.mlups);
    summary["cell_steps_per_second"] = number(input.cell_steps_per_second);
    summary["step_us"] = split(input.session);
    return summary;
}

}  // namespace tt
