#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/quantity.hpp"

namespace tt {

/// Statistics of the averaging window, for summary.json.
///
/// How to use: keep (or read back from series.csv and cells.csv) the rows with time ≥
/// window_start(…); per column call `window_statistics` on a run measure and `cell_statistics` on a
/// cell measure; write mean, scatter and standard error beside the window's start and end. Rows
/// must be evenly spaced in time. Angles are averaged as they are, so an inclination that jumps
/// between +90° and −90° needs unwrapping first. A NaN in the window makes the result NaN:
/// undefined stays undefined.

/// Start of the window: as the case asks, or half of the run.
Time window_start(Time end, std::optional<Time> average_from);

/// One quantity over the window.
struct WindowStatistics {
    std::int64_t samples = 0;
    double mean = 0.0;
    double sd = 0.0;              ///< over time, with n − 1; 0 for one sample
    double standard_error = 0.0;  ///< of the mean; NaN with less than two samples a batch
};

/// Mean, scatter, and the standard error by batch means: successive samples are correlated, so
/// sd/√n would promise too much. The window is cut into 10 batches of equal length (what is left
/// over is dropped at the start); if a batch outlasts the correlation the batch means are
/// independent, and the error is their sd/√10, itself known to 1/√18 = 24 %. Ten because more
/// batches gain little and ask for a longer window (Schmeiser, Oper. Res. 30 (1982) 556).
WindowStatistics window_statistics(std::span<const double> samples);

/// One measure of all cells over the window.
struct CellStatistics {
    std::int64_t samples = 0;     ///< times, not times × cells
    double mean = 0.0;            ///< over cells and time
    double sd_cells = 0.0;        ///< over cells of each cell's time mean: how unlike the cells are
    double sd_time = 0.0;         ///< over time of the mean over cells
    double sd_all = 0.0;          ///< over all cells and times
    double standard_error = 0.0;  ///< of the mean, by batches of the mean over cells
};

/// `table` holds one row of `cells` values per time. Precondition: its size is a multiple of
/// `cells`.
CellStatistics cell_statistics(std::span<const double> table, int cells);

/// Tank-treading period × shear rate, 2π k/|ω|, of the mean rate ω of the tank-treading phase.
double tank_treading_kT(Rate shear_rate, Rate mean_phase_rate);

}  // namespace tt
