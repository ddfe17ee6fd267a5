#include "observe/cell_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/undefined.hpp"
#include "observe/run_measures.hpp"

namespace tt {
namespace {

/// A membrane that has turned by less has not begun to tread: cells that keep to mid-channel drift
/// by some thousandths of a turn.
constexpr double fewest_turns = 0.02;

std::vector<double> inclinations_of_all(const Table& cells, const SummaryInput& input) {
    std::vector<double> angles = cells.column("inclination_deg");
    const auto& y = cells.column("y");
    const auto& time = cells.column("time");
    constexpr double doubled = std::numbers::pi / 90.0;
    double sine = 0.0, cosine = 0.0;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        angles[k] = mirrored_inclination(angles[k], y[k], input.mirror_height.si);
        if (!input.window.holds(time[k]) || !std::isfinite(angles[k])) continue;
        sine += std::sin(doubled * angles[k]);
        cosine += std::cos(doubled * angles[k]);
    }
    const double axis = std::atan2(sine, cosine) / doubled;
    for (double& angle : angles) angle -= 180.0 * std::round((angle - axis) / 180.0);
    return angles;
}

/// Did the long axis stay within a quarter turn? A cell that tumbles goes all round.
bool keeps_its_inclination(const std::vector<double>& angles) {
    double now = 0.0, low = 0.0, high = 0.0;
    for (std::size_t k = 1; k < angles.size(); ++k) {
        const double step = std::remainder(angles[k] - angles[k - 1], 180.0);
        if (std::isfinite(step)) now += step;
        low = std::min(low, now);
        high = std::max(high, now);
    }
    return high - low < 90.0;
}

}  // namespace

Samples gather(const Table& table, const std::vector<double>& column, const SummaryInput& input) {
    Samples result;
    const auto& time = table.column("time");
    const std::vector<double>* const cell = table.has("cell") ? &table.column("cell") : nullptr;
    std::vector<double> look;
    for (std::size_t k = 0; k < column.size(); ++k) {
        if (!input.window.holds(time[k])) continue;
        result.all.push_back(column[k]);
        look.push_back(column[k]);
        if (cell) {
            const auto number = static_cast<std::size_t>((*cell)[k]);
            if (result.cells.size() <= number) result.cells.resize(number + 1);
            result.cells[number].push_back(column[k]);
        }
        if (k + 1 == column.size() || time[k + 1] != time[k]) {
            result.look_means.push_back(window_statistics(look).mean);
            look.clear();
        }
    }
    return result;
}

std::vector<double> inclinations(const Table& cells, const SummaryInput& input) {
    std::vector<double> angles = inclinations_of_all(cells, input);
    const auto of_cells = gather(cells, angles, input).cells;
    if (std::none_of(of_cells.begin(), of_cells.end(), keeps_its_inclination))
        std::fill(angles.begin(), angles.end(), undefined);
    return angles;
}

Samples tank_treading_periods(const Table& cells, const SummaryInput& input) {
    const Samples rates = gather(cells, cells.column("phase_rate"), input);
    const Samples angles = gather(cells, cells.column("inclination_deg"), input);
    Samples periods;
    for (std::size_t c = 0; c < rates.cells.size(); ++c) {
        const double rate =
            std::abs(window_statistics(rates.cells[c]).mean) / (2.0 * std::numbers::pi);
        if (!(rate * input.window.length() >= fewest_turns)) continue;
        if (!keeps_its_inclination(angles.cells[c])) continue;
        periods.cells.push_back({std::abs(input.shear_rate.si) / rate});
        periods.all.push_back(periods.cells.back().front());
    }
    return periods;
}

Samples lateral_displacements(const Table& cells, const SummaryInput& input) {
    const auto x = gather(cells, cells.column("x"), input).cells;
    const auto y = gather(cells, cells.column("y"), input).cells;
    Samples slopes;
    for (std::size_t c = 0; c < x.size() && input.one_way; ++c) {
        if (x[c].empty()) continue;
        const double along = x[c].back() - x[c].front();
        if (!(std::abs(along) > 10.0 * input.dx.si)) continue;
        slopes.all.push_back((y[c].back() - y[c].front()) / along);
        slopes.cells.push_back({slopes.all.back()});
    }
    return slopes;
}

Table rows_of_kind(const Table& cells, int kind) {
    Table some = cells;
    for (std::vector<double>& column : some.columns) column.clear();
    const std::vector<double>& kinds = cells.column("kind");
    for (std::size_t row = 0; row < kinds.size(); ++row) {
        if (kinds[row] != kind) continue;
        for (std::size_t n = 0; n < cells.columns.size(); ++n)
            some.columns[n].push_back(cells.columns[n][row]);
    }
    return some;
}

}  // namespace tt
