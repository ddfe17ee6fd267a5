#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "observe/checks.hpp"
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
    Window window;                       ///< of the averages
    Length dx;                           ///< site spacing
    Length mirror_height;                ///< of a channel (observe/run_measures.hpp); else NaN
    Rate shear_rate;                     ///< nominal k
    Rate held_rate;                      ///< that a controller holds; 0: none
    std::vector<std::string> kinds;      ///< names of the kinds of cells; one without a name
    bool one_way = true;                 ///< plasma goes along x, not through ports
    std::optional<double> shear_number;  ///< G (Eq. 19); nothing where it has no meaning
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
///
/// Every entry is an object with `value` and `unit`; a value that is not defined is null, with the
/// `reason`. Averages over the window have more: `mean` (the value again), its `standard_error`
/// (observe/windows.hpp), `sd_time`, the standard deviation over the looks (of the mean over cells,
/// for a quantity of cells), `sd_cells`, that over cells of the cells' time means, `min` and `max`
/// over all looks and cells, `samples`, `effective_samples`, `correlation_time` [s], `window` [s].
///
/// tank_treading_kT = k · 2π / |mean phase rate| of each cell that treads: its membrane makes at
/// least a fiftieth of a turn in the window, and its long axis stays within a quarter turn.
/// lateral_displacement = Δy/Δx of each cell within the window: the tangent of its migration angle.
/// Where there are several kinds of cells, `kinds` has what is averaged over cells for each of them
/// by its name, the number of its cells, and wall_distance: who keeps to the walls.
/// `step_us` is the mean time of a step; its `passes` are as thread 0 saw them, `outside` the time
/// spent on all else: checks, observers, files. `checks` is the list of observe/checks.hpp.
Json summarise(const std::filesystem::path& results, const SummaryInput& input);

}  // namespace tt
