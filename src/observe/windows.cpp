#include "observe/windows.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/contracts.hpp"

namespace tt {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t batches = 10;

double mean_of(std::span<const double> values) {
    double sum = 0.0;
    for (double v : values) sum += v;
    return values.empty() ? undefined : sum / static_cast<double>(values.size());
}

double sd_of(std::span<const double> values) {
    const double mean = mean_of(values);
    double squares = 0.0;
    for (double v : values) squares += (v - mean) * (v - mean);
    if (values.size() < 2) return values.empty() ? undefined : 0.0;
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double standard_error(std::span<const double> samples) {
    const std::size_t length = samples.size() / batches;
    if (length < 2) return undefined;
    const auto used = samples.last(length * batches);
    std::vector<double> means;
    for (std::size_t b = 0; b < batches; ++b) {
        means.push_back(mean_of(used.subspan(b * length, length)));
    }
    return sd_of(means) / std::sqrt(static_cast<double>(batches));
}

}  // namespace

Time window_start(Time end, std::optional<Time> average_from) {
    return average_from.value_or(Time{0.5 * end.si});
}

WindowStatistics window_statistics(std::span<const double> samples) {
    return {static_cast<std::int64_t>(samples.size()), mean_of(samples), sd_of(samples),
            standard_error(samples)};
}

CellStatistics cell_statistics(std::span<const double> table, int cells) {
    TT_EXPECTS(cells > 0 && table.size() % static_cast<std::size_t>(cells) == 0);
    const auto width = static_cast<std::size_t>(cells);
    const std::size_t times = table.size() / width;
    std::vector<double> of_time(times), of_cell(width, 0.0);
    for (std::size_t t = 0; t < times; ++t) {
        const auto row = table.subspan(t * width, width);
        of_time[t] = mean_of(row);
        for (std::size_t c = 0; c < width; ++c) of_cell[c] += row[c];
    }
    for (double& sum : of_cell) sum = times == 0 ? undefined : sum / static_cast<double>(times);
    return {static_cast<std::int64_t>(times),
            mean_of(of_time),
            sd_of(of_cell),
            sd_of(of_time),
            sd_of(table),
            standard_error(of_time)};
}

double tank_treading_kT(Rate shear_rate, Rate mean_phase_rate) {
    return 2.0 * std::numbers::pi * shear_rate.si / std::abs(mean_phase_rate.si);
}

}  // namespace tt
