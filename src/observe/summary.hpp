#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "observe/measures.hpp"
#include "simulation/step_times.hpp"

namespace tt {

/// Where the time of the last session went.
struct SessionTimes {
    std::int64_t steps = 0;
    double wall_seconds = 0.0;
    std::array<double, StepTimes::names.size()> pass_seconds{};
};

/// What summary.json needs beside series.csv and cells.csv.
struct SummaryInput {
    Time average_from, average_to;       ///< the averaging window
    Rate shear_rate;                     ///< nominal k
    std::optional<double> shear_number;  ///< G (Eq. 19), null where it has no meaning
    double wall_seconds = 0.0;
    double mlups = 0.0;
    double cell_steps_per_second = 0.0;
    std::int64_t steps = 0;
    int threads = 1;
    SessionTimes session;
};

/// The quantities that have a mean and its scatter, as they are named in summary.json.
std::vector<std::string_view> summary_quantities();

/// The dimension of one of these; nothing if there is none of this name.
std::optional<Dimension> summary_dimension(std::string_view name);

/// What a paper would quote, from the tables alone, so that stopping and resuming changes nothing.
/// Each quantity is {mean, sd_time, sd_cells, min, max, window, unit}: mean over the window;
/// sd_time the standard deviation over its looks (of the mean over cells, for a quantity of cells);
/// sd_cells that over cells of the cells' time means, null for a quantity of the whole run; min and
/// max over all looks and cells in the window. tank_treading_kT = k · 2π / |mean phase rate| per
/// cell. `step_us` is the mean time of a step by pass [µs], as thread 0 saw it, and `outside` the
/// time per step spent on all else: checks, observers, files.
Json summarise(const std::filesystem::path& results, const SummaryInput& input);

}  // namespace tt
